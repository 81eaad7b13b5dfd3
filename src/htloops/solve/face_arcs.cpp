// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/face_arcs.h"

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <queue>

namespace htloops {
namespace {

template <typename End> std::vector<std::size_t> nodes_of(const Reeb_answer& answer, End end) {
  std::vector<std::size_t> nodes(num_edges(answer.graph));
  for(const auto e : CGAL::make_range(edges(answer.graph)))
    nodes[answer.graph[e].index] = end(e);
  return nodes;
}

} // namespace

Face_arcs::Face_arcs(const Mesh& mesh, const Reeb_answer& answer)
    : mesh_(mesh)
    , answer_(answer)
    , low_node_(nodes_of(answer, [&](auto arc) { return source(arc, answer.graph); }))
    , high_node_(nodes_of(answer, [&](auto arc) { return target(arc, answer.graph); }))
    , arcs_up_(num_vertices(answer.graph))
    , borders_(mesh, answer, [this](std::size_t a, std::size_t b) { return level_between(a, b); }) {
  for(std::size_t arc = 0; arc < low_node_.size(); ++arc)
    arcs_up_[low_node_[arc]].push_back(arc);
}

std::array<Mesh::Vertex_index, 3> Face_arcs::vertices_of(Mesh::Face_index f) const {
  const Mesh::Halfedge_index h = mesh_.halfedge(f);
  std::array<Mesh::Vertex_index, 3> vertices = {mesh_.source(h), mesh_.target(h),
                                                mesh_.target(mesh_.next(h))};
  std::sort(vertices.begin(), vertices.end(), [this](auto v, auto w) {
    return std::make_pair(value(v), v) < std::make_pair(value(w), w);
  });
  return vertices;
}

std::vector<Face_part> Face_arcs::parts_of(const std::array<Mesh::Vertex_index, 3>& vertices) {
  std::vector<Face_part> parts = parts_of(vertices[0], vertices[1]);
  append(vertices[1], vertices[2], parts);
  return parts;
}

std::vector<Face_part> Face_arcs::parts_of(Mesh::Vertex_index low, Mesh::Vertex_index high) {
  std::vector<Face_part> parts = {{answer_.vertex_arc[low.idx()], value(low), value(low)}};
  append(low, high, parts);
  return parts;
}

// What is passed on the way from a vertex to a higher one of the same face.
void Face_arcs::append(Mesh::Vertex_index from,
                       Mesh::Vertex_index to,
                       std::vector<Face_part>& parts) {
  const Path passed = path_along_edge(from, to);
  for(const std::size_t arc : passed) {
    const double level = passed.size() == 1 ? borders_.level(mesh_.edge(mesh_.halfedge(from, to)))
                                            : level_between(parts.back().arc, arc).value();
    // Borders that are not quite contours leave the level here and there.
    const double least = (std::max)(parts.back().low, value(from));
    parts.back().high = std::clamp(level, least, value(to));
    parts.push_back({arc, parts.back().high, value(to)});
  }
  parts.back().high = value(to);
}

// The arcs after the first one. Where several ways lead upwards, a vertex beside the edge that is
// between its ends tells which of them is meant.
Face_arcs::Path Face_arcs::path_along_edge(Mesh::Vertex_index from, Mesh::Vertex_index to) {
  const std::size_t first = answer_.vertex_arc[from.idx()], last = answer_.vertex_arc[to.idx()];
  const Path& some = path(first, last);
  if(some.size() <= 1)
    return some;
  const Mesh::Halfedge_index h = mesh_.halfedge(from, to);
  for(const Mesh::Halfedge_index side : {h, mesh_.opposite(h)}) {
    if(mesh_.is_border(side))
      continue;
    const Mesh::Vertex_index beside = mesh_.target(mesh_.next(side));
    const std::size_t arc = answer_.vertex_arc[beside.idx()];
    if(arc == first || arc == last || !(value(from) < value(beside) && value(beside) < value(to)))
      continue;
    Path path_over = path(first, arc);
    const Path& rest = path(arc, last);
    if(level_between(first, path_over.front()) && level_between(arc, rest.front())) {
      path_over.insert(path_over.end(), rest.begin(), rest.end());
      return path_over;
    }
  }
  return some;
}

// The arcs after the first one.
const Face_arcs::Path& Face_arcs::path(std::size_t from, std::size_t to) {
  const auto [position, is_new] = paths_.try_emplace({from, to});
  if(is_new && from != to)
    position->second = find_path(from, to);
  return position->second;
}

// The shortest way upwards; if there is none, straight.
Face_arcs::Path Face_arcs::find_path(std::size_t from, std::size_t to) const {
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> before(low_node_.size(), none);
  std::queue<std::size_t> queue;
  queue.push(from);
  before[from] = from;
  while(!queue.empty() && before[to] == none) {
    for(const std::size_t arc : arcs_up_[high_node_[queue.front()]])
      if(before[arc] == none) {
        before[arc] = queue.front();
        queue.push(arc);
      }
    queue.pop();
  }
  if(before[to] == none)
    return {to};
  Path path;
  for(std::size_t arc = to; arc != from; arc = before[arc])
    path.push_back(arc);
  std::reverse(path.begin(), path.end());
  return path;
}

std::optional<double> Face_arcs::level_between(std::size_t lower, std::size_t upper) const {
  if(high_node_[lower] != low_node_[upper])
    return std::nullopt;
  return answer_.graph[high_node_[lower]].value;
}

} // namespace htloops
