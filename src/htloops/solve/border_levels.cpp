// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/border_levels.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace htloops {
namespace {

constexpr std::uint32_t not_crossed = static_cast<std::uint32_t>(-1);

} // namespace

Border_levels::Border_levels(const Mesh& mesh,
                             const Reeb_answer& answer,
                             const Node_level& node_level)
    : mesh_(mesh)
    , answer_(answer) {
  find_crossed_edges();
  levels_.resize(crossed_.size());
  for(const std::vector<std::uint32_t>& border : connected_borders()) {
    const double level = best_level(border, node_level);
    for(const std::uint32_t i : border)
      levels_[i] = level;
  }
}

void Border_levels::find_crossed_edges() {
  numbers_.assign(mesh_.num_edges(), not_crossed);
  for(const Mesh::Edge_index e : mesh_.edges()) {
    std::size_t v = mesh_.vertex(e, 0).idx(), w = mesh_.vertex(e, 1).idx();
    if(answer_.vertex_arc[v] == answer_.vertex_arc[w])
      continue;
    if(std::pair(answer_.values[w], w) < std::pair(answer_.values[v], v))
      std::swap(v, w);
    numbers_[e.idx()] = static_cast<std::uint32_t>(crossed_.size());
    crossed_.push_back(
        {e, answer_.values[v], answer_.values[w], answer_.vertex_arc[v], answer_.vertex_arc[w]});
  }
}

// Edges of a face between the same two arcs are of one border.
std::vector<std::vector<std::uint32_t>> Border_levels::connected_borders() const {
  const std::size_t count = crossed_.size();
  std::vector<std::uint32_t> rank(count), parent(count);
  boost::disjoint_sets<std::uint32_t*, std::uint32_t*> sets(rank.data(), parent.data());
  for(std::uint32_t i = 0; i < count; ++i)
    sets.make_set(i);
  const auto arcs = [this](std::uint32_t i) {
    return std::minmax(crossed_[i].low_arc, crossed_[i].high_arc);
  };
  for(std::uint32_t i = 0; i < count; ++i) {
    const Mesh::Halfedge_index h = mesh_.halfedge(crossed_[i].edge);
    for(const Mesh::Halfedge_index side : {h, mesh_.opposite(h)}) {
      if(mesh_.is_border(side))
        continue;
      for(const Mesh::Halfedge_index other : {mesh_.next(side), mesh_.prev(side)}) {
        const std::uint32_t beside = numbers_[mesh_.edge(other).idx()];
        if(beside != not_crossed && arcs(beside) == arcs(i))
          sets.union_set(i, beside);
      }
    }
  }
  std::vector<std::vector<std::uint32_t>> borders;
  std::vector<std::uint32_t> border_of(count, not_crossed); // by the first of a set
  for(std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t& border = border_of[sets.find_set(i)];
    if(border == not_crossed) {
      border = static_cast<std::uint32_t>(borders.size());
      borders.emplace_back();
    }
    borders[border].push_back(i);
  }
  return borders;
}

double Border_levels::best_level(const std::vector<std::uint32_t>& border,
                                 const Node_level& node_level) const {
  std::vector<double> lows, highs;
  for(const std::uint32_t i : border) {
    lows.push_back(crossed_[i].low);
    highs.push_back(crossed_[i].high);
  }
  std::sort(lows.begin(), lows.end());
  std::sort(highs.begin(), highs.end());
  const auto crossed_at = [&](double level) { // edges that begin below it less those that end
    return (std::upper_bound(lows.begin(), lows.end(), level) - lows.begin()) -
           (std::lower_bound(highs.begin(), highs.end(), level) - highs.begin());
  };
  const Crossed_edge& some = crossed_[border.front()];
  const std::optional<double> node = node_level(some.low_arc, some.high_arc);
  // Most are crossed just above the low end of some edge, up to the next high end.
  double best = node.value_or(lows.back());
  auto most = node ? crossed_at(*node) : 0;
  for(const double low : lows)
    if(const auto count = crossed_at(low); count > most) {
      most = count;
      best = low / 2. + *std::lower_bound(highs.begin(), highs.end(), low) / 2.;
    }
  return best;
}

} // namespace htloops
