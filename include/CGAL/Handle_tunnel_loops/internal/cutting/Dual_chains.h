// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_DUAL_CHAINS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_DUAL_CHAINS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Unimodular_system.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Edge_crossings.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sparse_sum.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The chains of edges dual to a basis of the first homology group of a surface: chain j crosses loop j
of the basis once and no other, counted with sign. Together they are a basis of the group relative
to the boundary (Lefschetz duality).

The edges of a cut to disks, with those to the hubs, are a graph. Where the hubs of a component are
taken as one vertex, its cycles, one for each edge outside of a spanning tree, are such a basis, and
as many. The matrix of the numbers in which they cross the loops is unimodular, and the chains that
are asked for are the combinations of cycles by its inverse. All in integers.
*/
class Dual_chains
{
public:
  /// By halfedge, sorted, to hubs as well: how often the chain runs along it.
  using Chain = Class_vector;

  /// \p cut are halfedges of the cut, one of each edge.
  Dual_chains(const Cut_problem& problem, const std::vector<Index>& cut)
      : problem_(problem)
      , edges_(problem.mesh.number_of_vertices())
      , way_(problem.mesh.number_of_vertices(), no_index)
      , place_(problem.mesh.number_of_vertices(), no_index) {
    for(const Index h : cut) {
      edges_[halfedges().source(h)].push_back(h);
      edges_[halfedges().target(h)].push_back(halfedges().twin(h));
    }
    grow_trees();
    for(const Index h : cut)
      if(way_[halfedges().target(h)] != h && way_[halfedges().source(h)] != halfedges().twin(h))
        cycles_.push_back(h);
  }

  /// throws `std::invalid_argument` if the loops are no basis.
  std::vector<Chain> dual_to(const std::vector<Crossing_loop>& loops) const {
    const Edge_crossings crossings(Execution(), problem_.mesh,
                                   Crossing_index(problem_.mesh, loops));
    Sparse_sum<std::int64_t> numbers;
    std::vector<Class_vector> rows(loops.size()); // by loop, how often cycles cross it
    for(Index i = 0; i < cycles_.size(); ++i) {
      for(const auto& [h, times] : cycle(cycles_[i])) {
        const std::int64_t factor = times;
        crossings.for_each_term(
            halfedges().source(h), halfedges().target(h),
            [&](Index loop, int number) { numbers.add(loop, factor * number); });
      }
      numbers.take([&](Index loop, std::int64_t number) { rows[loop].emplace_back(i, number); });
    }
    if(loops.size() != cycles_.size())
      throw std::invalid_argument("the number of loops is not that of a basis");
    const Unimodular_system system(std::move(rows));
    std::vector<Chain> chains;
    std::vector<std::int64_t> flow(order_.size(), 0);
    for(Index j = 0; j < loops.size(); ++j)
      chains.push_back(
          combination(system.is_regular() ? system.solve({{j, 1}}) : std::nullopt, flow));
    return chains;
  }

private:
  const Flat_halfedges& halfedges() const { return problem_.halfedges; }

  // From the hubs of each component, or else from any vertex of its cut.
  void grow_trees() {
    const Flat_mesh& mesh = problem_.mesh;
    const auto start = [&](Index v) {
      place_[v] = static_cast<Index>(order_.size());
      order_.push_back(v);
    };
    std::size_t grown = 0;
    const auto grow = [&] {
      for(; grown < order_.size(); ++grown)
        for(const Index h : edges_[order_[grown]])
          if(const Index v = halfedges().target(h); place_[v] == no_index) {
            way_[v] = h;
            start(v);
          }
    };
    for(Index i = 0; i < mesh.number_of_hubs; ++i)
      start(mesh.first_hub + i);
    grow();
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      if(place_[v] == no_index && !edges_[v].empty()) {
        start(v);
        grow();
      }
  }

  // Of an edge outside of the trees: from its target back to its source on the ways through the
  // root.
  Chain cycle(Index h) const {
    Chain cycle;
    add(h, 1, cycle);
    add_way_to(halfedges().source(h), 1, cycle);
    add_way_to(halfedges().target(h), -1, cycle);
    normalize(cycle);
    return cycle;
  }

  // Under the smaller halfedge of the edge.
  void add(Index h, std::int64_t times, Chain& chain) const {
    const Index twin = halfedges().twin(h);
    chain.emplace_back((std::min)(h, twin), h < twin ? times : -times);
  }

  void add_way_to(Index v, int times, Chain& chain) const {
    for(; way_[v] != no_index; v = halfedges().source(way_[v]))
      add(way_[v], times, chain);
  }

  // Of cycles: what they take from the trees at both ends of their edges flows to the roots, from
  // the vertices that were reached last on, so that no edge is looked at for each cycle along it.
  // \p flow, by place in the order of vertices, is zero before and after.
  Chain combination(const std::optional<Class_vector>& factors,
                    std::vector<std::int64_t>& flow) const {
    if(!factors)
      throw std::invalid_argument("the loops are not a basis");
    Chain chain;
    std::priority_queue<Index> places;
    const auto add_flow = [&](Index v, std::int64_t times) {
      flow[place_[v]] += times;
      places.push(place_[v]);
    };
    for(const auto& [i, factor] : *factors) {
      add(cycles_[i], factor, chain);
      add_flow(halfedges().source(cycles_[i]), factor);
      add_flow(halfedges().target(cycles_[i]), -factor);
    }
    while(!places.empty()) {
      const Index place = places.top(), way = way_[order_[place]];
      places.pop();
      const std::int64_t times = std::exchange(flow[place], 0);
      if(times != 0 && way != no_index) {
        add(way, times, chain);
        add_flow(halfedges().source(way), times);
      }
    }
    normalize(chain);
    if(std::any_of(chain.begin(), chain.end(),
                   [](const auto& c) { return is_too_large(c.second); }))
      throw std::invalid_argument("the loops cross each other too often");
    return chain;
  }

  const Cut_problem& problem_;
  std::vector<std::vector<Index>> edges_; // of the cut, by vertex at which they begin, both ways
  std::vector<Index> way_;                // the halfedge by which a tree comes to a vertex
  std::vector<Index> order_, place_;      // vertices as trees reach them, and by vertex where there
  std::vector<Index> cycles_;             // their edges outside of the trees
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_DUAL_CHAINS_H
