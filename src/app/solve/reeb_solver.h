// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REEB_SOLVER_H
#define HTLOOPS_REEB_SOLVER_H

#include "mesh_types.h"
#include "solve/progress.h"

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/reeb_arc_shapes.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

/// A Reeb graph and how it was found.
struct Reeb_answer
{
  /// the arc of a vertex without faces.
  static constexpr std::size_t no_arc = (std::numeric_limits<std::size_t>::max)();

  CGAL::Reeb_graph<Mesh> graph;
  std::vector<std::size_t> vertex_arc; ///< by vertex
  std::vector<double> values;          ///< by vertex, of the function
  std::string function;                ///< of which it is the graph, in a word
  bool is_contracted = false;          ///< whether arcs are parts with short borders
  bool is_capped = false;              ///< whether it is that of the surface with its caps
  std::string backend;                 ///< what computed the fields of the diffusion, else "host"
  CGAL::Handle_tunnel_loops::Reeb_statistics statistics;
  /// what is known of the lines, if they have been drawn inside.
  std::optional<CGAL::Handle_tunnel_loops::Reeb_embedding> embedding;
  int number_of_threads = 1;
  double total_seconds = 0.; ///< without reading and writing
};

/// the word for a type of nodes, as it stands in files and messages.
const char* name_of(CGAL::Reeb_node_type type);

/// what is given by vertex, or is to be, as a property map.
template <typename Values> auto map_of_vertices(const Mesh& mesh, Values& values) {
  return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, mesh));
}

/// see `CGAL::reeb_arc_girths()`.
std::vector<double> girths_of(const Mesh& mesh, const Reeb_answer& answer);

CGAL::Reeb_arc_shapes shapes_of_arcs(const Mesh& mesh, const Reeb_answer& answer);

/// the number of independent cycles.
std::size_t number_of_cycles(const Reeb_answer& answer);

/// the colour of an arc, and of the vertices that belong to it.
Colour colour_of_arc(std::size_t arc);

struct Reeb_options : CGAL::Handle_tunnel_loops::Reeb_options
{
  std::vector<Mesh::Vertex_index> sources; ///< of the diffusion; none: as the library chooses
  std::vector<double> values;              ///< by vertex, a function; none: a diffusion
  std::vector<std::int64_t> integers;      ///< the same; they are compared exactly
  bool do_draw_inside = false;  ///< in the middle of the solid, or along the means of contours
  std::string backend = "auto"; ///< of the diffusion, see `choose_backend()`
  int number_of_threads = 0;    ///< 0: as many as the machine has
};

/// the measures by their names.
const std::map<std::string, CGAL::Reeb_measure>& reeb_measures();

/// computes a Reeb graph.
Reeb_answer find_reeb_graph(const Mesh& mesh, const Reeb_options& options, Progress& progress);

} // namespace htloops

#endif // HTLOOPS_REEB_SOLVER_H
