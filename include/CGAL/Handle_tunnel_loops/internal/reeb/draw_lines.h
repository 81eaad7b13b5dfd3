// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_DRAW_LINES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_DRAW_LINES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/mean_edge_length.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Embedded_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_embedding.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/lead_inside.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/lengths_outside.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// rounds off the steps of a polyline; the ends stay.
inline void smooth(Polyline& line, int number_of_rounds) {
  for(int round = 0; round < number_of_rounds; ++round) {
    Vector before = line.front();
    for(std::size_t i = 1; i + 1 < line.size(); ++i) {
      const Vector old = line[i];
      line[i] = 0.25 * (before + line[i + 1]) + 0.5 * old;
      before = old;
    }
  }
}

constexpr int rounds_of_smoothing = 10;

/// rounds off the steps of the lines; where that takes a line outside, less, or not at all.
inline void round_off(Execution execution,
                      const Flat_mesh& mesh,
                      double spacing,
                      std::vector<Polyline>& lines) {
  constexpr int fewer_rounds[] = {3, 0};
  constexpr double gain = 0.8; // of the length outside is left at most, where a line is less round
  const std::vector<Polyline> edged = lines;
  for_each_index(
      execution, lines.size(), [&](std::size_t i) { smooth(lines[i], rounds_of_smoothing); }, 256);
  const std::vector<double> outside = lengths_outside(execution, mesh, lines, spacing);
  std::vector<Polyline> others;
  for(std::size_t i = 0; i < lines.size(); ++i)
    if(outside[i] > 0.)
      for(const int rounds : fewer_rounds) {
        others.push_back(edged[i]);
        smooth(others.back(), rounds);
      }
  const std::vector<double> others_outside = lengths_outside(execution, mesh, others, spacing);
  std::size_t next = 0;
  for(std::size_t i = 0; i < lines.size(); ++i)
    if(outside[i] > 0.) {
      double least = outside[i];
      for(std::size_t j = next; j < next + std::size(fewer_rounds); ++j)
        if(others_outside[j] < gain * least) {
          least = others_outside[j];
          lines[i] = std::move(others[j]);
        }
      next += std::size(fewer_rounds);
    }
}

/// what is drawn of saddles and along arcs goes inside, where it is not.
inline void lead_inside(Execution execution,
                        const Flat_mesh& mesh,
                        const Sweep_order& order,
                        std::vector<Flat_reeb_graph::Node>& nodes,
                        std::vector<Reeb_means>& all_means) {
  std::vector<Index> vertices;
  std::vector<Vector> points;
  const auto add = [&](Index vertex, const Vector& point) {
    vertices.push_back(vertex);
    points.push_back(point);
  };
  for(const Flat_reeb_graph::Node& node : nodes)
    if(node.kind == Node_kind::SADDLE)
      add(node.vertex, node.position);
  for(const Reeb_means& means : all_means)
    for(const Reeb_mean& mean : means)
      add(mean.vertex, to_vector(mean.position));
  lead_inside(execution, mesh, order, vertices, points);
  auto point = points.begin();
  for(Flat_reeb_graph::Node& node : nodes)
    if(node.kind == Node_kind::SADDLE)
      node.position = *point++;
  for(Reeb_means& means : all_means)
    for(Reeb_mean& mean : means)
      mean.position = to_float_point(*point++);
}

/// whether there are so many means that the function must be noise, which nobody looks at.
inline bool are_means_of_noise(const Flat_mesh& mesh, const std::vector<Reeb_means>& means) {
  std::size_t number = means.size();
  for(const Reeb_means& some : means)
    number += some.size();
  return number > mesh.number_of_vertices() / 8 + 1000;
}

/// Draws the lines of a graph, inside of the solid as far as may be. What is inside already stays
/// where it is, and so does all where the function is noise.
inline void draw_lines(Execution execution,
                       const Flat_mesh& mesh,
                       const Sweep_order& order,
                       Undrawn_reeb_graph& undrawn) {
  Embedded_reeb_graph& graph = undrawn.graph;
  const bool is_noise = are_means_of_noise(mesh, undrawn.means);
  if(!is_noise)
    lead_inside(execution, mesh, order, graph.nodes, undrawn.means);
  std::vector<Polyline> lines(graph.arcs.size());
  for(std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].push_back(graph.nodes[graph.arcs[i].lower].position);
    for(const Reeb_mean& mean : undrawn.means[i])
      lines[i].push_back(to_vector(mean.position));
    lines[i].push_back(graph.nodes[graph.arcs[i].upper].position);
  }
  if(!is_noise)
    round_off(execution, mesh, mean_edge_length(mesh), lines);
  else
    for_each_index(
        execution, lines.size(), [&](std::size_t i) { smooth(lines[i], rounds_of_smoothing); },
        256);
  for(std::size_t i = 0; i < lines.size(); ++i)
    graph.arcs[i].line = std::move(lines[i]);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_DRAW_LINES_H
