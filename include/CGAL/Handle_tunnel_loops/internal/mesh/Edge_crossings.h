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
#include <CGAL/Handle_tunnel_loops/internal/mesh/Vertex_subset.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sparse_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The loops of a `Crossing_index` that cross each edge in net numbers, added up.

Where loops cross many edges at the same vertices, that is much less than the entries there. An
edge is known at both ends, and has a number at each. After the edges of a vertex comes a number
that is of none, with terms that are zero: so all edges can be added up at the same time.
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

  Edge_crossings(Execution execution, const Flat_mesh& mesh, const Crossing_index& index)
      : mesh_(mesh)
      , vertices_(index.vertices())
      , first_(vertices_.size())
      , terms_(index.entries().size()) {
    const std::vector<Index> vertices = vertices_.vertices();
    for_each_index(execution, first_.size(),
                   [&](std::size_t i) { first_[i] = mesh.ring(vertices[i]).size() + 1; });
    begins_.resize(sum_before_each(execution, first_) + 1);
    begins_.back() = static_cast<Index>(terms_.size());
    execution.for_ranges(first_.size(), 4096, [&](std::size_t begin, std::size_t end) {
      std::vector<Crossing_entry> entries;
      for(std::size_t i = begin; i < end; ++i)
        add_edges(vertices[i], static_cast<Index>(i), index, entries);
    });
  }

  std::size_t number_of_edges() const { return begins_.size() - 1; }

  /// the number of the edge from `v` to the first of its ring, which those to the others follow;
  /// `no_index` if no loop comes to an edge there.
  Index first_edge(Index v) const {
    return vertices_.contains(v) ? first_[vertices_.number_before(v)] : no_index;
  }

  Span<const Term> terms(Index edge) const {
    return {terms_.data() + begins_[edge], begins_[edge + 1] - begins_[edge]};
  }

  /// the number of the edge from `u` to `v` and 1, or of the way back and -1: looked up where there
  /// are fewer neighbours. `no_index` if nothing crosses it, for all that is known, or if `u` is
  /// `v`.
  std::pair<Index, int> edge_between(Index u, Index v) const {
    if(u == v || !vertices_.contains(u) || !vertices_.contains(v))
      return {no_index, 0};
    const Ring at_u = mesh_.ring(u), at_v = mesh_.ring(v);
    return at_u.size() <= at_v.size() ? std::make_pair(first_edge(u) + at_u.position(v), 1)
                                      : std::make_pair(first_edge(v) + at_v.position(u), -1);
  }

  /// calls `f(loop, number)` for the loops that cross the way from `u` along an edge to `v`.
  template <typename Function> void for_each_term(Index u, Index v, const Function& f) const {
    if(const auto [edge, sign] = edge_between(u, v); edge != no_index)
      for(const Term& t : terms(edge))
        f(t.loop, sign * t.number);
  }

  /// the intersection numbers of a closed curve with the loops, without zeros, by loop.
  std::vector<std::pair<Index, std::int64_t>> numbers(const Crossing_loop& curve,
                                                      Sparse_sum<std::int64_t>& sum) const {
    for_each_left_edge(curve, [&](Index u, Index v) {
      for_each_term(u, v, [&](Index loop, int number) { sum.add(loop, number); });
    });
    std::vector<std::pair<Index, std::int64_t>> numbers;
    sum.take([&](Index loop, std::int64_t number) { numbers.emplace_back(loop, number); });
    return numbers;
  }

private:
  // Those of vertex `v`, which is the i-th that has a crossing. There are no more terms than
  // entries.
  void
  add_edges(Index v, Index i, const Crossing_index& index, std::vector<Crossing_entry>& entries) {
    // By neighbor, and there by loop.
    const Index first_place = index.begins()[i], last_place = index.begins()[i + 1];
    entries.assign(index.entries().begin() + first_place, index.entries().begin() + last_place);
    const auto is_before = [](const Crossing_entry& a, const Crossing_entry& b) {
      return a.other < b.other;
    };
    std::stable_sort(entries.begin(), entries.end(), is_before);
    Index edge = first_[i], place = first_place;
    for(Index u : mesh_.ring(v)) {
      begins_[edge++] = place;
      const auto [begin, end] =
          std::equal_range(entries.begin(), entries.end(), Crossing_entry{u, 0, 0}, is_before);
      for(auto e = begin; e != end;) {
        Term term{e->loop, 0};
        for(; e != end && e->loop == term.loop; ++e)
          term.number += e->sign;
        if(term.number != 0)
          terms_[place++] = term;
      }
    }
    begins_[edge] = place;
    std::fill(terms_.begin() + place, terms_.begin() + last_place, Term{0, 0});
  }

  const Flat_mesh& mesh_;
  Vertex_subset vertices_;             // that have a crossing
  Uninitialized_vector<Index> first_;  // edge, by vertex of these
  Uninitialized_vector<Index> begins_; // of the terms, by edge
  Uninitialized_vector<Term> terms_;   // those of a vertex from where its entries are
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_EDGE_CROSSINGS_H
