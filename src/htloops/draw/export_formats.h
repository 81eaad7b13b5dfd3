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

#include "draw/exported_lines.h"
#include "write/text_writer.h"

namespace htloops {

/// the lines as lines of a VTK PolyData with their kind, index and length.
void write_lines_vtp(Text_writer& out, const Exported_lines& lines);

/// writes the coordinates of a point, with blanks between them.
inline Text_writer& operator<<(Text_writer& out, const Point& point) {
  return out << point.x() << ' ' << point.y() << ' ' << point.z();
}

} // namespace htloops

#endif // HTLOOPS_EXPORT_FORMATS_H
