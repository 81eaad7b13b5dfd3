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

Face_arcs::Face_arcs(const Mesh& mesh, const Reeb_answer& answer)
    : mesh_(mesh)
    , answer_(answer)
    , low_node_(num_edges(answer.graph))
    , high_node_(num_edges(answer.graph))
    , arcs_up_(num_vertices(answer.graph)) {
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const std::size_t arc = answer.graph[e].index;
    low_node_[arc] = source(e, answer.graph);
    high_node_[arc] = target(e, answer.graph);
    arcs_up_[low_node_[arc]].push_back(arc);
  }
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

const std::vector<Face_part>&
Face_arcs::parts_of(const std::array<Mesh::Vertex_index, 3>& vertices) {
  parts_.assign(1, {answer_.vertex_arc[vertices[0].idx()], value(vertices[0]), value(vertices[0])});
  append(vertices[0], vertices[1]);
  append(vertices[1], vertices[2]);
  parts_.back().high = value(vertices[2]);
  return parts_;
}

// What is passed on the way from a vertex to a higher one of the same face.
void Face_arcs::append(Mesh::Vertex_index from, Mesh::Vertex_index to) {
  const double middle = value(from) / 2. + value(to) / 2.;
  for(const std::size_t arc : path(answer_.vertex_arc[from.idx()], answer_.vertex_arc[to.idx()])) {
    const double level = level_between(parts_.back().arc, arc, middle);
    // Where small leaves were taken off, their vertices belong to an arc that ends elsewhere.
    const double between =
        std::clamp(level, parts_.back().low, (std::max)(parts_.back().low, value(to)));
    parts_.back().high = between;
    parts_.push_back({arc, between, value(to)});
  }
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

double Face_arcs::level_between(std::size_t lower, std::size_t upper, double otherwise) const {
  return high_node_[lower] == low_node_[upper] ? answer_.graph[high_node_[lower]].value : otherwise;
}

std::vector<double> girths_of(const Mesh& mesh, const Reeb_answer& answer) {
  std::vector<double> levels(num_edges(answer.graph)), girths(levels.size());
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    if(!arc.vertices.empty())
      levels[arc.index] = answer.values[arc.vertices[arc.vertices.size() / 2].idx()];
  }
  Face_arcs arcs(mesh, answer);
  const auto at = [&](Mesh::Vertex_index v, Mesh::Vertex_index w, double level) {
    const double low = answer.values[v.idx()], high = answer.values[w.idx()];
    const double ratio = low < high ? (level - low) / (high - low) : 0.;
    return mesh.point(v) + ratio * (mesh.point(w) - mesh.point(v));
  };
  for(const Mesh::Face_index f : mesh.faces()) {
    const auto v = arcs.vertices_of(f);
    for(const Face_part& part : arcs.parts_of(v)) {
      const double level = levels[part.arc];
      if(!(part.low < level && level <= part.high))
        continue;
      const bool is_above = answer.values[v[1].idx()] < level;
      const Point p = at(v[0], v[2], level);
      const Point q = is_above ? at(v[1], v[2], level) : at(v[0], v[1], level);
      girths[part.arc] += std::sqrt(CGAL::squared_distance(p, q));
    }
  }
  return girths;
}

} // namespace htloops
