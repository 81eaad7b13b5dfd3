// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOP_DISTANCE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOP_DISTANCE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangle_contact.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Measures how far a loop is from others: the mean distance of its points, against a quarter of
/// its length. A few points tell as much as all.
class Loop_distance
{
public:
  Loop_distance(const std::vector<Surgery_mesh::Point>& points, double length)
      : quarter_(length / 4.) {
    const std::size_t step = 1 + points.size() / number_of_points;
    Surgery_mesh::Kernel::Vector_3 sum(NULL_VECTOR);
    for(std::size_t i = 0; i < points.size(); i += step) {
      points_.push_back(points[i]);
      sum = sum + (points[i] - ORIGIN);
    }
    middle_ = ORIGIN + sum / static_cast<double>(points_.size());
  }

  /// from another loop.
  double operator()(const Surgery_mesh& mesh, const Loop_choice& other) const {
    const std::size_t step = step_of(other);
    double sum = 0.;
    for(const Surgery_mesh::Point& point : points_) {
      double least = (std::numeric_limits<double>::infinity)();
      for(std::size_t j = 0; j < other.places.size(); j += step)
        least = (std::min)(least, CGAL::squared_distance(point, point_at(mesh, other.places[j])));
      sum += std::sqrt(least);
    }
    return sum / (static_cast<double>(points_.size()) * quarter_);
  }

  /// no more than that from a loop in a box: the middle of some points is no further from what is
  /// convex than they are on average.
  double bound(const Box<3>& box) const {
    constexpr double rounding = 1e-9;
    double sum = 0.;
    for(int d = 0; d < 3; ++d) {
      const double x = middle_[d];
      const double apart = (std::max)({0., box.low[d] - x, x - box.high[d]});
      sum += apart * apart;
    }
    return (std::max)(0., std::sqrt(sum) / quarter_ - rounding);
  }

  /// of a loop.
  static Box<3> box(const Surgery_mesh& mesh, const Loop_choice& loop) {
    Box<3> box = Box<3>::empty();
    for(std::size_t j = 0; j < loop.places.size(); j += step_of(loop))
      box.extend(box_at(point_at(mesh, loop.places[j])));
    return box;
  }

private:
  static constexpr std::size_t number_of_points = 32;

  static std::size_t step_of(const Loop_choice& other) {
    return 1 + other.places.size() / (4 * number_of_points);
  }

  std::vector<Surgery_mesh::Point> points_;
  Surgery_mesh::Point middle_;
  double quarter_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOP_DISTANCE_H
