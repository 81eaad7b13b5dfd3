// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_POLYGON_TRIANGULATION_H
#define HTLOOPS_POLYGON_TRIANGULATION_H

#include "mend/polygons.h"

#include <array>
#include <functional>
#include <vector>

namespace htloops {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// makes triangles of a polygon of four or more corners, convex or not, plane or about so; always
/// as many as it has corners but two. `is_free(u, v)` says whether a diagonal may join two
/// vertices: if it can be, there are only such. Decisions are exact, so the result is always the
/// same.
Triangles triangulate_polygon(const std::vector<Point>& points,
                              const Corners& corners,
                              const std::function<bool(std::uint32_t, std::uint32_t)>& is_free);

} // namespace htloops

#endif // HTLOOPS_POLYGON_TRIANGULATION_H
