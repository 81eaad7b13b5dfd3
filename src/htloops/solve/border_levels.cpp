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
#include <array>
#include <numeric>
#include <utility>

namespace htloops {

Border_levels::Border_levels(const Mesh& mesh,
                             const Reeb_answer& answer,
                             const Node_level& node_level)
    : mesh_(mesh)
    , answer_(answer) {
  find_crossed_edges();
  const std::vector<std::uint32_t> first_of = connected_borders();
  std::vector<std::vector<std::uint32_t>> borders(crossed_.size());
  for(std::uint32_t i = 0; i < crossed_.size(); ++i)
    borders[first_of[i]].push_back(i);
  levels_.resize(crossed_.size());
  for(std::uint32_t i = 0; i < crossed_.size(); ++i)
    if(!borders[i].empty())
      levels_[i] = best_level(borders[i], node_level);
  for(auto& [edge, number] : borders_)
    number = first_of[number];
}

void Border_levels::find_crossed_edges() {
  for(const Mesh::Edge_index e : mesh_.edges()) {
    std::size_t v = mesh_.vertex(e, 0).idx(), w = mesh_.vertex(e, 1).idx();
    if(answer_.vertex_arc[v] == answer_.vertex_arc[w])
      continue;
    if(std::pair(answer_.values[w], w) < std::pair(answer_.values[v], v))
      std::swap(v, w);
    borders_.emplace(e.idx(), static_cast<std::uint32_t>(crossed_.size()));
    crossed_.push_back(
        {answer_.values[v], answer_.values[w], answer_.vertex_arc[v], answer_.vertex_arc[w]});
  }
}

// For each edge the first one of its border: edges of a face between the same two arcs are of one.
std::vector<std::uint32_t> Border_levels::connected_borders() const {
  const std::size_t count = crossed_.size();
  std::vector<std::uint32_t> rank(count), parent(count);
  boost::disjoint_sets<std::uint32_t*, std::uint32_t*> sets(rank.data(), parent.data());
  for(std::uint32_t i = 0; i < count; ++i)
    sets.make_set(i);
  const auto arcs = [this](std::uint32_t i) {
    return std::minmax(crossed_[i].low_arc, crossed_[i].high_arc);
  };
  for(const auto& [edge, number] : borders_) {
    const Mesh::Halfedge_index h = mesh_.halfedge(Mesh::Edge_index(edge));
    for(const Mesh::Halfedge_index side : {h, mesh_.opposite(h)}) {
      if(mesh_.is_border(side))
        continue;
      for(const Mesh::Halfedge_index other : {mesh_.next(side), mesh_.prev(side)}) {
        const auto found = borders_.find(mesh_.edge(other).idx());
        if(found != borders_.end() && arcs(found->second) == arcs(number))
          sets.union_set(number, found->second);
      }
    }
  }
  std::vector<std::uint32_t> first(count, static_cast<std::uint32_t>(count)), result(count);
  for(std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t& known = first[sets.find_set(i)];
    known = (std::min)(known, i);
    result[i] = known;
  }
  return result;
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
