// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_FIND_BREADTHS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_FIND_BREADTHS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_samples.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
finds how far balls are from the rim of the sheet that they are in the middle of: in plates and in
the walls of tubes all balls are alike, but there is a middle all the same.

At a rim, balls can be moved away from their places. Or the surface bends around a ball, as in a
rod, which is all rim: places beside each other have the same one. Where the solid is thin against
the regions of places, those on its two sides meet at the rim. Distances are measured along the
graph.
*/
inline void find_breadths(const Surface_samples& samples,
                          const std::vector<std::pair<Index, Index>>& neighbors,
                          Ball_graph& graph) {
  struct Label
  {
    double distance = (std::numeric_limits<double>::infinity)();
  };
  constexpr double cosine = 0.8;
  Shortest_paths<Label> paths(graph.balls.size());
  const auto begin_at = [&](Index s) {
    const Index b = graph.ball_of_sample[s];
    if(!paths.is_reached(b))
      paths.reach(b, {graph.balls[b].radius});
  };
  const auto from_ball = [&](Index s) {
    return samples.place(s) - graph.balls[graph.ball_of_sample[s]].centre;
  };
  for(Index s = 0; s < graph.ball_of_sample.size(); ++s)
    if(graph.is_at_rim[s] != 0)
      begin_at(s);
  for(const auto& [s, t] : neighbors)
    if(graph.ball_of_sample[s] == graph.ball_of_sample[t]) {
      const Vector a = from_ball(s), b = from_ball(t);
      if(dot(a, b) < cosine * norm(a) * norm(b))
        begin_at(s);
    }
  std::vector<std::pair<Index, Index>> meet;
  std::set_intersection(neighbors.begin(), neighbors.end(), graph.opposites.begin(),
                        graph.opposites.end(), std::back_inserter(meet));
  for(const auto& [s, t] : meet)
    for(Index end : {s, t})
      begin_at(end);
  graph.grow(
      paths, [&](Index e) { return graph.length(e); },
      [](const Label&, double distance, Index) { return Label{distance}; });
  for(Index b = 0; b < graph.balls.size(); ++b)
    graph.breadths.push_back(paths.is_reached(b) ? paths[b].distance : 0.);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_FIND_BREADTHS_H
