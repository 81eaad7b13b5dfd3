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

void write_lines_obj(Text_writer& out, const Pairs& pairs) {
  out << "# handle and tunnel loops\n";
  std::size_t first = 1;
  for_each_loop(pairs, [&](const Loop& loop, CGAL::Loop_type type, std::size_t pair) {
    out << "o " << name_of(type) << '_' << pair << '\n';
    for(const Point& point : loop.points())
      out << "v " << point << '\n';
    out << 'l';
    for(std::size_t i = 0; i < loop.size(); ++i)
      out << ' ' << first + i;
    out << ' ' << first << '\n';
    first += loop.size();
  });
}

} // namespace htloops
