// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_UNFOLDED_STRIP_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_UNFOLDED_STRIP_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

/// The strip of triangles that a loop or a way passes, and its layout in the plane. From round to
/// round most of its triangles stay, so each keeps its shape.
class Strip
{
public:
  /// An edge that is crossed, with the triangle ahead of it.
  struct Portal
  {
    Index left, right;
    Index place = 0;       ///< its number in the last layout, or one of those below
    Index apex = no_index; ///< of the triangle whose shape is known
    double along = 0.;     ///< the shape: where the apex is, from left to right
    double ahead = 0.;     ///< and across; negative if the edge has no length to speak of
  };

  /// in place of a number: the portal is new, and the loop crosses it at this end.
  static constexpr Index new_at_left = no_index - 1, new_at_right = no_index;

  explicit Strip(const Flat_mesh& mesh)
      : mesh_(mesh) {}

  /// lays out the portals of a loop, beginning with number `start`.
  void assign_loop(const std::vector<Portal>& portals, std::size_t start) {
    CGAL_precondition(start < portals.size());
    portals_.assign(portals.begin() + start, portals.end());
    portals_.insert(portals_.end(), portals.begin(), portals.begin() + start);
    lay_out(portals_.size());
  }

  /// lays out the portals of a way, which ends on the last one.
  void assign_way(const std::vector<Portal>& portals) {
    CGAL_precondition(!portals.empty());
    portals_ = portals;
    lay_out(portals_.size() - 1);
  }

  std::size_t size() const { return portals_.size(); }
  const Portal& operator[](std::size_t i) const { return portals_[i]; }
  std::vector<Portal>::const_iterator begin() const { return portals_.begin(); }
  std::vector<Portal>::const_iterator end() const { return portals_.end(); }

  /// the ends of the portals in the plane; after the last one of a loop comes the first again.
  const std::vector<Point_2>& left() const { return left_; }
  const std::vector<Point_2>& right() const { return right_; }

private:
  // As many triangles, each ahead of a portal.
  void lay_out(std::size_t n) {
    left_.resize(n + 1);
    right_.resize(n + 1);
    Point_2 l = {0., 0.}, r = {0., -std::sqrt(squared_length(portals_[0].left, portals_[0].right))};
    for(std::size_t i = 0; i < n; ++i) {
      left_[i] = l;
      right_[i] = r;
      Portal& from = portals_[i];
      const Portal& to = portals_[i + 1 == portals_.size() ? 0 : i + 1];
      const bool keeps_left = to.left == from.left;
      CGAL_assertion_msg(keeps_left || to.right == from.right, "portals lie in one triangle");
      const Index apex = keeps_left ? to.right : to.left;
      from.place = static_cast<Index>(i);
      if(from.apex != apex)
        set_shape(from, apex);
      const Point_2 p = apex_position(l, r, from);
      (keeps_left ? r : l) = p;
    }
    left_[n] = l;
    right_[n] = r;
    if(n < portals_.size())
      portals_[n].place = static_cast<Index>(n);
  }

  // Of lengths in the unit box. With smaller ones, quotients are not in the range of numbers.
  static constexpr double smallest_square = 1e-140;

  double squared_length(Index u, Index v) const {
    const Vector e = mesh_.points[v] - mesh_.points[u];
    return dot(e, e);
  }

  void set_shape(Portal& portal, Index apex) const {
    const double base = squared_length(portal.left, portal.right);
    const double to_left = squared_length(portal.left, apex);
    const double to_right = squared_length(portal.right, apex);
    portal.apex = apex;
    if(base < smallest_square) {
      portal.along = std::sqrt(to_left);
      portal.ahead = -1.;
    } else {
      portal.along = 0.5 * (to_left - to_right + base) / base;
      portal.ahead =
          std::sqrt((std::max)(0., to_left / base - rounded_product(portal.along, portal.along)));
    }
  }

  // Heading along +x, with l above r, the apex is ahead.
  static Point_2 apex_position(const Point_2& l, const Point_2& r, const Portal& portal) {
    if(portal.ahead < 0.)
      return {l[0] + portal.along, l[1]};
    const Point_2 d = minus(r, l);
    return {l[0] + rounded_product(portal.along, d[0]) - rounded_product(portal.ahead, d[1]),
            l[1] + rounded_product(portal.along, d[1]) + rounded_product(portal.ahead, d[0])};
  }

  const Flat_mesh& mesh_;
  std::vector<Portal> portals_;
  std::vector<Point_2> left_, right_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_UNFOLDED_STRIP_H
