// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FACE_ARCS_H
#define HTLOOPS_FACE_ARCS_H

#include "mesh_types.h"
#include "solve/border_levels.h"
#include "solve/reeb_answer.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace htloops {

/// A part of a face, or of an edge: where the function has values from `low` to `high`, it belongs
/// to an arc.
struct Face_part
{
  std::size_t arc;
  double low, high;

  friend bool operator==(const Face_part& a, const Face_part& b) {
    return a.arc == b.arc && a.low == b.low && a.high == b.high;
  }
};

/*!
The arcs that faces belong to. A face whose vertices belong to different arcs is passed by fronts of
all these, one after the other: they meet at the contours of the nodes between them, or, where the
simplification moved these, at those of `Border_levels`.
*/
class Face_arcs
{
public:
  Face_arcs(const Mesh& mesh, const Reeb_answer& answer);

  /// the vertices of a face by increasing value.
  std::array<Mesh::Vertex_index, 3> vertices_of(Mesh::Face_index f) const;

  /// whether all of a face belongs to the arc of its first vertex, as nearly always.
  bool is_of_one_arc(const std::array<Mesh::Vertex_index, 3>& vertices) const {
    const auto arc = [this](Mesh::Vertex_index v) { return answer_.vertex_arc[v.idx()]; };
    return arc(vertices[0]) == arc(vertices[1]) && arc(vertices[1]) == arc(vertices[2]);
  }

  /// the parts of the face that has these vertices, from below, as one finds them on the way over
  /// the one in the middle.
  std::vector<Face_part> parts_of(const std::array<Mesh::Vertex_index, 3>& vertices);

  /// the parts of an edge, from its lower vertex upwards.
  std::vector<Face_part> parts_of(Mesh::Vertex_index low, Mesh::Vertex_index high);

private:
  using Path = std::vector<std::size_t>;

  double value(Mesh::Vertex_index v) const { return answer_.values[v.idx()]; }

  void append(Mesh::Vertex_index from, Mesh::Vertex_index to, std::vector<Face_part>& parts);
  Path path_along_edge(Mesh::Vertex_index from, Mesh::Vertex_index to);
  const Path& path(std::size_t from, std::size_t to);
  Path find_path(std::size_t from, std::size_t to) const;
  std::optional<double> level_between(std::size_t lower, std::size_t upper) const;

  const Mesh& mesh_;
  const Reeb_answer& answer_;
  std::vector<std::size_t> low_node_, high_node_; // by arc
  std::vector<std::vector<std::size_t>> arcs_up_; // by node
  Border_levels borders_;
  std::map<std::pair<std::size_t, std::size_t>, Path> paths_;
};

} // namespace htloops

#endif // HTLOOPS_FACE_ARCS_H
