// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_MEASURE_PARTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_MEASURE_PARTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/depths_in_parts.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/length_across.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Arc_contraction.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// a third of the faces at a vertex, with or without those of caps.
inline double area_around(const Flat_mesh& mesh, Index v, bool has_caps = true) {
  const Ring ring = mesh.ring(v);
  double sum = 0.;
  for(Index p = 0; p < ring.size(); ++p) {
    const Index a = ring[p], b = ring[ring.next(p)];
    if(has_caps || !mesh.is_spoke(a, b))
      sum += norm(cross(mesh.points[a] - mesh.points[v], mesh.points[b] - mesh.points[v]));
  }
  return sum / 6.;
}

/// by vertex, whether it is in the inner half of its part, by its depth there.
inline std::vector<char> inner_halves(const Flat_mesh& mesh, const std::vector<Index>& part) {
  const std::vector<Index> depths = depths_in_parts(mesh, part, [](Index) { return true; });
  std::vector<Index> deepest(part.size(), 0); // by part, of which there are no more
  for(Index v = 0; v < part.size(); ++v)
    deepest[part[v]] = (std::max)(deepest[part[v]], depths[v]);
  std::vector<char> is_inner(part.size());
  for(Index v = 0; v < part.size(); ++v)
    is_inner[v] = 2 * depths[v] > deepest[part[v]];
  return is_inner;
}

/// along how much the parts of a surface meet.
inline std::vector<Shared_border> shared_borders(const Flat_mesh& mesh,
                                                 const std::vector<Index>& part_of_vertex) {
  std::map<std::array<Index, 2>, double> lengths;
  for(Index v = 0; v < part_of_vertex.size(); ++v)
    for(const Index u : mesh.ring(v))
      if(part_of_vertex[v] < part_of_vertex[u])
        lengths[{part_of_vertex[v], part_of_vertex[u]}] += length_across(mesh, v, u);
  std::vector<Shared_border> borders;
  for(const auto& [parts, length] : lengths)
    borders.push_back({parts[0], parts[1], length});
  return borders;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_MEASURE_PARTS_H
