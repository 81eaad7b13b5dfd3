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

#include <algorithm>
#include <cstddef>
#include <optional>
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
      , cut_(cut)
      , edges_(problem.mesh.number_of_vertices())
      , way_(problem.mesh.number_of_vertices(), no_index)
      , is_reached_(problem.mesh.number_of_vertices(), 0) {
    for(const Index h : cut) {
      edges_[halfedges().source(h)].push_back(h);
      edges_[halfedges().target(h)].push_back(halfedges().twin(h));
    }
    grow_trees();
    find_cycles();
  }

  /// throws `std::invalid_argument` if the loops are no basis.
  std::vector<Chain> dual_to(const std::vector<Crossing_loop>& loops) const {
    const Crossing_index index(problem_.mesh, loops);
    std::vector<Class_vector> rows(loops.size()); // by loop, how often cycles cross it
    for(Index i = 0; i < cycles_.size(); ++i) {
      Sparse_numbers numbers;
      for(const auto& [h, times] : cycles_[i]) {
        Sparse_numbers of_edge;
        index.add_crossings(halfedges().source(h), halfedges().target(h), of_edge);
        for(const auto& [loop, number] : of_edge)
          numbers[loop] += times * number;
      }
      for(const auto& [loop, number] : numbers)
        if(number != 0)
          rows[loop].emplace_back(i, number);
    }
    if(loops.size() != cycles_.size())
      throw std::invalid_argument("the loops are not as many as a basis has");
    const Unimodular_system system(std::move(rows));
    std::vector<Chain> chains;
    for(Index j = 0; j < loops.size(); ++j)
      chains.push_back(combination(system.is_regular() ? system.solve({{j, 1}}) : std::nullopt));
    return chains;
  }

private:
  const Flat_halfedges& halfedges() const { return problem_.halfedges; }

  // From the hubs of each component, or else from any vertex of its cut.
  void grow_trees() {
    const Flat_mesh& mesh = problem_.mesh;
    std::vector<Index> queue;
    const auto start = [&](Index v) {
      is_reached_[v] = 1;
      queue.push_back(v);
    };
    const auto grow = [&] {
      for(std::size_t i = 0; i < queue.size(); ++i)
        for(const Index h : edges_[queue[i]])
          if(const Index v = halfedges().target(h); !is_reached_[v]) {
            way_[v] = h;
            start(v);
          }
      queue.clear();
    };
    for(Index i = 0; i < mesh.number_of_hubs; ++i)
      start(mesh.first_hub + i);
    grow();
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      if(!is_reached_[v] && !edges_[v].empty()) {
        start(v);
        grow();
      }
  }

  void find_cycles() {
    for(const Index h : cut_) {
      const Index u = halfedges().source(h), v = halfedges().target(h);
      if(way_[v] == h || way_[u] == halfedges().twin(h))
        continue;
      Chain cycle;
      add(h, 1, cycle);
      add_way_to(u, 1, cycle);
      add_way_to(v, -1, cycle);
      normalize(cycle);
      cycles_.push_back(std::move(cycle));
    }
  }

  // Under the smaller halfedge of the edge.
  void add(Index h, int times, Chain& chain) const {
    const Index twin = halfedges().twin(h);
    chain.emplace_back((std::min)(h, twin), h < twin ? times : -times);
  }

  void add_way_to(Index v, int times, Chain& chain) const {
    for(; way_[v] != no_index; v = halfedges().source(way_[v]))
      add(way_[v], times, chain);
  }

  Chain combination(const std::optional<Class_vector>& factors) const {
    Chain chain;
    if(!factors)
      throw std::invalid_argument("the loops are no basis");
    for(const auto& [i, factor] : *factors)
      if(!add_multiple(chain, factor, cycles_[i]))
        throw std::invalid_argument("the loops cross each other too often");
    return chain;
  }

  const Cut_problem& problem_;
  const std::vector<Index>& cut_;
  std::vector<std::vector<Index>> edges_; // of the cut, by vertex at which they begin, both ways
  std::vector<Index> way_;                // the halfedge by which a tree comes to a vertex
  std::vector<char> is_reached_;
  std::vector<Chain> cycles_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_DUAL_CHAINS_H
