// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_NECK_PIECES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_NECK_PIECES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
The pieces into which disjoint loops cut a surface. A loop that is kept joins the pieces on its two
sides as an edge of a graph; one that is given up makes them one.
*/
class Neck_pieces
{
public:
  Neck_pieces(const Flat_mesh& mesh,
              const std::vector<Crossing_loop>& loops,
              const std::vector<double>& vertex_areas)
      : mesh_(mesh)
      , piece_(mesh.number_of_vertices(), no_index) {
    number_pieces(Crossing_index(mesh, loops));
    total_.assign(mesh.seeds.size(), 0.);
    for(Index v = 0; v < piece_.size(); ++v) {
      area_[piece_[v]] += vertex_areas[v];
      total_[component_[piece_[v]]] += vertex_areas[v];
    }
    for(const Crossing_loop& loop : loops)
      sides_.emplace_back(piece_[loop.front().left], piece_[loop.front().right]);
  }

  /// whether each loop separates its component: the pieces and loops are trees, one for each
  /// component.
  bool is_forest() const {
    return area_.size() == mesh_.seeds.size() + sides_.size() &&
           std::all_of(sides_.begin(), sides_.end(),
                       [](const auto& sides) { return sides.first != sides.second; });
  }

  /// which of the loops to keep so that no piece is smaller than a share of its component: of those
  /// around a small piece the later ones are given up first.
  std::vector<char> kept(double minimal_share) {
    std::vector<char> is_kept(sides_.size(), 1);
    // Joining pieces may leave one that was large enough as it is, but never makes one small.
    for(std::size_t i = sides_.size(); i-- > 0;) {
      const Index a = find(sides_[i].first), b = find(sides_[i].second);
      if((std::min)(area_[a], area_[b]) >= minimal_share * total_[component_[a]])
        continue;
      is_kept[i] = 0;
      parent_[b] = a;
      area_[a] += area_[b];
    }
    return is_kept;
  }

  /// by loop, how much of its component is on the smaller side; 0 for loops that are not kept.
  std::vector<double> smaller_shares(const std::vector<char>& is_kept) {
    std::vector<std::vector<std::size_t>> loops_at(area_.size());
    for(std::size_t i = 0; i < sides_.size(); ++i)
      if(is_kept[i] != 0)
        for(const Index piece : {sides_[i].first, sides_[i].second})
          loops_at[find(piece)].push_back(i);
    std::vector<double> shares(sides_.size(), 0.);
    std::vector<char> is_visited(area_.size(), 0);
    for(Index piece = 0; piece < area_.size(); ++piece)
      if(find(piece) == piece && is_visited[piece] == 0)
        sum_up(piece, loops_at, is_visited, shares);
    return shares;
  }

private:
  void number_pieces(const Crossing_index& walls) {
    const Loops_from all = {0};
    std::vector<Index> reached;
    for(Index seed = 0; seed < piece_.size(); ++seed) {
      if(piece_[seed] != no_index)
        continue;
      const Index piece = static_cast<Index>(area_.size());
      area_.push_back(0.);
      parent_.push_back(piece);
      component_.push_back(mesh_.component[seed]);
      piece_[seed] = piece;
      reached.push_back(seed);
      while(!reached.empty()) {
        const Index v = reached.back();
        reached.pop_back();
        const bool is_beside_loop = walls.has_crossing(v);
        for(Index u : mesh_.ring(v))
          if(piece_[u] == no_index && !(is_beside_loop && walls.is_crossed(v, u, all))) {
            piece_[u] = piece;
            reached.push_back(u);
          }
      }
    }
  }

  Index find(Index piece) {
    while(parent_[piece] != piece)
      piece = parent_[piece] = parent_[parent_[piece]];
    return piece;
  }

  // From the leaves of a tree to its root.
  void sum_up(Index root,
              const std::vector<std::vector<std::size_t>>& loops_at,
              std::vector<char>& is_visited,
              std::vector<double>& shares) {
    constexpr std::size_t none = ~std::size_t(0);
    std::vector<std::pair<Index, std::size_t>> order = {{root, none}}; // and the loop before it
    is_visited[root] = 1;
    for(std::size_t i = 0; i < order.size(); ++i)
      for(const std::size_t loop : loops_at[order[i].first])
        for(const Index side : {find(sides_[loop].first), find(sides_[loop].second)})
          if(!std::exchange(is_visited[side], char(1)))
            order.emplace_back(side, loop);
    std::vector<double> beyond = area_;
    for(std::size_t i = order.size(); i-- > 1;) {
      const auto [piece, loop] = order[i];
      const Index a = find(sides_[loop].first), b = find(sides_[loop].second);
      beyond[a == piece ? b : a] += beyond[piece];
      const double share = beyond[piece] / total_[component_[piece]];
      shares[loop] = (std::min)(share, 1. - share);
    }
  }

  const Flat_mesh& mesh_;
  std::vector<Index> piece_; // by vertex
  std::vector<double> area_; // by piece
  std::vector<Index> parent_, component_;
  std::vector<double> total_;                  // by component
  std::vector<std::pair<Index, Index>> sides_; // by loop
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_NECK_PIECES_H
