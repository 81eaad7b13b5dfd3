// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/girths.h"

#include "solve/face_arcs.h"

#include <CGAL/Kernel/global_functions.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace htloops {
namespace {

/// The contours of arcs, one of each, as they are found face by face.
class Contours_of_arcs
{
public:
  explicit Contours_of_arcs(std::size_t number_of_arcs)
      : number_of_arcs_(number_of_arcs) {}

  /// of an arc: across a face from one edge to another.
  void add(std::size_t arc, const std::array<Mesh::Edge_index, 2>& edges, double length) {
    std::array<std::size_t, 2> ends;
    for(std::size_t i : {0, 1})
      ends[i] = ends_.try_emplace({arc, edges[i]}, ends_.size()).first->second;
    pieces_.push_back({arc, ends, length});
  }

  /// by arc, the length of what hangs together, where there are several of them that of the
  /// longest.
  std::vector<double> longest() const {
    std::vector<std::size_t> rank(ends_.size()), parent(ends_.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
    for(const Piece& piece : pieces_)
      sets.union_set(piece.ends[0], piece.ends[1]);
    std::vector<double> lengths(ends_.size()), longest(number_of_arcs_);
    for(const Piece& piece : pieces_)
      lengths[sets.find_set(piece.ends[0])] += piece.length;
    for(const Piece& piece : pieces_)
      longest[piece.arc] = (std::max)(longest[piece.arc], lengths[sets.find_set(piece.ends[0])]);
    return longest;
  }

private:
  struct Piece
  {
    std::size_t arc;
    std::array<std::size_t, 2> ends;
    double length;
  };

  std::size_t number_of_arcs_;
  std::map<std::pair<std::size_t, Mesh::Edge_index>, std::size_t> ends_; // numbers of places
  std::vector<Piece> pieces_;
};

} // namespace

std::vector<double> girths_of(const Mesh& mesh, const Reeb_answer& answer) {
  std::vector<double> levels(num_edges(answer.graph));
  for(const auto e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    if(!arc.vertices.empty())
      levels[arc.index] = answer.values[arc.vertices[arc.vertices.size() / 2].idx()];
  }
  Face_arcs arcs(mesh, answer);
  Contours_of_arcs contours(levels.size());
  const auto at = [&](Mesh::Vertex_index v, Mesh::Vertex_index w, double level) {
    const double low = answer.values[v.idx()], high = answer.values[w.idx()];
    const double ratio = low < high ? (level - low) / (high - low) : 0.;
    return mesh.point(v) + ratio * (mesh.point(w) - mesh.point(v));
  };
  const auto edge = [&](Mesh::Vertex_index v, Mesh::Vertex_index w) {
    return mesh.edge(mesh.halfedge(v, w));
  };
  const auto add = [&](const std::array<Mesh::Vertex_index, 3>& v, const Face_part& part) {
    const double level = levels[part.arc];
    if(!(part.low < level && level <= part.high))
      return;
    const bool is_above = answer.values[v[1].idx()] < level;
    const auto [low, high] = is_above ? std::pair(v[1], v[2]) : std::pair(v[0], v[1]);
    contours.add(part.arc, {edge(v[0], v[2]), edge(low, high)},
                 std::sqrt(CGAL::squared_distance(at(v[0], v[2], level), at(low, high, level))));
  };
  for(const Mesh::Face_index f : mesh.faces()) {
    const auto v = arcs.vertices_of(f);
    if(arcs.is_of_one_arc(v))
      add(v, {answer.vertex_arc[v[0].idx()], answer.values[v[0].idx()], answer.values[v[2].idx()]});
    else
      for(const Face_part& part : arcs.parts_of(v))
        add(v, part);
  }
  return contours.longest();
}

} // namespace htloops
