// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LOOP_CURTAINS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LOOP_CURTAINS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Inner_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sorted_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
How segments pass through curtains that hang from closed polylines: the linking number of a closed
curve with such a loop is how often it passes through the curtain of the loop, counted with sign. So
these numbers of edges add up to those of all cycles of a graph.

Curtains rise without end along a fixed direction that is likely to be in general position. Numbers
are computed, not proved: they choose cycles, of which the certificate is another matter.
*/
class Loop_curtains
{
public:
  struct Passage
  {
    Index loop;
    int sign;
  };

  Loop_curtains(Execution execution, const std::vector<std::vector<Vector>>& loops)
      : number_of_loops_(loops.size()) {
    for(std::size_t l = 0; l < loops.size(); ++l)
      for(std::size_t i = 0; i < loops[l].size(); ++i)
        hems_.push_back({project(loops[l][i]),
                         project(loops[l][i + 1 < loops[l].size() ? i + 1 : 0]),
                         static_cast<Index>(l)});
    std::vector<Box<2>> boxes;
    for(const Hem& hem : hems_)
      boxes.push_back(box(hem.from, hem.to));
    boxes_.emplace(execution, boxes);
  }

  /// calls `f(passage)` for each time that a segment passes through a curtain.
  template <typename Function>
  void for_each_passage(const Vector& a, const Vector& b, const Function& f) const {
    const Place p = project(a), q = project(b);
    boxes_->for_each_meeting(box(p, q), [&](Index i, const Box<2>&) {
      const Hem& hem = hems_[i];
      const int side = turn(hem.from, hem.to, p);
      if(side == turn(hem.from, hem.to, q) || turn(p, q, hem.from) == turn(p, q, hem.to))
        return;
      if(is_above(p, q, hem))
        f(Passage{hem.loop, side});
    });
  }

  /// whether two lines with the same ends, or two closed ones, are linked with all loops in the
  /// same way.
  bool are_alike(const std::vector<Inner_ball>& line, const std::vector<Inner_ball>& other) const {
    std::vector<int> row(number_of_loops_, 0);
    const auto add = [&](const std::vector<Inner_ball>& of, int factor) {
      for(std::size_t i = 1; i < of.size(); ++i)
        for_each_passage(of[i - 1].centre, of[i].centre,
                         [&](const Passage& p) { row[p.loop] += factor * p.sign; });
    };
    add(line, 1);
    add(other, -1);
    return std::all_of(row.begin(), row.end(), [](int x) { return x == 0; });
  }

private:
  struct Place
  {
    double x, y, height;
  };
  struct Hem
  {
    Place from, to;
    Index loop;
  };

  static Place project(const Vector& p) {
    constexpr double tilt_x = 0.1827364501, tilt_y = -0.3172648591;
    return {p[0] - tilt_x * p[2], p[1] - tilt_y * p[2], p[2]};
  }

  static Box<2> box(const Place& a, const Place& b) {
    Box<2> box = {{a.x, a.y}, {a.x, a.y}};
    box.extend({{b.x, b.y}, {b.x, b.y}});
    return box;
  }

  // Exact for the rounded places. Three in a line are taken to turn to the right, whatever the
  // order of the first two: a curve through a place crosses a line through it once or not at all.
  static int turn(const Place& a, const Place& b, const Place& c) {
    using Seen_point = Exact_predicates_inexact_constructions_kernel::Point_2;
    return CGAL::orientation(Seen_point(a.x, a.y), Seen_point(b.x, b.y), Seen_point(c.x, c.y)) ==
                   CGAL::LEFT_TURN
               ? 1
               : -1;
  }

  static bool is_above(const Place& p, const Place& q, const Hem& hem) {
    const double ux = q.x - p.x, uy = q.y - p.y, vx = hem.to.x - hem.from.x,
                 vy = hem.to.y - hem.from.y, wx = hem.from.x - p.x, wy = hem.from.y - p.y;
    const double det = ux * vy - uy * vx;
    const double s = (wx * vy - wy * vx) / det, t = (wx * uy - wy * ux) / det;
    return p.height + s * (q.height - p.height) >
           hem.from.height + t * (hem.to.height - hem.from.height);
  }

  std::size_t number_of_loops_;
  std::vector<Hem> hems_;
  std::optional<Sorted_boxes<2>> boxes_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LOOP_CURTAINS_H
