// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EVEN_AXES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EVEN_AXES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Scales the axes of points so that most of them spread about as far along each: what is squeezed
/// to a line, or nearly, is seen from the side then. The axes are scaled by powers of two, and not
/// so far that this is not exact, so that whatever linear maps leave as it is stays the same.
class Even_axes
{
public:
  explicit Even_axes(std::vector<Vector>& points)
      : points_(points)
      , numbers_(points.size()) {}

  void scale() {
    for(int d = 0; d < 3; ++d)
      if(const int exponent = allowed(d, -exponent_of(spread(d))); exponent != 0)
        for(Vector& p : points_)
          p[d] = std::ldexp(p[d], exponent);
  }

private:
  static int exponent_of(double x) {
    int exponent = 0;
    std::frexp(x, &exponent);
    return exponent;
  }

  // The median distance to the median, or if this is zero the largest.
  double spread(int d) {
    const auto take_all = [&](double from) {
      for(std::size_t i = 0; i < points_.size(); ++i)
        numbers_[i] = std::abs(points_[i][d] / 2. - from);
    };
    if(points_.empty())
      return 0.;
    for(std::size_t i = 0; i < points_.size(); ++i)
      numbers_[i] = points_[i][d] / 2.;
    take_all(median());
    const double distance = median();
    return distance > 0. ? distance : *std::max_element(numbers_.begin(), numbers_.end());
  }

  double median() {
    const auto middle = numbers_.begin() + numbers_.size() / 2;
    std::nth_element(numbers_.begin(), middle, numbers_.end());
    return *middle;
  }

  // The exponent that is nearest to the wanted one and lets all bits of all numbers survive.
  int allowed(int d, int wanted) const {
    int lowest = INT_MAX, highest = INT_MIN;
    for(const Vector& p : points_)
      if(p[d] != 0.) {
        lowest = (std::min)(lowest, exponent_of(p[d]));
        highest = (std::max)(highest, exponent_of(p[d]));
      }
    if(lowest > highest)
      return 0;
    constexpr int largest = 1000, smallest = -960;
    return (std::min)((std::max)(wanted, (std::min)(0, smallest - lowest)),
                      (std::max)(0, largest - highest));
  }

  std::vector<Vector>& points_;
  std::vector<double> numbers_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EVEN_AXES_H
