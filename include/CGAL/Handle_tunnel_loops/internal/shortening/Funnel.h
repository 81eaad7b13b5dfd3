// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_FUNNEL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_FUNNEL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/rounded_product.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

using Point_2 = std::array<double, 2>;

inline Point_2 minus(const Point_2& a, const Point_2& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline double cross(const Point_2& a, const Point_2& b) {
  return rounded_product(a[0], b[1]) - rounded_product(a[1], b[0]);
}
inline double dot(const Point_2& a, const Point_2& b) {
  return rounded_product(a[0], b[0]) + rounded_product(a[1], b[1]);
}

/// The shortest path through portals that are laid out in the plane, by the algorithm of Lee and
/// Preparata. Each corner enters the funnel once and leaves it once.
class Funnel
{
public:
  /// Where the path turns: an end of a portal, by the number of the first portal that has it.
  struct Bend
  {
    std::uint32_t portal;
    Point_2 point;
  };

  enum Side { LEFT, RIGHT };

  /// begins a path.
  void start(const Bend& from) {
    bends_.clear();
    bends_.push_back(from);
    for(Chain& chain : chains_)
      chain.clear();
  }

  /// lets one side of the funnel end at `corner`. Where that lies beyond the other side, the path
  /// turns around the corners there. Corners that it passes straight ahead count as well: there too
  /// the way around the other side may be shorter.
  void narrow(Side side, const Bend& corner) {
    Chain& chain = chains_[side];
    const double sign = side == LEFT ? 1. : -1.;
    std::vector<Bend>& corners = chain.corners;
    CGAL_precondition_msg(!bends_.empty(), "after `start()`");
    if(corner.point == (chain.is_empty() ? bends_ : corners).back().point)
      return;
    while(!chain.is_empty() &&
          !passes(chain.first + 1 == corners.size() ? bends_.back() : corners[corners.size() - 2],
                  corners.back(), corner, sign))
      corners.pop_back();
    if(chain.is_empty()) {
      Chain& other = chains_[1 - side];
      while(!other.is_empty() && passes(bends_.back(), other.corners[other.first], corner, -sign))
        bends_.push_back(other.corners[other.first++]);
    }
    corners.push_back(corner);
  }

  /// ends the path.
  void finish(const Bend& goal) {
    narrow(LEFT, goal);
    bends_.insert(bends_.end(), chains_[LEFT].corners.begin() + chains_[LEFT].first,
                  chains_[LEFT].corners.end());
    if(bends_.back().portal != goal.portal)
      bends_.push_back(goal);
    CGAL_expensive_postcondition(
        std::is_sorted(bends_.begin(), bends_.end(),
                       [](const Bend& a, const Bend& b) { return a.portal < b.portal; }));
  }

  /// the corners of the path, with its ends.
  const std::vector<Bend>& bends() const { return bends_; }

  double length() const {
    double sum = 0.;
    for(std::size_t b = 1; b < bends_.size(); ++b) {
      const Point_2 step = minus(bends_[b].point, bends_[b - 1].point);
      sum += std::sqrt(dot(step, step));
    }
    return sum;
  }

private:
  // One side of the funnel: the corners that a path from the apex, the last of `bends_`, would turn
  // around on its way to the last of them.
  struct Chain
  {
    std::vector<Bend> corners;
    std::size_t first = 0;

    void clear() {
      corners.clear();
      first = 0;
    }
    bool is_empty() const { return first == corners.size(); }
  };

  // Whether the shortest path to `to` that stays to the right of `by` (sign 1) or to the left of it
  // (-1) touches it.
  static bool passes(const Bend& from, const Bend& by, const Bend& to, double sign) {
    const Point_2 first = minus(by.point, from.point), second = minus(to.point, by.point);
    const double turn = sign * cross(first, second);
    return turn > 0. || (turn == 0. && dot(first, second) >= 0.);
  }

  std::vector<Bend> bends_;
  Chain chains_[2];
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_FUNNEL_H
