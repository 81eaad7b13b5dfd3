// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/reeb_answer.h"

#include <algorithm>
#include <cmath>

namespace htloops {

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
std::array<unsigned char, 3> colour_of_arc(std::size_t arc) {
  constexpr double golden = 0.6180339887498949, brightness = 242., paleness = 0.45;
  const double hue = 6. * std::fmod(golden * double(arc), 1.);
  std::array<unsigned char, 3> colour;
  for(int i = 0; i < 3; ++i) {
    const double distance = std::abs(std::fmod(hue + (i == 0 ? 0. : i == 1 ? 4. : 2.), 6.) - 3.);
    const double strength = (std::min)((std::max)(distance - 1., 0.), 1.);
    colour[i] = static_cast<unsigned char>(brightness * (paleness + (1. - paleness) * strength));
  }
  return colour;
}

} // namespace htloops
