// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/same_class.h"

#include <CGAL/Handle_tunnel_loops/internal/certificate/homology_classes.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>

namespace htloops {
namespace {

namespace internal = CGAL::Handle_tunnel_loops::internal;

using internal::Chain_entry;
using internal::Index;
using internal::Used_edge;

constexpr internal::Execution execution;

/// Two loops are homologous if their difference bounds: if faces, and the outside, can be given
/// integers that differ across each edge by how often the loops run along it. The integers are the
/// same on each of the pieces into which all loops cut the surface, and 0 for almost all pairs.
class Class_comparison
{
public:
  Class_comparison(const Mesh& mesh, const std::vector<std::pair<const Loop*, const Loop*>>& pairs)
      : mesh_(mesh) {
    for(std::size_t i = 0; i < pairs.size(); ++i) {
      add_loop(*pairs[i].first, i, 1);
      add_loop(*pairs[i].second, i, -1);
    }
    edges_ = internal::add_up_chains(execution, chains_);
    cut_into_pieces();
    internal::keep_distinct_edges(execution, chains_, edges_);
    collect_neighbors();
  }

  std::set<std::uint32_t> different_pairs() const {
    std::set<std::uint32_t> different;
    std::map<std::size_t, Row> rows;
    for(const auto& piece : neighbors_)
      if(rows.emplace(piece.first, Row()).second)
        compare_around(piece.first, rows, different);
    return different;
  }

private:
  using Row = std::map<std::uint32_t, std::int64_t>; // the integers of all pairs, without zeros

  // The piece beyond an edge, on its right (-1) or left.
  struct Neighbor
  {
    std::size_t piece, edge;
    int sign;
  };

  Mesh::Vertex_index nearest_end(const Loop::Step& step) const {
    return step.ratio == 1. ? mesh_.target(step.halfedge) : mesh_.source(step.halfedge);
  }

  // Two places on a face move to two of its corners, which are equal or joined by an edge.
  void add_loop(const Loop& loop, std::size_t pair, int sign) {
    Mesh::Vertex_index u = nearest_end(loop.steps().back());
    for(const Loop::Step& step : loop.steps()) {
      const Mesh::Vertex_index v = nearest_end(step);
      if(u != v)
        chains_.push_back({key(u, v), static_cast<std::uint32_t>(pair), u < v ? sign : -sign});
      u = v;
    }
  }

  static std::uint64_t key(Mesh::Vertex_index u, Mesh::Vertex_index v) {
    const std::uint64_t a = (std::min)(u, v).idx(), b = (std::max)(u, v).idx();
    return a << 32 | b;
  }

  // Where the mesh ends there is one face more, the outside.
  std::size_t face_at(Mesh::Halfedge_index h) const {
    return mesh_.is_border(h) ? mesh_.number_of_faces() : mesh_.face(h).idx();
  }

  void cut_into_pieces() {
    const std::size_t size = mesh_.number_of_faces() + 1;
    std::vector<std::size_t> rank(size), parent(size);
    for(std::size_t i = 0; i < size; ++i)
      parent[i] = i;
    boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
    std::vector<Mesh::Halfedge_index> used(edges_.size());
    for(const Mesh::Edge_index e : mesh_.edges()) {
      const Mesh::Halfedge_index h = mesh_.halfedge(e);
      const std::uint64_t k = key(mesh_.source(h), mesh_.target(h));
      const auto at = std::lower_bound(
          edges_.begin(), edges_.end(), k,
          [](const Used_edge& edge, std::uint64_t value) { return edge.edge < value; });
      if(at != edges_.end() && at->edge == k)
        used[at - edges_.begin()] = mesh_.source(h) < mesh_.target(h) ? h : mesh_.opposite(h);
      else
        sets.union_set(face_at(h), face_at(mesh_.opposite(h)));
    }
    sets.compress_sets(parent.begin(), parent.end());
    for(std::size_t i = 0; i < edges_.size(); ++i) {
      edges_[i].left = static_cast<Index>(parent[face_at(used[i])]);
      edges_[i].right = static_cast<Index>(parent[face_at(mesh_.opposite(used[i]))]);
    }
  }

  void collect_neighbors() {
    for(std::size_t i = 0; i < edges_.size(); ++i) {
      neighbors_[edges_[i].left].push_back({edges_[i].right, i, -1});
      neighbors_[edges_[i].right].push_back({edges_[i].left, i, 1});
    }
  }

  Row beyond(const Neighbor& neighbor, Row row) const {
    const Used_edge& edge = edges_[neighbor.edge];
    for(std::size_t i = edge.first; i < edge.last; ++i) {
      const auto at = row.emplace(chains_[i].loop, 0).first;
      at->second += neighbor.sign * std::int64_t(chains_[i].value);
      if(at->second == 0)
        row.erase(at);
    }
    return row;
  }

  // The integers of one piece give those of all that hang together with it; where two ways say
  // different things, there are none.
  void compare_around(std::size_t start,
                      std::map<std::size_t, Row>& rows,
                      std::set<std::uint32_t>& different) const {
    std::vector<std::size_t> open{start};
    while(!open.empty()) {
      const std::size_t here = open.back();
      open.pop_back();
      for(const Neighbor& n : neighbors_.at(here)) {
        const Row there = beyond(n, rows.at(here));
        const auto [known, is_new] = rows.emplace(n.piece, there);
        if(is_new)
          open.push_back(n.piece);
        else
          add_differences(there, known->second, different);
      }
    }
  }

  static void add_differences(const Row& a, const Row& b, std::set<std::uint32_t>& different) {
    std::vector<Row::value_type> entries;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                  std::back_inserter(entries));
    for(const auto& [pair, value] : entries)
      different.insert(pair);
  }

  const Mesh& mesh_;
  std::vector<Chain_entry> chains_;
  std::vector<Used_edge> edges_;
  std::map<std::size_t, std::vector<Neighbor>> neighbors_; // of each piece
};

} // namespace

std::vector<std::size_t>
pairs_of_different_class(const Mesh& mesh,
                         const std::vector<std::pair<const Loop*, const Loop*>>& pairs) {
  const std::set<std::uint32_t> different = Class_comparison(mesh, pairs).different_pairs();
  return {different.begin(), different.end()};
}

} // namespace htloops
