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
#include "Random.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {

/// The graph of a box of cubic cells of side one, with as many edges taken away as leaves it
/// connected and with a given number of independent cycles, and with its nodes moved a little.
class Grid_graph
{
public:
  Grid_graph(std::size_t cycles, Random& random, double jitter = 0.12) {
    choose_size(cycles);
    place_nodes(random, jitter);
    choose_edges(cycles, random);
  }

  /// the edges, as pairs of points.
  std::vector<std::pair<Vector, Vector>> segments() const {
    return segments_with_cycles((std::numeric_limits<std::size_t>::max)());
  }

  /// those of a connected subgraph with all nodes and only so many cycles.
  std::vector<std::pair<Vector, Vector>> segments_with_cycles(std::size_t cycles) const {
    std::vector<std::pair<Vector, Vector>> segments;
    for(std::size_t i = 0; i < edges_.size(); ++i) {
      if(closes_cycle_[i] && cycles == 0)
        continue;
      cycles -= closes_cycle_[i];
      segments.emplace_back(nodes_[edges_[i].first], nodes_[edges_[i].second]);
    }
    return segments;
  }

private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  std::size_t number_of_nodes() const { return std::size_t(size_[0]) * size_[1] * size_[2]; }

  std::size_t number_of_edges() const {
    const std::size_t x = size_[0], y = size_[1], z = size_[2];
    return (x - 1) * y * z + x * (y - 1) * z + x * y * (z - 1);
  }

  /// the smallest box close to a cube that has the cycles, and an edge.
  void choose_size(std::size_t cycles) {
    size_ = {2, 1, 1};
    for(int i = 1; number_of_edges() + 1 < number_of_nodes() + cycles; i = (i + 1) % 3)
      ++size_[i];
  }

  void place_nodes(Random& random, double jitter) {
    const auto moved = [&](std::uint32_t i) { return i + random.uniform(-jitter, jitter); };
    for(std::uint32_t k = 0; k < size_[2]; ++k)
      for(std::uint32_t j = 0; j < size_[1]; ++j)
        for(std::uint32_t i = 0; i < size_[0]; ++i) {
          const double x = moved(i), y = moved(j), z = moved(k);
          nodes_.push_back(Vector(x, y, z));
        }
  }

  std::vector<Edge> all_edges() const {
    std::vector<Edge> edges;
    const std::array<std::uint32_t, 3> stride = {1, size_[0], size_[0] * size_[1]};
    for(std::uint32_t node = 0; node < number_of_nodes(); ++node)
      for(int axis = 0; axis < 3; ++axis)
        if(node / stride[axis] % size_[axis] + 1 < size_[axis])
          edges.emplace_back(node, node + stride[axis]);
    return edges;
  }

  /// keeps a random spanning tree and, of the other edges, as many as there are to be cycles.
  void choose_edges(std::size_t cycles, Random& random) {
    std::vector<Edge> edges = all_edges();
    random.shuffle(edges);
    boost::disjoint_sets_with_storage<> components(number_of_nodes());
    for(const auto& [a, b] : edges) {
      const bool closes_cycle = components.find_set(a) == components.find_set(b);
      if(closes_cycle && cycles == 0)
        continue;
      cycles -= closes_cycle;
      components.union_set(a, b);
      edges_.emplace_back(a, b);
      closes_cycle_.push_back(closes_cycle);
    }
  }

  std::array<std::uint32_t, 3> size_; ///< in nodes
  std::vector<Vector> nodes_;
  std::vector<Edge> edges_;
  std::vector<char> closes_cycle_; ///< with the edges before it
};

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

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_TUBES_H
