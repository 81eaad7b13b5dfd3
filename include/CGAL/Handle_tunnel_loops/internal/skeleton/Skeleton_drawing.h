// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_DRAWING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_DRAWING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_curtains.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Out_of_frame.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Points_apart.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Skeleton_draft.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Arc_smoothing.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// makes points that an edge of no length joins one.
inline void contract_points(Flat_skeleton& flat) {
  const std::size_t n = flat.points.size();
  Sets_of_indices sets(n);
  for(const auto& [p, q] : flat.edges)
    if(flat.points[p] == flat.points[q])
      sets.unite(p, q);
  std::vector<Index> number(n);
  Index next = 0;
  for(Index p = 0; p < n; ++p) {
    if(const Index first = sets.find(p); first != p) {
      number[p] = number[first];
      continue;
    }
    number[p] = next;
    flat.points[next] = flat.points[p];
    flat.radii[next] = flat.radii[p];
    flat.component_of[next] = flat.component_of[p];
    flat.is_inlet[next] = flat.is_inlet[p];
    ++next;
  }
  flat.points.resize(next);
  flat.radii.resize(next);
  flat.component_of.resize(next);
  flat.is_inlet.resize(next);
  std::size_t kept = 0;
  for(const auto& [p, q] : flat.edges)
    if(number[p] != number[q])
      flat.edges[kept++] = {number[p], number[q]};
  flat.edges.resize(kept);
}

/// How much arcs are changed to be drawn; the less, the surer are their classes.
enum class Smoothness {
  none,
  in_class, ///< each stays in its class
  straight  ///< pulled straight first, also across what it leads around
};

/// Draws a draft: its arcs, as smooth as is wanted, with points that are apart.
class Skeleton_drawing
{
public:
  /// \p curtains are those of the loops that tell classes of lines.
  Skeleton_drawing(Execution execution, const Solid_balls& solid, const Loop_curtains& curtains)
      : execution_(execution)
      , solid_(solid)
      , curtains_(curtains) {}

  Flat_skeleton operator()(const Skeleton_draft& draft, Smoothness smoothness) const {
    Flat_skeleton flat = lines(draft, smoothness);
    contract_points(flat);
    Points_apart(execution_, solid_.wall()).move(flat, [](const Flat_skeleton& f) { return f; });
    measure_radii(execution_, solid_.wall(), flat);
    return flat;
  }

private:
  using Balls = Arc_smoothing::Balls;
  using Arcs = std::vector<std::vector<Index>>;

  // Nodes have the first numbers, and then come the points within arcs, in their order.
  Flat_skeleton lines(const Skeleton_draft& draft, Smoothness smoothness) const {
    Flat_skeleton flat;
    std::vector<Index> node(draft.size(), no_index);
    const auto add = [&](const Inner_ball& ball, const Skeleton_draft::Place& of, bool is_inlet) {
      flat.points.push_back(ball.centre);
      flat.radii.push_back(ball.radius);
      flat.component_of.push_back(of.component);
      flat.is_inlet.push_back(is_inlet);
      return static_cast<Index>(flat.points.size() - 1);
    };
    for(Index p = 0; p < draft.size(); ++p)
      if(draft.is_node(p) && draft[p].ball.radius >= 0.)
        node[p] = add(draft[p].ball, draft[p], draft[p].is_inlet);
    const Arcs arcs = draft.arcs();
    const std::vector<Balls> balls = balls_along(draft, arcs, smoothness);
    for(std::size_t i = 0; i < arcs.size(); ++i)
      if(const Index first = arcs[i].front(); node[first] == no_index) // of a cycle
        node[first] = add(balls[i].front(), draft[first], false);
    for(std::size_t i = 0; i < arcs.size(); ++i) {
      Index before = node[arcs[i].front()];
      for(std::size_t k = 1; k < balls[i].size(); ++k) {
        const Index next = k + 1 < balls[i].size() ? add(balls[i][k], draft[arcs[i].front()], false)
                                                   : node[arcs[i].back()];
        flat.edges.push_back({before, next});
        before = next;
      }
    }
    return flat;
  }

  std::vector<Balls>
  balls_along(const Skeleton_draft& draft, const Arcs& arcs, Smoothness smoothness) const {
    std::vector<Balls> balls(arcs.size());
    for_each_index(
        execution_, arcs.size(),
        [&](std::size_t i) {
          for(Index p : arcs[i])
            balls[i].push_back(draft[p].ball);
          if(smoothness == Smoothness::straight)
            balls[i] = smooth(balls[i], draft, arcs[i], true);
          if(smoothness == Smoothness::in_class)
            balls[i] = smooth_in_class(balls[i], draft, arcs[i]);
        },
        1);
    return balls;
  }

  Balls smooth(const Balls& balls,
               const Skeleton_draft& draft,
               const std::vector<Index>& arc,
               bool pulls_straight) const {
    const Arc_smoothing smoothing(solid_.wall(), solid_.balls(), solid_.least_extent(),
                                  pulls_straight);
    const Balls drawn = smoothing(balls, draft[arc.front()].is_inlet, draft[arc.back()].is_inlet);
    return draft.is_node(arc.front())
               ? drawn
               : smoothing(turned_by_half(drawn), false, false); // a cycle: also where it began
  }

  Balls smooth_in_class(const Balls& balls,
                        const Skeleton_draft& draft,
                        const std::vector<Index>& arc) const {
    for(const bool pulls_straight : {true, false})
      if(Balls drawn = smooth(balls, draft, arc, pulls_straight); curtains_.are_alike(drawn, balls))
        return drawn;
    return balls;
  }

  // The same cycle from another place.
  static Balls turned_by_half(Balls cycle) {
    cycle.pop_back();
    std::rotate(cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(cycle.size() / 2),
                cycle.end());
    cycle.push_back(cycle.front());
    return cycle;
  }

  Execution execution_;
  const Solid_balls& solid_;
  const Loop_curtains& curtains_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_DRAWING_H
