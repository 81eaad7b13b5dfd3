// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_JSON_PIECES_H
#define HTLOOPS_JSON_PIECES_H

#include "mesh_types.h"
#include "text_writer.h"

#include <cmath>

namespace htloops {

/// writes a number. JSON has no infinity, which a length may reach where coordinates almost do.
inline void write_json_number(Text_writer& out, double value) {
  if(std::isfinite(value))
    out << value;
  else
    out << "null";
}

/// writes a point as an array.
inline void write_json_point(Text_writer& out, const Point& point) {
  out << '[';
  write_json_number(out, point.x());
  out << ',';
  write_json_number(out, point.y());
  out << ',';
  write_json_number(out, point.z());
  out << ']';
}

} // namespace htloops

#endif // HTLOOPS_JSON_PIECES_H
