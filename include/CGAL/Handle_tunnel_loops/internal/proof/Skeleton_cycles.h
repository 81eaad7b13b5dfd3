// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SKELETON_CYCLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SKELETON_CYCLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Edges_at.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The connected parts of a skeleton, and in each the cycles that an edge makes together with the
/// tree of shortest ways, in numbers of edges, from one of its points: a basis of all cycles.
class Skeleton_cycles
{
public:
  /// An edge of a cycle, and the sense in which the cycle passes it: 1 from its first end.
  using Step = std::pair<Index, int>;
  using Cycle = std::vector<Step>;

  /// What is said of one part.
  struct Part
  {
    Index first; ///< one of its points
    std::vector<Cycle> cycles;
  };

  /// The skeleton must outlive it.
  explicit Skeleton_cycles(const Flat_skeleton& skeleton)
      : skeleton_(skeleton)
      , edges_at_(skeleton.points.size(), skeleton.edges)
      , part_of_(skeleton.points.size(), no_index)
      , to_root_(skeleton.points.size(), no_index)
      , depth_(skeleton.points.size(), 0) {
    for(Index p = 0; p < part_of_.size(); ++p)
      if(part_of_[p] == no_index)
        grow_tree(p);
    for(Index e = 0; e < skeleton.edges.size(); ++e)
      if(const auto [p, q] = skeleton.edges[e]; to_root_[p] != e && to_root_[q] != e)
        parts_[part_of_[p]].cycles.push_back(cycle_with(e));
  }

  const std::vector<Part>& parts() const { return parts_; }

  /// the number of the part that a point belongs to.
  Index part_of(Index point) const { return part_of_[point]; }

private:
  Index other_end(Index e, Index p) const {
    const auto& edge = skeleton_.edges[e];
    return edge[0] == p ? edge[1] : edge[0];
  }

  void grow_tree(Index root) {
    const auto number = static_cast<Index>(parts_.size());
    parts_.push_back({root, {}});
    part_of_[root] = number;
    std::vector<Index> queue = {root};
    for(std::size_t i = 0; i < queue.size(); ++i)
      for(Index e : edges_at_[queue[i]])
        if(const Index p = other_end(e, queue[i]); part_of_[p] == no_index) {
          part_of_[p] = number;
          to_root_[p] = e;
          depth_[p] = depth_[queue[i]] + 1;
          queue.push_back(p);
        }
  }

  // Along the edge, and back through the tree.
  Cycle cycle_with(Index e) const {
    Cycle cycle = {{e, 1}};
    auto [p, q] = skeleton_.edges[e];
    const auto climb = [&](Index& from, bool is_ahead) {
      const Index step = to_root_[from];
      cycle.emplace_back(step, (skeleton_.edges[step][0] == from) == is_ahead ? 1 : -1);
      from = other_end(step, from);
    };
    while(p != q)
      if(depth_[q] >= depth_[p])
        climb(q, true);
      else
        climb(p, false);
    return cycle;
  }

  const Flat_skeleton& skeleton_;
  Edges_at edges_at_;          // by point
  std::vector<Index> part_of_; // by point
  std::vector<Index> to_root_; // by point, an edge
  std::vector<Index> depth_;   // by point
  std::vector<Part> parts_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SKELETON_CYCLES_H
