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

void write_lines_polylines(Text_writer& out, const Exported_lines& lines) {
  for(const Exported_line& line : lines.lines) {
    out << line.number_of_edges() + 1;
    for(const Point& point : line.points)
      out << ' ' << point;
    if(line.is_closed)
      out << ' ' << line.points.front();
    out << '\n';
  }
}

} // namespace htloops
