// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_CURTAINS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_CURTAINS_H

#include <CGAL/license/Handle_tunnel_loops.h>

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
    cells_ = Occupied_cells(boxes);
    boxes_.emplace(execution, boxes);
  }

  /// calls `f(passage)` for each time that a segment passes through a curtain.
  template <typename Function>
  void for_each_passage(const Vector& a, const Vector& b, const Function& f) const {
    const Place p = project(a), q = project(b);
    if(!cells_.may_meet(box(p, q)))
      return;
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
  template <typename Balls> bool are_alike(const Balls& line, const Balls& other) const {
    std::vector<int> row(number_of_loops_, 0);
    const auto add = [&](const Balls& of, int factor) {
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

  /// Which squares of the plane meet boxes: most of what is asked for meets none.
  class Occupied_cells
  {
  public:
    Occupied_cells() = default;

    explicit Occupied_cells(const std::vector<Box<2>>& boxes)
        : all_(Box<2>::empty()) {
      for(const Box<2>& box : boxes)
        all_.extend(box);
      while(size_ < most_cells && size_ * size_ < cells_per_box * boxes.size())
        size_ *= 2;
      is_occupied_.assign(size_ * size_, 0);
      for(const Box<2>& box : boxes) {
        const auto [x, u] = cells(box, 0);
        const auto [y, v] = cells(box, 1);
        for(std::size_t row = y; row <= v; ++row)
          for(std::size_t i = x; i <= u; ++i)
            is_occupied_[row * size_ + i] = 1;
      }
    }

    /// says no only if it meets none; of what is large, nothing is said.
    bool may_meet(const Box<2>& box) const {
      if(!all_.meets(box))
        return false;
      const auto [x, u] = cells(box, 0);
      const auto [y, v] = cells(box, 1);
      if(u - x > 1 || v - y > 1)
        return true;
      return (is_occupied_[y * size_ + x] | is_occupied_[y * size_ + u] |
              is_occupied_[v * size_ + x] | is_occupied_[v * size_ + u]) != 0;
    }

  private:
    static constexpr std::size_t most_cells = 2048, cells_per_box = 64;

    // The first and the last along an axis.
    std::array<std::size_t, 2> cells(const Box<2>& box, std::size_t axis) const {
      const auto cell = [&](double x) {
        const double part = (std::max)(0., all_.part(axis, x));
        return (std::min)(static_cast<std::size_t>(part * static_cast<double>(size_)), size_ - 1);
      };
      return {cell(box.low[axis]), cell(box.high[axis])};
    }

    Box<2> all_ = Box<2>::empty();
    std::size_t size_ = 64; // cells along each axis
    std::vector<char> is_occupied_;
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
  Occupied_cells cells_;
  std::optional<Sorted_boxes<2>> boxes_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_CURTAINS_H
