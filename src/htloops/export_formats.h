// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_EXPORT_FORMATS_H
#define HTLOOPS_EXPORT_FORMATS_H

#include "mesh_types.h"
#include "text_writer.h"

namespace htloops {

/// the loops as vertices and edges with a colour per vertex.
void write_lines_ply(Text_writer& out, const Pairs& pairs);

/// the loops as line elements, each an object with a name.
void write_lines_obj(Text_writer& out, const Pairs& pairs);

/// the loops as CGAL writes polylines: one per line, the first point again at the end.
void write_lines_polylines(Text_writer& out, const Pairs& pairs);

/// the loops as lines of a VTK PolyData with their kind, pair and length.
void write_lines_vtp(Text_writer& out, const Pairs& pairs);

/// the number of points of all loops.
inline std::size_t number_of_points(const Pairs& pairs) {
  std::size_t count = 0;
  for_each_loop(pairs,
                [&count](const Loop& loop, CGAL::Loop_type, std::size_t) { count += loop.size(); });
  return count;
}

/// writes the coordinates of a point, with blanks between them.
inline Text_writer& operator<<(Text_writer& out, const Point& point) {
  return out << point.x() << ' ' << point.y() << ' ' << point.z();
}

} // namespace htloops

#endif // HTLOOPS_EXPORT_FORMATS_H
