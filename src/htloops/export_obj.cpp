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

void write_lines_obj(Text_writer& out, const Exported_lines& lines) {
  out << "# " << lines.title << '\n';
  std::size_t first = 1;
  for(const Exported_line& line : lines.lines) {
    out << "o " << line.kind << '_' << line.index << '\n';
    for(const Point& point : line.points)
      out << "v " << point << '\n';
    out << 'l';
    for(std::size_t i = 0; i < line.points.size(); ++i)
      out << ' ' << first + i;
    if(line.is_closed)
      out << ' ' << first;
    out << '\n';
    first += line.points.size();
  }
}

} // namespace htloops
