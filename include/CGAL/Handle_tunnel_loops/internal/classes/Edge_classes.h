// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_EDGE_CLASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_EDGE_CLASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_index.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Sums of random weights, one for each loop, by how often a walk crosses it. Modulo 2^64: they are
/// zero for all walks that cross no loop but for a net number of zero, and for hardly any other.
/// `across` are the loops that are not to be crossed, `along` those that tell classes apart.
struct Class_sums
{
  std::uint64_t across = 0, along = 0;

  friend Class_sums operator+(Class_sums a, Class_sums b) {
    return {a.across + b.across, a.along + b.along};
  }
  friend bool operator==(const Class_sums& a, const Class_sums& b) {
    return a.across == b.across && a.along == b.along;
  }
  bool is_zero() const { return across == 0 && along == 0; }
  void add(std::int64_t number, const Class_sums& s) {
    across += static_cast<std::uint64_t>(number) * s.across;
    along += static_cast<std::uint64_t>(number) * s.along;
  }
};

/// What each edge contributes to the sums of walks, and which loops cross it. Loops 2k and 2k + 1
/// are a pair.
class Edge_classes
{
public:
  /// A loop that crosses an edge, as often as `number` says, from left to right.
  struct Term
  {
    Index loop;
    int number;
  };

  /// An edge from a vertex: `terms()` from `first` to the `first` of the next.
  struct Edge
  {
    Class_sums sums;
    Index first;
  };

  /// \p is_pure says by pair whether its loops bound on their sides. If so, handles and tunnels
  /// have sums of their own; if not, there are no loops that must not be crossed.
  Edge_classes(const Flat_mesh& mesh, const Crossing_index& index, const std::vector<char>& is_pure)
      : mesh_(mesh)
      , first_(mesh.number_of_vertices(), no_index) {
    const std::vector<Class_sums> weights = random_weights(is_pure);
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      if(index.has_crossing(v))
        add_edges(v, index, weights);
    edges_.push_back({{}, static_cast<Index>(terms_.size())});
  }

  /// whether any loop crosses an edge at `v`.
  bool has_crossing(Index v) const { return first_[v] != no_index; }

  /// the edge from `v` to its neighbour in this position of its ring, if there are crossings at
  /// `v`.
  const Edge& edge(Index v, Index position) const { return edges_[first_[v] + position]; }

  /// calls `f(loop, number)` for the loops that cross the edge from `u` to `v`.
  template <typename Function> void for_each_term(Index u, Index v, const Function& f) const {
    if(!has_crossing(u) || u == v)
      return;
    const Edge* e = &edge(u, mesh_.ring(u).position(v));
    for(Index i = e->first; i != (e + 1)->first; ++i)
      f(terms_[i].loop, terms_[i].number);
  }

private:
  static std::vector<Class_sums> random_weights(const std::vector<char>& is_pure) {
    std::mt19937_64 random;
    std::vector<Class_sums> weights;
    for(const char pure : is_pure) {
      const std::uint64_t handle = random(), tunnel = random();
      weights.push_back(pure ? Class_sums{handle, 0} : Class_sums{0, handle});
      weights.push_back({0, tunnel});
    }
    return weights;
  }

  void add_edges(Index v, const Crossing_index& index, const std::vector<Class_sums>& weights) {
    first_[v] = static_cast<Index>(edges_.size());
    // By neighbor, and there by loop.
    entries_.assign(index.entries().begin() + index.begins()[v],
                    index.entries().begin() + index.begins()[v + 1]);
    const auto is_before = [](const Crossing_entry& a, const Crossing_entry& b) {
      return a.other < b.other;
    };
    std::stable_sort(entries_.begin(), entries_.end(), is_before);
    for(Index u : mesh_.ring(v)) {
      edges_.push_back({{}, static_cast<Index>(terms_.size())});
      const auto [begin, end] =
          std::equal_range(entries_.begin(), entries_.end(), Crossing_entry{u, 0, 0}, is_before);
      for(auto e = begin; e != end;) {
        Term term{e->loop, 0};
        for(; e != end && e->loop == term.loop; ++e)
          term.number += e->sign;
        if(term.number == 0)
          continue;
        terms_.push_back(term);
        edges_.back().sums.add(term.number, weights[term.loop]);
      }
    }
  }

  const Flat_mesh& mesh_;
  std::vector<Index> first_; // edge, by vertex
  std::vector<Edge> edges_;
  std::vector<Term> terms_;
  std::vector<Crossing_entry> entries_; // of a vertex
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_EDGE_CLASSES_H
