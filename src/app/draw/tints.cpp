// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/tints.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

namespace htloops {
namespace {

using Neighbours = std::vector<std::pair<std::size_t, std::size_t>>;

// Blue, sand, green and rose, as far as these are enough.
constexpr std::array<Colour, 6> all_tints = {{{201, 223, 245},
                                              {250, 233, 200},
                                              {206, 235, 207},
                                              {246, 213, 222},
                                              {223, 214, 245},
                                              {203, 238, 236}}};
constexpr std::size_t least_tints = 4;

// Pairs of the arcs that end at the same point, of which `ends` has one element for each.
void add_pairs(const std::vector<std::vector<std::size_t>>& ends, Neighbours& neighbours) {
  for(const std::vector<std::size_t>& arcs : ends)
    for(std::size_t i = 0; i < arcs.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        neighbours.emplace_back(arcs[i], arcs[j]);
}

// Pairs of arcs to which the ends of an edge belong; some of these may belong to none.
void add_borders(const Mesh& mesh,
                 const std::vector<std::size_t>& arcs_of_vertices,
                 Neighbours& neighbours) {
  for(const Mesh::Edge_index e : mesh.edges()) {
    const std::size_t a = arcs_of_vertices[mesh.vertex(e, 0).idx()];
    const std::size_t b = arcs_of_vertices[mesh.vertex(e, 1).idx()];
    if(a != b && a != Skeleton_answer::none && b != Skeleton_answer::none)
      neighbours.emplace_back(a, b);
  }
}

/// Gives parts so many tints, those first whose neighbours have the most tints (Brelaz 1979): each
/// the one that fewest neighbours have, and of these the one that fewest parts have.
class Tinting
{
public:
  Tinting(const std::vector<std::vector<std::size_t>>& neighbours, std::size_t number_of_tints)
      : neighbours_(neighbours)
      , number_of_all_tints(number_of_tints)
      , tint_(neighbours.size(), none)
      , around_(neighbours.size()) {
    for(std::size_t part = 0; part < neighbours.size(); ++part)
      waiting_.insert(urgency_of(part));
    while(!waiting_.empty())
      give_tint(std::get<2>(*waiting_.begin()));
  }

  const std::vector<std::size_t>& tints() const { return tint_; }

  bool has_equal_neighbours() const { return has_equal_neighbours_; }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  using Counts = std::array<std::size_t, all_tints.size()>;
  using Urgency = std::tuple<std::ptrdiff_t, std::ptrdiff_t, std::size_t>; // the most urgent first

  Urgency urgency_of(std::size_t part) const {
    const Counts& around = around_[part];
    return {std::count(around.begin(), around.end(), 0u),
            -static_cast<std::ptrdiff_t>(neighbours_[part].size()), part};
  }

  void give_tint(std::size_t part) {
    waiting_.erase(waiting_.begin());
    const Counts& around = around_[part];
    std::size_t best = 0;
    for(std::size_t i = 1; i < number_of_all_tints; ++i)
      if(std::pair(around[i], parts_[i]) < std::pair(around[best], parts_[best]))
        best = i;
    has_equal_neighbours_ |= around[best] > 0;
    tint_[part] = best;
    ++parts_[best];
    for(const std::size_t other : neighbours_[part]) {
      const bool is_waiting = tint_[other] == none;
      if(is_waiting)
        waiting_.erase(urgency_of(other));
      ++around_[other][best];
      if(is_waiting)
        waiting_.insert(urgency_of(other));
    }
  }

  const std::vector<std::vector<std::size_t>>& neighbours_;
  const std::size_t number_of_all_tints;
  std::vector<std::size_t> tint_;
  std::vector<Counts> around_; // how many neighbours have each tint
  Counts parts_{};             // how many parts have it
  std::set<Urgency> waiting_;
  bool has_equal_neighbours_ = false;
};

// Those of each part, once.
std::vector<std::vector<std::size_t>> neighbours_of_parts(std::size_t number_of_parts,
                                                          const Neighbours& neighbours) {
  std::vector<std::vector<std::size_t>> lists(number_of_parts);
  for(const auto& [a, b] : neighbours)
    if(a != b) {
      lists[a].push_back(b);
      lists[b].push_back(a);
    }
  for(std::vector<std::size_t>& list : lists) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return lists;
}

} // namespace

std::vector<Colour> tints_of(std::size_t number_of_parts, const Neighbours& neighbours) {
  if(number_of_parts < 2)
    return std::vector<Colour>(number_of_parts, plain_tint);
  const auto lists = neighbours_of_parts(number_of_parts, neighbours);
  for(std::size_t number = least_tints;; ++number) {
    const Tinting tinting(lists, number);
    if(tinting.has_equal_neighbours() && number < all_tints.size())
      continue;
    std::vector<Colour> colours;
    for(const std::size_t i : tinting.tints())
      colours.push_back(all_tints[i]);
    return colours;
  }
}

std::vector<Colour> tints_of(const Mesh& mesh, const Reeb_answer& answer) {
  std::vector<std::vector<std::size_t>> ends(num_vertices(answer.graph));
  for(const auto e : CGAL::make_range(edges(answer.graph)))
    for(const auto node : {source(e, answer.graph), target(e, answer.graph)})
      ends[node].push_back(answer.graph[e].index);
  Neighbours neighbours;
  add_pairs(ends, neighbours);
  add_borders(mesh, answer.vertex_arc, neighbours);
  return tints_of(num_edges(answer.graph), neighbours);
}

std::vector<Colour> tints_of(const Mesh& mesh,
                             const Skeleton_answer& answer,
                             const std::vector<std::size_t>& arcs_of_vertices) {
  std::vector<std::vector<std::size_t>> ends(num_vertices(answer.graph));
  for(std::size_t i = 0; i < answer.arcs.size(); ++i)
    for(const std::size_t point : {answer.arcs[i].points.front(), answer.arcs[i].points.back()})
      ends[point].push_back(i);
  Neighbours neighbours;
  add_pairs(ends, neighbours);
  add_borders(mesh, arcs_of_vertices, neighbours);
  return tints_of(answer.arcs.size(), neighbours);
}

} // namespace htloops
