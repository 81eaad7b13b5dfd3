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

namespace htloops {
namespace {

using Neighbours = std::vector<std::pair<std::size_t, std::size_t>>;

constexpr std::array<Colour, 8> tints = {{{250, 229, 209},
                                          {209, 228, 247},
                                          {217, 240, 213},
                                          {245, 217, 231},
                                          {246, 241, 200},
                                          {224, 217, 245},
                                          {208, 241, 237},
                                          {236, 225, 214}}};

// Pairs of the arcs that end at the same point, of which `ends` has one element for each.
void add_pairs(const std::vector<std::vector<std::size_t>>& ends, Neighbours& neighbours) {
  for(const std::vector<std::size_t>& arcs : ends)
    for(std::size_t i = 0; i < arcs.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        neighbours.emplace_back(arcs[i], arcs[j]);
}

} // namespace

std::vector<Colour> tints_of(std::size_t number_of_parts, const Neighbours& neighbours) {
  if(number_of_parts < 2)
    return std::vector<Colour>(number_of_parts, plain_tint);
  std::vector<std::vector<std::size_t>> earlier(number_of_parts); // neighbours of each
  for(const auto& [a, b] : neighbours)
    if(a != b)
      earlier[(std::max)(a, b)].push_back((std::min)(a, b));
  std::vector<std::size_t> tint(number_of_parts);
  std::array<std::size_t, tints.size()> parts{}; // that have each tint
  for(std::size_t part = 0; part < number_of_parts; ++part) {
    std::array<std::size_t, tints.size()> near{};
    for(const std::size_t other : earlier[part])
      ++near[tint[other]];
    std::size_t best = 0;
    for(std::size_t i = 1; i < tints.size(); ++i)
      if(std::pair(near[i], parts[i]) < std::pair(near[best], parts[best]))
        best = i;
    tint[part] = best;
    ++parts[best];
  }
  std::vector<Colour> colours;
  for(const std::size_t i : tint)
    colours.push_back(tints[i]);
  return colours;
}

std::vector<Colour> tints_of(const Reeb_answer& answer) {
  std::vector<std::vector<std::size_t>> ends(num_vertices(answer.graph));
  for(const auto e : CGAL::make_range(edges(answer.graph)))
    for(const auto node : {source(e, answer.graph), target(e, answer.graph)})
      ends[node].push_back(answer.graph[e].index);
  Neighbours neighbours;
  add_pairs(ends, neighbours);
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
  for(const Mesh::Edge_index e : mesh.edges()) {
    const std::size_t a = arcs_of_vertices[mesh.vertex(e, 0).idx()];
    const std::size_t b = arcs_of_vertices[mesh.vertex(e, 1).idx()];
    if(a != b && a != Skeleton_answer::none && b != Skeleton_answer::none)
      neighbours.emplace_back(a, b);
  }
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  return tints_of(answer.arcs.size(), neighbours);
}

} // namespace htloops
