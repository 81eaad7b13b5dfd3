// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_POINT_MERGER_H
#define HTLOOPS_POINT_MERGER_H

#include "mesh_types.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace htloops {

/// Numbers different points as they come. A table with open addressing: most of the time of reading
/// an STL file goes here.
class Point_merger
{
public:
  Point_merger();

  /// the number of a point, a new one if it has not come yet. Bits are compared, but for
  /// the two zeros. A point that is nowhere, as a coordinate is infinite or not a number, is at the
  /// place of no other.
  std::uint32_t number(const Point& point);

  /// the points by their numbers, which are taken away.
  std::vector<Point> take_points() { return std::move(points_); }

private:
  std::size_t slot_of(const Point& point) const;
  void grow();

  std::vector<Point> points_;
  std::vector<std::uint32_t> slots_; // numbers of points; a power of two of them
};

} // namespace htloops

#endif // HTLOOPS_POINT_MERGER_H
