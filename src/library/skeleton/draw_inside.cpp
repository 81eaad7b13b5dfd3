// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/skeleton/draw_inside.h>

#include <CGAL/Handle_tunnel_loops/internal/proof/Inlets.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Inside_test.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Segments_apart.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Chains_of_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Linked_edges.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Loops_across.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Out_of_frame.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_lines.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Points_apart.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Own_frame.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// gives a bend to lines that would be the same segment as one before, so that they can be moved
/// apart.
static void bend_equal_segments(const Graph_of_parts& graph, Inner_drawing& drawing) {
  std::set<std::pair<Index, Index>> segments;
  for(std::size_t a = 0; a < drawing.lines.size(); ++a) {
    std::vector<Inner_ball>& line = drawing.lines[a];
    if(line.size() != 2 || segments.insert(std::minmax(graph.arcs[a][0], graph.arcs[a][1])).second)
      continue;
    const Inner_ball middle = {0.5 * (line[0].centre + line[1].centre),
                               (std::min)(line[0].radius, line[1].radius)};
    line.insert(line.begin() + 1, middle);
  }
}

/// a drawing as a skeleton: first the nodes, then the bends arc by arc. The edges of an arc follow
/// each other.
static Flat_skeleton
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

/// gives a skeleton that was made of a drawing back to it.
static void
take_places(const Flat_skeleton& flat, const Graph_of_parts& graph, Inner_drawing& drawing) {
  const auto ball = [&](Index p) { return Inner_ball{flat.points[p], flat.radii[p]}; };
  for(Index n = 0; n < drawing.nodes.size(); ++n)
    drawing.nodes[n] = ball(n);
  Index next = static_cast<Index>(drawing.nodes.size());
  for(std::size_t a = 0; a < drawing.lines.size(); ++a) {
    std::vector<Inner_ball>& line = drawing.lines[a];
    for(std::size_t i = 1; i + 1 < line.size(); ++i)
      line[i] = ball(next++);
    line.front() = drawing.nodes[graph.arcs[a][0]];
    line.back() = drawing.nodes[graph.arcs[a][1]];
  }
}

/// Draws a graph in the frame of the mesh itself, and tests what comes out on the coordinates of
/// the caller. Where this fails by rounding, it is done in the frame of the caller, where nothing
/// is rounded any more.
class Drawing_inside
{
public:
  Drawing_inside(Execution execution,
                 const Flat_mesh& mesh,
                 const std::vector<Vector>& places,
                 const std::vector<Flat_pair>& pairs,
                 const Graph_of_parts& graph)
      : execution_(execution)
      , mesh_(mesh)
      , places_(places)
      , pairs_(pairs)
      , graph_(graph)
      , chains_(graph) {}

  Inner_drawing draw(const Own_frame& frame) {
    if(!draw_in(frame, span_of(mesh_.points))) {
      const Own_frame frame_of_caller = Own_frame::of_caller(places_);
      std::vector<Vector> points = places_;
      for(Vector& p : points)
        p = frame_of_caller.into(p);
      draw_in(frame_of_caller, span_of(points));
    }
    return std::move(drawing_);
  }

private:
  // Returns whether it is no use to try in another frame.
  bool draw_in(const Own_frame& frame, Span<const Vector> points) {
    const Solid_balls solid(execution_, mesh_, points,
                            loops_inside(mesh_, pairs_, &Flat_pair::tunnel));
    const Loops_across across(mesh_, points, pairs_);
    Ball_graph balls = solid.graph();
    add_missing_ways(solid, balls, [&] {
      return Inner_cycles(execution_, balls, across).number_of_missing_cycles();
    });
    const Linked_edges linked(execution_, balls, across);
    drawing_ = chains_.cut(Part_lines(execution_, solid, balls, linked, chains_.graph()).draw());
    drawing_.number_of_balls = balls.balls.size();
    bend_equal_segments(graph_, drawing_);
    Flat_skeleton flat = skeleton_of(mesh_, graph_, drawing_);
    measure_radii(execution_, solid.wall(), flat);
    Points_apart(execution_, solid.wall()).move(flat, [&](Flat_skeleton turned) {
      for(Vector& p : turned.points)
        p = frame.out_of(p);
      return turned;
    });
    measure_radii(execution_, solid.wall(), flat);
    const bool is_inside = is_free(solid.wall(), flat);
    take_out_of(execution_, frame, solid, places_, flat);
    take_places(flat, graph_, drawing_);
    return test(flat) || !is_inside;
  }

  // By exact predicates. Returns whether all is inside.
  bool test(const Flat_skeleton& flat) {
    std::vector<Vector> places = places_;
    const Inlets inlets(mesh_, flat, places);
    const Face_tree tree(execution_, mesh_, span_of(places));
    const Inside_test::Outside outside =
        Inside_test(mesh_, tree, inlets, flat).edges_outside(execution_);
    Index edge = 0;
    drawing_.is_inside.clear();
    for(const std::vector<Inner_ball>& line : drawing_.lines) {
      drawing_.is_inside.emplace_back();
      for(std::size_t i = 1; i < line.size(); ++i)
        drawing_.is_inside.back().push_back(outside.count(edge++) == 0);
    }
    const Segments_apart apart(flat);
    drawing_.is_embedded =
        apart.edges_without_length().empty() && apart.edges_that_meet(execution_).empty();
    return outside.empty();
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  const std::vector<Vector>& places_;
  const std::vector<Flat_pair>& pairs_;
  const Graph_of_parts& graph_;
  Chains_of_arcs chains_;
  Inner_drawing drawing_;
};

Inner_drawing draw_inside(Execution execution,
                          const Flat_mesh& mesh,
                          const Own_frame& frame,
                          const std::vector<Vector>& places,
                          const std::vector<Flat_pair>& pairs,
                          const Graph_of_parts& graph) {
  return Drawing_inside(execution, mesh, places, pairs, graph).draw(frame);
}

} // namespace CGAL::Handle_tunnel_loops::internal
