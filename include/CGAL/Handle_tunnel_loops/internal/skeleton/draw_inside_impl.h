// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_DRAW_INSIDE_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_DRAW_INSIDE_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/proof/Inlets.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Inside_test.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Segments_apart.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Chains_of_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_lines.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/draw_inside.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Own_frame.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>

#include <limits>

namespace CGAL::Handle_tunnel_loops::internal {

/// a drawing as a skeleton: first the nodes, then the bends arc by arc. The edges of an arc follow
/// each other.
inline Flat_skeleton
skeleton_of(const Flat_mesh& mesh, const Graph_of_parts& graph, const Inner_drawing& drawing) {
  Flat_skeleton flat;
  const auto add = [&](const Inner_ball& ball, Index component) {
    flat.points.push_back(ball.centre);
    flat.radii.push_back(ball.radius);
    flat.component_of.push_back(component);
    flat.is_inlet.push_back(0);
    return static_cast<Index>(flat.points.size() - 1);
  };
  for(Index n = 0; n < drawing.nodes.size(); ++n)
    add(drawing.nodes[n], mesh.component[graph.vertex_of_node[n]]);
  for(std::size_t a = 0; a < drawing.lines.size(); ++a) {
    const auto [lower, upper] = graph.arcs[a];
    Index before = lower;
    for(std::size_t i = 1; i < drawing.lines[a].size(); ++i) {
      const bool is_last = i + 1 == drawing.lines[a].size();
      const Index next = is_last ? upper : add(drawing.lines[a][i], flat.component_of[lower]);
      flat.edges.push_back({before, next});
      before = next;
    }
  }
  return flat;
}

/// finds out what of a drawing is inside, by exact predicates.
inline void test_drawing(Execution execution,
                         const Flat_mesh& mesh,
                         std::vector<Vector> places,
                         const Graph_of_parts& graph,
                         Inner_drawing& drawing) {
  const Flat_skeleton flat = skeleton_of(mesh, graph, drawing);
  const Inlets inlets(mesh, flat, places);
  const Face_tree tree(execution, mesh, span_of(places));
  const Inside_test::Outside outside =
      Inside_test(mesh, tree, inlets, flat).edges_outside(execution);
  Index edge = 0;
  drawing.is_inside.clear();
  for(const std::vector<Inner_ball>& line : drawing.lines) {
    drawing.is_inside.emplace_back();
    for(std::size_t i = 1; i < line.size(); ++i)
      drawing.is_inside.back().push_back(outside.count(edge++) == 0);
  }
  const Segments_apart apart(flat);
  drawing.is_embedded =
      apart.edges_without_length().empty() && apart.edges_that_meet(execution).empty();
}

CGAL_HTL_CORE Inner_drawing draw_inside(Execution execution,
                                        const Flat_mesh& mesh,
                                        const std::vector<Vector>& places,
                                        const Graph_of_parts& graph) {
  const Own_frame frame = Own_frame::of_caller(places);
  std::vector<Vector> points = places;
  for(Vector& p : points)
    p = frame.into(p);
  const Solid_balls solid(execution, mesh, span_of(points), {});
  const Ball_graph balls = solid.graph();
  const Chains_of_arcs chains(graph);
  Inner_drawing drawing = chains.cut(Part_lines(execution, solid, balls, chains.graph()).draw());
  drawing.number_of_balls = balls.balls.size();
  const auto complete = [&](Inner_ball& ball) {
    ball.radius = frame.length_out_of(
        solid.wall().nearest(ball.centre, std::numeric_limits<double>::infinity()).distance);
    ball.centre = frame.out_of(ball.centre);
  };
  for(Inner_ball& ball : drawing.nodes)
    complete(ball);
  for_each_index(
      execution, drawing.lines.size(),
      [&](std::size_t a) {
        for(Inner_ball& ball : drawing.lines[a])
          complete(ball);
      },
      4);
  test_drawing(execution, mesh, places, graph, drawing);
  return drawing;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_DRAW_INSIDE_IMPL_H
