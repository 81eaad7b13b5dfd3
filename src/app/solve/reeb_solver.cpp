// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/reeb_solver.h"

#include "solve/library_backend.h"

#include <CGAL/embed_reeb_graph.h>
#include <CGAL/reeb_graph_of_function.h>

#include <algorithm>
#include <cmath>

namespace htloops {

const std::map<std::string, CGAL::Reeb_measure>& reeb_measures() {
  static const std::map<std::string, CGAL::Reeb_measure> measures = {
      {"limbs", CGAL::Reeb_measure::LIMBS},
      {"persistence", CGAL::Reeb_measure::PERSISTENCE},
      {"length", CGAL::Reeb_measure::LENGTH},
      {"area", CGAL::Reeb_measure::AREA},
      {"vertices", CGAL::Reeb_measure::VERTICES}};
  return measures;
}

Reeb_answer find_reeb_graph(const Mesh& mesh, const Reeb_options& options, Progress& progress) {
  const Thread_limit limit(options.number_of_threads);
  const bool has_values = !options.values.empty() || !options.integers.empty();
  progress.start("reeb");

  Reeb_answer answer;
  answer.function = has_values ? "given" : "diffusion";
  answer.is_contracted = options.shortest_arc > 0.;
  answer.is_capped = options.capped;
  answer.number_of_threads = limit.number_of_threads();
  answer.vertex_arc.assign(mesh.number_of_vertices(), Reeb_answer::no_arc);
  answer.values.assign(mesh.number_of_vertices(), 0.);
  const Stopwatch stopwatch;
  const auto find_graph_of = [&](const auto& function) {
    answer.statistics = CGAL::reeb_graph_of_function<All_threads_tag>(
        mesh, map_of_vertices(mesh, function), answer.graph,
        reeb_parameters(mesh, options, progress, answer));
    answer.backend = "host";
  };
  if(!options.integers.empty())
    find_graph_of(options.integers);
  else if(!options.values.empty())
    find_graph_of(options.values);
  else
    choose_backend(options.backend).diffuse(mesh, options, progress, answer);
  if(options.do_draw_inside) {
    progress.start("drawing");
    answer.embedding = CGAL::embed_reeb_graph<All_threads_tag>(mesh, answer.graph);
  }
  answer.total_seconds = stopwatch.seconds();
  progress.end();
  return answer;
}

const char* name_of(CGAL::Reeb_node_type type) {
  return type == CGAL::Reeb_node_type::MINIMUM   ? "minimum"
         : type == CGAL::Reeb_node_type::SADDLE  ? "saddle"
         : type == CGAL::Reeb_node_type::MAXIMUM ? "maximum"
                                                 : "regular";
}

std::vector<double> girths_of(const Mesh& mesh, const Reeb_answer& answer) {
  return CGAL::reeb_arc_girths(mesh, answer.graph, map_of_vertices(mesh, answer.vertex_arc),
                               map_of_vertices(mesh, answer.values));
}

CGAL::Reeb_arc_shapes shapes_of_arcs(const Mesh& mesh, const Reeb_answer& answer) {
  return CGAL::reeb_arc_shapes(mesh, answer.graph, map_of_vertices(mesh, answer.vertex_arc),
                               map_of_vertices(mesh, answer.values));
}

std::size_t number_of_cycles(const Reeb_answer& answer) {
  return num_edges(answer.graph) + answer.statistics.number_of_components -
         num_vertices(answer.graph);
}

// Hues go around by the golden ratio, so that the first arcs, and neighbours, differ well.
Colour colour_of_arc(std::size_t arc) {
  constexpr double golden = 0.6180339887498949, brightness = 242., paleness = 0.45;
  const double hue = 6. * std::fmod(golden * double(arc), 1.);
  Colour colour;
  for(int i = 0; i < 3; ++i) {
    const double distance = std::abs(std::fmod(hue + (i == 0 ? 0. : i == 1 ? 4. : 2.), 6.) - 3.);
    const double strength = (std::min)((std::max)(distance - 1., 0.), 1.);
    colour[i] = static_cast<unsigned char>(brightness * (paleness + (1. - paleness) * strength));
  }
  return colour;
}

} // namespace htloops
