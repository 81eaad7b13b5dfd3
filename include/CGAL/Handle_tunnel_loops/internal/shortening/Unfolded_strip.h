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

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Funnel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/rounded_product.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The strip of triangles that a loop passes, and its layout in the plane. From round to round most
/// of its triangles stay, so each keeps its shape.
class Strip
{
public:
  /// An edge that the loop crosses, with the triangle ahead of it.
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

  /// lays out the given portals, beginning with number `start`.
  void assign(const std::vector<Portal>& portals, std::size_t start) {
    CGAL_precondition(start < portals.size());
    portals_.assign(portals.begin() + start, portals.end());
    portals_.insert(portals_.end(), portals.begin(), portals.begin() + start);
    lay_out();
  }

  std::size_t size() const { return portals_.size(); }
  const Portal& operator[](std::size_t i) const { return portals_[i]; }
  std::vector<Portal>::const_iterator begin() const { return portals_.begin(); }
  std::vector<Portal>::const_iterator end() const { return portals_.end(); }

  /// the ends of the portals in the plane; portal n is the first one again.
  const std::vector<Point_2>& left() const { return left_; }
  const std::vector<Point_2>& right() const { return right_; }

private:
  void lay_out() {
    const std::size_t n = portals_.size();
    left_.resize(n + 1);
    right_.resize(n + 1);
    Point_2 l = {0., 0.}, r = {0., -std::sqrt(squared_length(portals_[0].left, portals_[0].right))};
    for(std::size_t i = 0; i < n; ++i) {
      left_[i] = l;
      right_[i] = r;
      Portal& from = portals_[i];
      const Portal& to = portals_[i + 1 == n ? 0 : i + 1];
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

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_UNFOLDED_STRIP_H
