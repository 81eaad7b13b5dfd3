// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PARTS_OF_SURFACE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PARTS_OF_SURFACE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sorted_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Finds out to which point of a skeleton each vertex belongs: the nearest one to its ball, inside.
class Parts_of_surface
{
public:
  Parts_of_surface(Execution execution,
                   const Solid_balls& solid,
                   const Ball_graph& graph,
                   const Flat_skeleton& flat)
      : execution_(execution)
      , solid_(solid)
      , graph_(graph)
      , flat_(flat)
      , paths_(graph.balls.size()) {
    start();
    graph.grow(
        paths_, [&](Index e) { return graph.length(e); },
        [](const Label& before, double distance, Index) {
          return Label{distance, before.point};
        });
  }

  /// by vertex; hubs belong to none.
  std::vector<Index> points() const {
    const Flat_mesh& mesh = solid_.mesh();
    const std::vector<Index> first = first_points();
    std::vector<Index> points(mesh.number_of_vertices(), no_index);
    for_each_index(execution_, mesh.first_hub, [&](std::size_t i) {
      const Index v = static_cast<Index>(i), sample = solid_.sample_at(v);
      if(sample != no_index)
        points[v] = paths_[graph_.ball_of_sample[sample]].point;
      if(points[v] == no_index)
        points[v] = first[mesh.component[v]];
    });
    return points;
  }

private:
  struct Label
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index point = no_index;
  };

  // By component, of those that have any.
  std::vector<Index> first_points() const {
    std::vector<Index> first(solid_.mesh().seeds.size(), no_index);
    for(Index p = 0; p < flat_.component_of.size(); ++p)
      if(Index& known = first[flat_.component_of[p]]; known == no_index)
        known = p;
    return first;
  }

  // Balls that hold a point of the skeleton begin with the nearest of these, the first of several.
  void start() {
    std::vector<Box<3>> boxes;
    for(const Vector& p : flat_.points)
      boxes.push_back({p, p});
    const Sorted_boxes<3> sorted(execution_, boxes);
    for(Index b = 0; b < graph_.balls.size(); ++b) {
      const Inner_ball& ball = graph_.balls[b];
      const Vector corner = {ball.radius, ball.radius, ball.radius};
      Label best;
      sorted.for_each_meeting(
          {ball.centre - corner, ball.centre + corner}, [&](Index p, const Box<3>& box) {
            const double distance = norm(box.low - ball.centre);
            if(flat_.component_of[p] == graph_.component[b] && distance < ball.radius &&
               std::tie(distance, p) < std::tie(best.distance, best.point))
              best = {distance, p};
          });
      if(best.point != no_index)
        paths_.reach(b, best);
    }
  }

  Execution execution_;
  const Solid_balls& solid_;
  const Ball_graph& graph_;
  const Flat_skeleton& flat_;
  Shortest_paths<Label> paths_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PARTS_OF_SURFACE_H
