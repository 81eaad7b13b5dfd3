// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "export_formats.h"
#include "loop_colours.h"

namespace htloops {

void write_lines_ply(Text_writer& out, const Pairs& pairs) {
  const std::size_t count = number_of_points(pairs); // a closed line has as many edges as points
  out << "ply\nformat ascii 1.0\ncomment handle and tunnel loops\nelement vertex " << count
      << "\nproperty double x\nproperty double y\nproperty double z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nelement edge "
      << count << "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  for_each_loop(pairs, [&out](const Loop& loop, CGAL::Loop_type type, std::size_t) {
    const auto [red, green, blue] = colour_of(type);
    for(const Point& point : loop.points())
      out << point << ' ' << int(red) << ' ' << int(green) << ' ' << int(blue) << '\n';
  });
  std::size_t first = 0;
  for_each_loop(pairs, [&](const Loop& loop, CGAL::Loop_type, std::size_t) {
    for(std::size_t i = 0; i < loop.size(); ++i)
      out << first + i << ' ' << first + (i + 1) % loop.size() << '\n';
    first += loop.size();
  });
}

} // namespace htloops
