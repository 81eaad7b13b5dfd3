// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_GRID_H
#define HTL_WINDOW_GRID_H

#include "window.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace htl_window {

/// The box around all that is shown, in 65535 steps along each axis.
class Grid
{
public:
  using Place = std::array<std::int32_t, 3>;

  explicit Grid(const Scene& scene) {
    for(const Surface& surface : scene.surfaces)
      add(surface.points);
    for(const Line& line : scene.lines)
      add(line.points);
  }

  Place place_of(const Point& p) const {
    Place place{};
    for(int i = 0; i < 3; ++i)
      if(low_[i] < high_[i]) {
        // Halves, as an extent may be larger than the largest number.
        const double part = (p[i] / 2. - low_[i] / 2.) / (high_[i] / 2. - low_[i] / 2.);
        place[i] = static_cast<std::int32_t>(part * 65535. + 0.5);
      }
    return place;
  }

  /// the extents, the largest of which is 1 unless all is one point.
  Point size() const {
    Point half{};
    for(int i = 0; i < 3; ++i)
      half[i] = low_[i] < high_[i] ? high_[i] / 2. - low_[i] / 2. : 0.;
    const double largest = *std::max_element(half.begin(), half.end());
    return largest > 0. ? Point{half[0] / largest, half[1] / largest, half[2] / largest} : half;
  }

private:
  void add(const std::vector<Point>& points) {
    for(const Point& p : points)
      for(int i = 0; i < 3; ++i) {
        low_[i] = (std::min)(low_[i], p[i]);
        high_[i] = (std::max)(high_[i], p[i]);
      }
  }

  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  Point low_ = {infinity, infinity, infinity}, high_ = {-infinity, -infinity, -infinity};
};

} // namespace htl_window

#endif // HTL_WINDOW_GRID_H
