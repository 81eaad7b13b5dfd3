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

#include "exported_lines.h"
#include "text_writer.h"

namespace htloops {

/// the lines as vertices and edges with a colour per vertex.
void write_lines_ply(Text_writer& out, const Exported_lines& lines);

/// the lines as line elements, each an object with a name.
void write_lines_obj(Text_writer& out, const Exported_lines& lines);

/// the lines as CGAL writes polylines: one per line, of a closed one the first point again at the
/// end.
void write_lines_polylines(Text_writer& out, const Exported_lines& lines);

/// the lines as lines of a VTK PolyData with their kind, index and length.
void write_lines_vtp(Text_writer& out, const Exported_lines& lines);

/// writes the coordinates of a point, with blanks between them.
inline Text_writer& operator<<(Text_writer& out, const Point& point) {
  return out << point.x() << ' ' << point.y() << ' ' << point.z();
}

} // namespace htloops

#endif // HTLOOPS_EXPORT_FORMATS_H
