// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_INLET_WAYS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_INLET_WAYS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_samples.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Leads ways from the middles of boundary curves to the nearest balls of what is beside the
/// curves.
class Inlet_ways
{
public:
  Inlet_ways(const Flat_mesh& mesh,
             Span<const Vector> points,
             const Wall& wall,
             const Surface_pieces& pieces,
             const Surface_samples& samples)
      : mesh_(mesh)
      , points_(points)
      , wall_(wall)
      , pieces_(pieces)
      , samples_(samples) {}

  /// adds them to a graph. Returns the ends. A curve has none if nothing is to be seen from its
  /// middle.
  std::vector<Index> add(Ball_graph& graph) const {
    std::vector<Index> ends;
    for(Index hub = mesh_.first_hub; hub < mesh_.number_of_vertices(); ++hub) {
      const Index ball = ball_seen_from(hub, graph);
      if(ball == no_index)
        continue;
      ends.push_back(static_cast<Index>(graph.balls.size()));
      graph.balls.push_back({points_[hub], distance_to_curve(hub)});
      graph.component.push_back(mesh_.component[hub]);
      graph.is_inlet.push_back(1);
      graph.edges.push_back({ball, ends.back()});
    }
    if(!ends.empty())
      graph.link();
    return ends;
  }

private:
  // Of those at the curve, or else of those beside them, and so on.
  Index ball_seen_from(Index hub, const Ball_graph& graph) const {
    const auto distance = [&](Index b) { return norm(graph.balls[b].centre - points_[hub]); };
    std::vector<Index> balls = balls_at_curve(hub, graph);
    std::unordered_set<Index> known;
    while(!balls.empty()) {
      std::stable_sort(balls.begin(), balls.end(),
                       [&](Index a, Index b) { return distance(a) < distance(b); });
      for(Index b : balls)
        if(!wall_.is_met_from_hub(hub, graph.balls[b].centre))
          return b;
      known.insert(balls.begin(), balls.end());
      std::vector<Index> next;
      for(Index ball : balls)
        graph.for_each_beside(ball, [&](Index other, Index) {
          if(known.insert(other).second)
            next.push_back(other);
        });
      balls = std::move(next);
    }
    return no_index;
  }

  std::vector<Index> balls_at_curve(Index hub, const Ball_graph& graph) const {
    std::vector<Index> balls;
    for(Index v : mesh_.ring(hub))
      for(Index u : mesh_.ring(v))
        if(const Index f = pieces_.face_left_of(v, u); !wall_.is_of_cap(f))
          if(const Index s = samples_.region(pieces_.piece_at(f, points_[v])); s != no_index)
            balls.push_back(graph.ball_of_sample[s]);
    std::sort(balls.begin(), balls.end());
    balls.erase(std::unique(balls.begin(), balls.end()), balls.end());
    return balls;
  }

  double distance_to_curve(Index hub) const {
    double least = std::numeric_limits<double>::infinity();
    const Ring curve = mesh_.ring(hub);
    for(Index i = 0; i < curve.size(); ++i) {
      const Vector &a = points_[curve[i]], &b = points_[curve[curve.next(i)]];
      least = (std::min)(least, norm(nearest_point(points_[hub], a, b, b) - points_[hub]));
    }
    return least;
  }

  const Flat_mesh& mesh_;
  Span<const Vector> points_;
  const Wall& wall_;
  const Surface_pieces& pieces_;
  const Surface_samples& samples_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_INLET_WAYS_H
