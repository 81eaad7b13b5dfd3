// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SEGMENTS_APART_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SEGMENTS_APART_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Exact_meeting.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Finds edges of a skeleton that meet other than in a common end, and points without edges that
/// lie on edges or on each other: these count as edges from a point to itself.
class Segments_apart
{
public:
  using Edge = std::array<Index, 2>;
  using Pair_of_edges = std::pair<Edge, Edge>;

  /// The skeleton must outlive it.
  explicit Segments_apart(const Flat_skeleton& skeleton)
      : skeleton_(skeleton)
      , edges_(skeleton.edges) {
    std::vector<char> has_edge(skeleton.points.size(), 0);
    for(const Edge& edge : edges_)
      has_edge[edge[0]] = has_edge[edge[1]] = 1;
    for(Index p = 0; p < has_edge.size(); ++p)
      if(!has_edge[p])
        edges_.push_back({p, p});
  }

  /// edges whose ends lie at one place.
  std::vector<Edge> edges_without_length() const {
    std::vector<Edge> found;
    for(const Edge& edge : skeleton_.edges)
      if(has_no_length(edge))
        found.push_back(edge);
    return found;
  }

  /// pairs of edges that meet, in the order of the edges: of each the first few.
  std::vector<Pair_of_edges> edges_that_meet(Execution execution) const {
    const Uninitialized_vector<Index> numbers = order(execution);
    std::vector<Box<3>> boxes(edges_.size());
    for(std::size_t i = 0; i < boxes.size(); ++i)
      boxes[i] = box(edges_[numbers[i]]);
    const Box_tree<3> tree(std::move(boxes));
    return collect<Pair_of_edges>(
        execution, edges_.size(),
        [&](std::size_t begin, std::size_t end) {
          std::vector<Pair_of_edges> found;
          for(Index e = static_cast<Index>(begin); e < end; ++e)
            for(Index other : later_edges_that_meet(e, tree, numbers))
              found.emplace_back(edges_[e], edges_[other]);
          return found;
        },
        256);
  }

private:
  const Vector& point(Index p) const { return skeleton_.points[p]; }

  bool has_no_length(const Edge& edge) const { return point(edge[0]) == point(edge[1]); }

  Exact_segment exact_segment(const Edge& edge) const {
    return {exact_point(point(edge[0])), exact_point(point(edge[1]))};
  }

  Box<3> box(const Edge& edge) const { return box_around(point(edge[0]), point(edge[1])); }

  // Along a space-filling curve, by their first ends.
  Uninitialized_vector<Index> order(Execution execution) const {
    Box<3> all = Box<3>::empty();
    for(const Vector& p : skeleton_.points)
      all.extend({p, p});
    return space_filling_order(execution, edges_.size(), [&](std::size_t e) {
      const Vector& p = point(edges_[e][0]);
      return Vector{all.part(0, p[0]), all.part(1, p[1]), all.part(2, p[2])};
    });
  }

  std::vector<Index> later_edges_that_meet(Index e,
                                           const Box_tree<3>& tree,
                                           const Uninitialized_vector<Index>& numbers) const {
    constexpr std::size_t enough = 4;
    std::vector<Index> found;
    tree.any_meeting(box(edges_[e]), [&](Index i, const Box<3>&) {
      if(numbers[i] > e && meet(edges_[e], edges_[numbers[i]]))
        found.push_back(numbers[i]);
      return found.size() == enough;
    });
    std::sort(found.begin(), found.end());
    return found;
  }

  bool meet(const Edge& e, const Edge& f) const {
    for(int i = 0; i < 2; ++i)
      for(int j = 0; j < 2; ++j)
        if(e[i] == f[j])
          return !has_no_length(e) && !has_no_length(f) &&
                 do_overlap(exact_point(point(e[i])), exact_point(point(e[1 - i])),
                            exact_point(point(f[1 - j])));
    return do_meet(exact_segment(e), exact_segment(f));
  }

  const Flat_skeleton& skeleton_;
  std::vector<Edge> edges_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SEGMENTS_APART_H
