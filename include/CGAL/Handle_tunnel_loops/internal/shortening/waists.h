// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WAISTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WAISTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_lengths.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Waist_search.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the boundary curve around a hub, the surface to its left.
inline Crossing_loop boundary_curve(const Flat_mesh& mesh, Index hub) {
  const Ring ring = mesh.ring(hub);
  Crossing_loop loop;
  for(Index p = ring.size(); p-- > 0;)
    loop.push_back({ring[p], hub, 0.});
  return loop;
}

/// the curve a little inside of the surface. It enters no cap.
inline Crossing_loop beside_boundary(const Flat_mesh& mesh, Index hub) {
  const Ring ring = mesh.ring(hub);
  std::vector<Index> walk(ring.begin(), ring.end());
  std::reverse(walk.begin(), walk.end());
  return pushed_left(mesh, walk);
}

/// adds, of the boundary curves of each component, all but the last.
inline void add_boundaries_of_basis(const Flat_mesh& mesh, std::vector<Crossing_loop>& loops) {
  std::vector<Index> last(mesh.seeds.size(), no_index);
  const Index end = mesh.first_hub + mesh.number_of_hubs;
  for(Index hub = mesh.first_hub; hub < end; ++hub)
    last[mesh.component[hub]] = hub;
  for(Index hub = mesh.first_hub; hub < end; ++hub)
    if(last[mesh.component[hub]] != hub)
      loops.push_back(beside_boundary(mesh, hub));
}

/// a short loop that is homologous to the curve around a hub on the surface, without any cap: the
/// shortest one that is found, tightened, or else the curve tightened; or the curve itself where
/// that is a point. These begin beside the curve, and loops enter no cap.
inline Crossing_loop waist(const Flat_mesh& mesh, Index hub, Waist_search& search) {
  Crossing_loop best = boundary_curve(mesh, hub), tightened = beside_boundary(mesh, hub);
  Loop_tightening tightening(mesh);
  const auto take_if_shorter = [&](Crossing_loop& loop) {
    tightening.tighten(loop);
    if(!loop.empty() && is_shorter(mesh, loop, best))
      best = std::move(loop);
  };
  take_if_shorter(tightened);
  Crossing_loop found = search(hub, length(mesh, best));
  take_if_shorter(found);
  return best;
}

/// the same the other way around.
inline Crossing_loop reversed(const Crossing_loop& loop) {
  Crossing_loop result;
  for(std::size_t i = loop.size(); i-- > 0;)
    result.push_back({loop[i].right, loop[i].left, 1. - loop[i].ratio});
  return result;
}

/// where a component has two boundary curves, these are homologous but for the sense: of both
/// waists the shorter one serves.
inline void share_waists(const Flat_mesh& mesh, std::vector<Crossing_loop>& waists) {
  std::vector<std::vector<Index>> curves(mesh.seeds.size());
  for(Index i = 0; i < mesh.number_of_hubs; ++i)
    curves[mesh.component[mesh.first_hub + i]].push_back(i);
  for(const std::vector<Index>& both : curves)
    if(both.size() == 2) {
      Crossing_loop &a = waists[both[0]], &b = waists[both[1]];
      if(is_shorter(mesh, b, a))
        a = reversed(b);
      else
        b = reversed(a);
    }
}

/// the waists of all boundary curves.
inline std::vector<Crossing_loop> waists(Execution execution, const Flat_mesh& mesh) {
  Workspace_pool<Waist_search> searches([&mesh] { return std::make_unique<Waist_search>(mesh); });
  std::vector<Crossing_loop> loops(mesh.number_of_hubs);
  for_each_index(
      execution, loops.size(),
      [&](std::size_t i) {
        loops[i] = waist(mesh, mesh.first_hub + static_cast<Index>(i), *searches.borrow());
      },
      1);
  share_waists(mesh, loops);
  return loops;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_WAISTS_H
