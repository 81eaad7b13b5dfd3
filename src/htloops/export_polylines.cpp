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

void write_lines_polylines(Text_writer& out, const Pairs& pairs) {
  for_each_loop(pairs, [&out](const Loop& loop, CGAL::Loop_type, std::size_t) {
    out << loop.size() + 1;
    for(const Point& point : loop.points())
      out << ' ' << point;
    out << ' ' << loop.points().front() << '\n';
  });
}

} // namespace htloops
