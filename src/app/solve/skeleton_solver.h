// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SKELETON_SOLVER_H
#define HTLOOPS_SKELETON_SOLVER_H

#include "mesh_types.h"
#include "solve/progress.h"

#include <CGAL/Handle_tunnel_loops/Curve_skeleton.h>
#include <CGAL/Handle_tunnel_loops/Skeleton_certificate.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

using Skeleton_graph = CGAL::Curve_skeleton<Mesh>;
using CGAL::Handle_tunnel_loops::Skeleton_certificate;

/// A path of a skeleton between nodes, which are its points of degree other than 2; or a cycle
/// without any, which begins at its first point.
struct Skeleton_arc
{
  std::vector<std::size_t> points; ///< by number; of a cycle, the first again at the end
  std::size_t component = 0;
  double length = 0.;
  double smallest_radius = 0.;
  double mean_radius = 0.;  ///< along the length
  bool is_on_cycle = false; ///< the skeleton would be as connected without it

  bool is_closed() const { return points.front() == points.back(); }
};

/// A curve skeleton, what has been proved of it, and how it was found.
struct Skeleton_answer
{
  /// the point or the arc of a vertex without one.
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  Skeleton_graph graph;
  std::vector<std::size_t> vertex_point; ///< by vertex of the mesh
  std::vector<Skeleton_arc> arcs;
  CGAL::Handle_tunnel_loops::Skeleton_statistics statistics;
  bool does_mesh_touch_itself = false; ///< then there is no inside to prove
  int number_of_threads = 1;
  double total_seconds = 0.; ///< without reading and writing

  /// what has been proved.
  const Skeleton_certificate& certificate() const { return statistics.certificate; }
};

/// How a skeleton is computed.
struct Skeleton_options : CGAL::Handle_tunnel_loops::Skeleton_options
{
  int number_of_threads = 0; ///< 0: as many as the machine has
};

/// computes a skeleton, and what can be proved of it.
Skeleton_answer
find_skeleton(const Mesh& mesh, const Skeleton_options& options, Progress& progress);

/// the arcs of a graph, in the order of the points that they begin at.
std::vector<Skeleton_arc> arcs_of(const Skeleton_graph& graph);

/// the distance of two points.
double distance(const Point& p, const Point& q);

/// the distance of its ends, as the tortuosity is the length over it; 0 for a cycle.
double chord_of(const Skeleton_graph& graph, const Skeleton_arc& arc);

/// the word for a point: "inlet", "end", "joint" or, between others, "bend".
const char* name_of_point(const Skeleton_graph& graph, std::size_t point);

/// the number of independent cycles.
std::size_t number_of_cycles(const Skeleton_graph& graph);

/// by vertex of the mesh, the arc that it belongs to; one that belongs to a joint goes to the arc
/// that leaves it in the direction of the vertex.
std::vector<std::size_t> arcs_of_vertices(const Mesh& mesh, const Skeleton_answer& answer);

} // namespace htloops

#endif // HTLOOPS_SKELETON_SOLVER_H
