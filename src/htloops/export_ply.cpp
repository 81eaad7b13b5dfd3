// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "export_formats.h"

namespace htloops {

void write_lines_ply(Text_writer& out, const Exported_lines& lines) {
  out << "ply\nformat ascii 1.0\ncomment " << lines.title << "\nelement vertex "
      << lines.number_of_points()
      << "\nproperty double x\nproperty double y\nproperty double z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nelement edge "
      << lines.number_of_edges() << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for(const Exported_line& line : lines.lines) {
    const auto [red, green, blue] = line.colour;
    for(const Point& point : line.points)
      out << point << ' ' << int(red) << ' ' << int(green) << ' ' << int(blue) << '\n';
  }
  std::size_t first = 0;
  for(const Exported_line& line : lines.lines) {
    for(std::size_t i = 0; i < line.number_of_edges(); ++i)
      out << first + i << ' ' << first + (i + 1) % line.points.size() << '\n';
    first += line.points.size();
  }
}

} // namespace htloops
