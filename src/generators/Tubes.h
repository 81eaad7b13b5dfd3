// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_TUBES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_TUBES_H

#include "Field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// Tubes around segments, blended where they meet. Their radii are at most 0.24; segments that do
/// not meet are to be so far apart that the tubes do not either.
class Tubes : public Field
{
public:
  using Segment = std::pair<Vector, Vector>;

  explicit Tubes(const std::vector<Segment>& segments, double radius = 0.17)
      : Tubes(segments, std::vector<double>(segments.size(), radius)) {}

  /// with a radius for each segment.
  Tubes(std::vector<Segment> segments, const std::vector<double>& radii)
      : segments_(std::move(segments))
      , radius_(*std::max_element(radii.begin(), radii.end())) {
    for(const double radius : radii)
      lacking_.push_back(radius_ - radius);
    box_ = {segments_.front().first, segments_.front().first};
    for(const Segment& segment : segments_)
      box_ = box_.with(segment.first).with(segment.second);
    box_ = box_.grown(reach);
    fill_bins();
  }

  Box box() const override { return box_; }

  double operator()(const Vector& p) const override {
    std::size_t bin = 0;
    for(int axis = 2; axis >= 0; --axis) {
      const double index = std::floor((p[axis] - box_.low[axis]) / bin_side);
      bin = bin * bins_[axis] + static_cast<std::size_t>(std::clamp(index, 0., bins_[axis] - 1.));
    }
    double sum = 0.;
    for(std::uint32_t i = bin_start_[bin]; i < bin_start_[bin + 1]; ++i) {
      const std::uint32_t s = bin_segments_[i];
      sum += std::exp(-(distance(p, segments_[s]) + lacking_[s]) / blend);
    }
    // Further tubes are at least reach - radius away from all points of the bin.
    const double far = reach - radius_;
    return sum > 0. ? (std::min)(-blend * std::log(sum) - radius_, far) : far;
  }

private:
  static constexpr double blend = 0.035, reach = 0.42, bin_side = 1. / 3.;

  static double distance(const Vector& p, const Segment& segment) {
    const Vector along = segment.second - segment.first, from = p - segment.first;
    const double t = std::clamp((from * along) / along.squared_length(), 0., 1.);
    return length(from - t * along);
  }

  /// lists, for each bin of the box, the segments closer than `reach` to a point of it.
  void fill_bins() {
    std::size_t count = 1;
    for(int axis = 0; axis < 3; ++axis) {
      bins_[axis] = static_cast<std::size_t>((box_.high[axis] - box_.low[axis]) / bin_side) + 1;
      count *= bins_[axis];
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> entries; // bin, segment
    for(std::uint32_t s = 0; s < segments_.size(); ++s)
      for_each_bin_near(segments_[s], [&](std::size_t bin) { entries.emplace_back(bin, s); });
    std::sort(entries.begin(), entries.end());
    bin_start_.assign(count + 1, 0);
    for(const auto& [bin, segment] : entries) {
      ++bin_start_[bin + 1];
      bin_segments_.push_back(segment);
    }
    std::partial_sum(bin_start_.begin(), bin_start_.end(), bin_start_.begin());
  }

  template <typename Visit> void for_each_bin_near(const Segment& segment, Visit visit) const {
    const double half_diagonal = std::sqrt(3.) / 2. * bin_side;
    std::array<std::size_t, 3> first, last;
    for(int axis = 0; axis < 3; ++axis) {
      const auto [a, b] = std::minmax(segment.first[axis], segment.second[axis]);
      first[axis] =
          static_cast<std::size_t>((std::max)((a - reach - box_.low[axis]) / bin_side, 0.));
      last[axis] = (std::min)(static_cast<std::size_t>((b + reach - box_.low[axis]) / bin_side),
                              bins_[axis] - 1);
    }
    for(std::size_t k = first[2]; k <= last[2]; ++k)
      for(std::size_t j = first[1]; j <= last[1]; ++j)
        for(std::size_t i = first[0]; i <= last[0]; ++i) {
          const Vector centre = box_.low + bin_side * Vector(i + 0.5, j + 0.5, k + 0.5);
          if(distance(centre, segment) <= reach + half_diagonal)
            visit((k * bins_[1] + j) * bins_[0] + i);
        }
  }

  std::vector<Segment> segments_;
  double radius_;               ///< the largest
  std::vector<double> lacking_; ///< by segment: by how much its tube is thinner
  Box box_;
  std::array<std::size_t, 3> bins_;
  std::vector<std::uint32_t> bin_start_, bin_segments_;
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_TUBES_H
