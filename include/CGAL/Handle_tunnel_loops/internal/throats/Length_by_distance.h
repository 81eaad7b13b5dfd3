// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_LENGTH_BY_DISTANCE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_LENGTH_BY_DISTANCE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
How long the contours of a distance are: means over bins, which are as wide as a part of a size, and
far away as a part of the distance. So the means do not know how fine the mesh is.
*/
class Length_by_distance
{
public:
  void start(double size) {
    size_ = size;
    bins_.clear();
  }

  double size() const { return size_; }
  std::size_t number_of_bins() const { return bins_.size(); }

  /// where a bin begins, which is where the one before it ends.
  double begin(std::size_t bin) const {
    return bin <= even_bins ? size_ / 2. * double(bin) / double(even_bins)
                            : size_ / 2. * integer_power(growth, static_cast<int>(bin - even_bins));
  }

  double mean(std::size_t bin) const {
    return bin < bins_.size() ? bins_[bin] / (begin(bin + 1) - begin(bin)) : 0.;
  }

  /// A triangle, with the distances at its corners.
  struct Corner
  {
    Vector point;
    double distance;
  };

  void add(std::array<Corner, 3> corners) {
    std::sort(corners.begin(), corners.end(),
              [](const Corner& a, const Corner& b) { return a.distance < b.distance; });
    const auto& [a, b, c] = corners;
    if(!(c.distance > a.distance))
      return;
    // The contour becomes longer up to the middle corner, and shorter from there.
    const double place = (b.distance - a.distance) / (c.distance - a.distance),
                 longest = norm(a.point + place * (c.point - a.point) - b.point);
    add_slope(a.distance, b.distance, longest, false);
    add_slope(b.distance, c.distance, longest, true);
  }

private:
  static constexpr std::size_t even_bins = 24;
  static constexpr double growth = 1. + 1. / double(even_bins);

  std::size_t bin_of(double distance) const {
    const double x = 2. * distance / size_;
    return x < 1. ? static_cast<std::size_t>(x * double(even_bins))
                  : even_bins + static_cast<std::size_t>(logarithm(x) / logarithm(growth));
  }

  // From nothing at one end to the longest at the other.
  void add_slope(double first, double last, double longest, bool is_falling) {
    if(!(last > first))
      return;
    const std::size_t first_bin = bin_of(first), last_bin = bin_of(last);
    if(last_bin >= bins_.size())
      bins_.resize(last_bin + 1, 0.);
    const auto up_to = [&](double t) {
      const double x = (std::min)((std::max)((t - first) / (last - first), 0.), 1.);
      return longest * (last - first) * (is_falling ? x - x * x / 2. : x * x / 2.);
    };
    double sum = 0.;
    for(std::size_t bin = first_bin; bin <= last_bin; ++bin) {
      const double next = bin == last_bin ? up_to(last) : up_to(begin(bin + 1));
      bins_[bin] += next - std::exchange(sum, next);
    }
  }

  double size_ = 0.;
  std::vector<double> bins_; // integrals
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_LENGTH_BY_DISTANCE_H
