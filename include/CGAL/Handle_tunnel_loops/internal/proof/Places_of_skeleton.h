// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_PLACES_OF_SKELETON_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_PLACES_OF_SKELETON_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Inlets.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Skeleton_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Solid_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds out which component each part of a skeleton belongs to, and which of its leaves are inlets,
from where they are alone; what is known already stays.

A part may lie in several components at once, one within the other. Those that hold the fewest parts
choose first, the part that the fewest hold; the parts that are left belong to the innermost one
that holds them, which holds the fewest.
*/
class Places_of_skeleton
{
public:
  /// The arrays must outlive it.
  Places_of_skeleton(Execution execution, const Flat_mesh& mesh, const std::vector<Vector>& places)
      : mesh_(mesh)
      , places_(places)
      , tree_(execution, mesh, span_of(places)) {}

  void find(Flat_skeleton& skeleton) const {
    if(skeleton.component_of.empty())
      find_components(skeleton);
    if(skeleton.is_inlet.empty())
      find_inlets(skeleton);
  }

private:
  void find_components(Flat_skeleton& skeleton) const {
    const Skeleton_cycles cycles(skeleton);
    const std::vector<Index> component = components_of_parts(skeleton, cycles);
    for(Index p = 0; p < skeleton.points.size(); ++p)
      skeleton.component_of.push_back(component[cycles.part_of(p)]);
  }

  std::vector<Index> components_of_parts(const Flat_skeleton& skeleton,
                                         const Skeleton_cycles& cycles) const {
    const std::size_t n = cycles.parts().size();
    std::vector<Index> component(n, 0);
    if(mesh_.seeds.size() == 1)
      return component;
    const std::vector<std::vector<Index>> holders = holders_of_parts(skeleton, cycles);
    std::vector<std::vector<Index>> held(mesh_.seeds.size()); // parts, by component
    for(Index part = 0; part < n; ++part)
      for(Index c : holders[part])
        held[c].push_back(part);
    std::vector<Index> order(held.size());
    std::iota(order.begin(), order.end(), Index(0));
    const auto holds_fewer = [&](Index a, Index b) { return held[a].size() < held[b].size(); };
    std::stable_sort(order.begin(), order.end(), holds_fewer);
    std::vector<char> is_taken(n, 0);
    for(Index c : order) {
      Index best = no_index;
      for(Index part : held[c])
        if(!is_taken[part] && (best == no_index || holders[part].size() < holders[best].size()))
          best = part;
      if(best != no_index) {
        component[best] = c;
        is_taken[best] = 1;
      }
    }
    for(Index part = 0; part < n; ++part)
      if(!is_taken[part] && !holders[part].empty())
        component[part] =
            *std::min_element(holders[part].begin(), holders[part].end(), holds_fewer);
    return component;
  }

  // The components that hold the first point of each part that any holds.
  std::vector<std::vector<Index>> holders_of_parts(const Flat_skeleton& skeleton,
                                                   const Skeleton_cycles& cycles) const {
    std::vector<std::vector<Index>> holders(cycles.parts().size());
    for(Index p = 0; p < skeleton.points.size(); ++p)
      if(std::vector<Index>& known = holders[cycles.part_of(p)]; known.empty())
        known = components_that_hold(skeleton.points[p], mesh_, tree_);
    return holders;
  }

  void find_inlets(Flat_skeleton& skeleton) const {
    skeleton.is_inlet.assign(skeleton.points.size(), 0);
    std::vector<Index> degree(skeleton.points.size(), 0);
    for(const auto& edge : skeleton.edges)
      for(Index p : edge)
        ++degree[p];
    for(Index p = 0; p < skeleton.points.size(); ++p)
      if(degree[p] == 1)
        skeleton.is_inlet[p] = Inlets::hub_at(mesh_, places_, skeleton.points[p],
                                              skeleton.component_of[p]) != no_index;
  }

  const Flat_mesh& mesh_;
  const std::vector<Vector>& places_;
  Face_tree tree_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_PLACES_OF_SKELETON_H
