// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FLAT_REEB_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FLAT_REEB_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <array>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A place of which only a picture is made.
using Float_point = std::array<float, 3>;

inline Float_point to_float_point(const Vector& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

inline Vector to_vector(const Float_point& p) { return {p[0], p[1], p[2]}; }

enum class Node_kind { MINIMUM, SADDLE, MAXIMUM, REGULAR };

/// A Reeb graph in the terms of the flat mesh. Minima and maxima have one arc, saddles have three:
/// two below and one above, or one below and two above.
struct Flat_reeb_graph
{
  struct Node
  {
    Index vertex;
    Node_kind kind;
    Vector position; ///< the vertex at an extremum, the mean of the front at a saddle
  };

  struct Arc
  {
    Index lower = no_index, upper = no_index;   ///< nodes
    float lower_girth = 0.f, upper_girth = 0.f; ///< of the front at the ends
  };

  /// A mean of the front of an arc, when it has passed a vertex.
  struct Sample
  {
    Index arc;
    Index vertex;
    Float_point position;
  };

  std::vector<Node> nodes; ///< from the lowest to the highest
  std::vector<Arc> arcs;
  std::vector<Index> vertex_arc; ///< by vertex; a critical point is on the arc below it, if any
  std::vector<Sample> samples;   ///< those of an arc from below to above
};

using Polyline = std::vector<Vector>;

inline double length(const Polyline& line) {
  double sum = 0.;
  for(std::size_t i = 1; i < line.size(); ++i)
    sum += norm(line[i] - line[i - 1]);
  return sum;
}

/// A Reeb graph as it is handed out, still in the terms of the flat mesh.
struct Embedded_reeb_graph
{
  struct Arc
  {
    Index lower, upper;          ///< nodes
    Polyline line;               ///< from the lower node to the upper one
    std::vector<Index> vertices; ///< of the mesh, in the order of the sweep
  };

  std::vector<Flat_reeb_graph::Node> nodes;
  std::vector<Arc> arcs;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FLAT_REEB_GRAPH_H
