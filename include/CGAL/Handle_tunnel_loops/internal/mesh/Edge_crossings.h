// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_EDGE_CROSSINGS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_EDGE_CROSSINGS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The loops of a `Crossing_index` that cross each edge in net numbers, added up.

Where loops cross many edges at the same vertices, that is much less than the entries there. An
edge is known at both ends, and has a number at each.
*/
class Edge_crossings
{
public:
  /// A loop that crosses an edge, as often as `number` says, from left to right.
  struct Term
  {
    Index loop;
    int number;
  };

  Edge_crossings(const Flat_mesh& mesh, const Crossing_index& index)
      : mesh_(mesh)
      , first_(mesh.number_of_vertices(), no_index) {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      if(index.has_crossing(v))
        add_edges(v, index);
    begins_.push_back(static_cast<Index>(terms_.size()));
  }

  std::size_t number_of_edges() const { return begins_.size() - 1; }

  /// the number of the edge from `v` to the first of its ring, which those to the others follow;
  /// `no_index` if no loop comes to an edge there.
  Index first_edge(Index v) const { return first_[v]; }

  Span<const Term> terms(Index edge) const {
    return {terms_.data() + begins_[edge], begins_[edge + 1] - begins_[edge]};
  }

  /// the number of the edge from `u` to `v` and 1, or of the way back and -1: looked up where there
  /// are fewer neighbours. `no_index` if nothing crosses it, for all that is known, or if `u` is
  /// `v`.
  std::pair<Index, int> edge_between(Index u, Index v) const {
    if(u == v || first_[u] == no_index || first_[v] == no_index)
      return {no_index, 0};
    const Ring at_u = mesh_.ring(u), at_v = mesh_.ring(v);
    return at_u.size() <= at_v.size() ? std::make_pair(first_[u] + at_u.position(v), 1)
                                      : std::make_pair(first_[v] + at_v.position(u), -1);
  }

  /// calls `f(loop, number)` for the loops that cross the way from `u` along an edge to `v`.
  template <typename Function> void for_each_term(Index u, Index v, const Function& f) const {
    if(const auto [edge, sign] = edge_between(u, v); edge != no_index)
      for(const Term& t : terms(edge))
        f(t.loop, sign * t.number);
  }

private:
  void add_edges(Index v, const Crossing_index& index) {
    first_[v] = static_cast<Index>(begins_.size());
    // By neighbor, and there by loop.
    entries_.assign(index.entries().begin() + index.begins()[v],
                    index.entries().begin() + index.begins()[v + 1]);
    const auto is_before = [](const Crossing_entry& a, const Crossing_entry& b) {
      return a.other < b.other;
    };
    std::stable_sort(entries_.begin(), entries_.end(), is_before);
    for(Index u : mesh_.ring(v)) {
      begins_.push_back(static_cast<Index>(terms_.size()));
      const auto [begin, end] =
          std::equal_range(entries_.begin(), entries_.end(), Crossing_entry{u, 0, 0}, is_before);
      for(auto e = begin; e != end;) {
        Term term{e->loop, 0};
        for(; e != end && e->loop == term.loop; ++e)
          term.number += e->sign;
        if(term.number != 0)
          terms_.push_back(term);
      }
    }
  }

  const Flat_mesh& mesh_;
  std::vector<Index> first_;  // edge, by vertex
  std::vector<Index> begins_; // of the terms, by edge
  std::vector<Term> terms_;
  std::vector<Crossing_entry> entries_; // of a vertex
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_EDGE_CROSSINGS_H
