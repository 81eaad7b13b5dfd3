// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_NEAR_POINTS_H
#define HTLOOPS_NEAR_POINTS_H

#include "mend/mending.h"
#include "mesh_types.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace htloops {

/// of some vertices, in the order of their numbers, the one that each lies at: the nearest one
/// before it that lies at no other one, is not farther away than a length, and has no edge to what
/// lies there; itself if there is none. `edges` are sorted, as `edge_key()` has them.
std::vector<std::uint32_t> nearest_before(const std::vector<Point>& points,
                                          const std::vector<std::uint32_t>& vertices,
                                          const std::vector<std::uint64_t>& edges,
                                          double length);

/// makes one vertex of those of open edges that are nearly at the same place; the first one stays
/// where it is. Throws `Failure`, naming the place, if an edge would get more than two faces.
void weld_near_points(Mended_soup& mended, double length);

/// How much of a boundary lies on other parts of it, nearly.
struct Near_boundary
{
  std::size_t edges = 0, near_edges = 0, single_triangles = 0;
  bool is_exact = true;    ///< whether what lies nearly at the same place lies just there
  const char* remedy = ""; ///< which options weld it, in words

  /// what a person is told of it; empty if there is nothing to tell.
  std::string words() const;
};

/// looks at the boundary of a mesh, within a hundred thousandth of the diagonal of its box. Takes
/// no time if there is none.
Near_boundary near_boundary_of(const Mesh& mesh);

} // namespace htloops

#endif // HTLOOPS_NEAR_POINTS_H
