// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Field.h"
#include "Random.h"
#include "closed_curves.h"
#include "functions.h"
#include "kinds.h"
#include "mesh_of_field.h"

#include <CGAL/number_type_config.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

using Segment = std::pair<Vector, Vector>;

constexpr double usual_jitter = 0.12; // of the nodes of a grid

/// The edges of a graph that is connected.
struct Grid_graph
{
  std::vector<Segment> segments;
  std::vector<char> closes_cycle; ///< with the segments before it

  /// those of a connected subgraph with all nodes and only so many cycles.
  std::vector<Segment> with_cycles(std::size_t cycles) const {
    std::vector<Segment> some;
    for(std::size_t i = 0; i < segments.size(); ++i) {
      if(closes_cycle[i] && cycles == 0)
        continue;
      cycles -= closes_cycle[i];
      some.push_back(segments[i]);
    }
    return some;
  }
};

/// the numbers of nodes of the smallest box close to a cube that has the cycles, and an edge.
std::array<std::uint32_t, 3> size_of_grid(std::size_t cycles) {
  std::array<std::uint32_t, 3> size = {2, 1, 1};
  const auto has_cycles = [&] {
    const std::size_t x = size[0], y = size[1], z = size[2];
    return (x - 1) * y * z + x * (y - 1) * z + x * y * (z - 1) + 1 >= x * y * z + cycles;
  };
  for(int i = 1; !has_cycles(); i = (i + 1) % 3)
    ++size[i];
  return size;
}

/// the graph of a box of cubic cells of side one, large enough for a number of independent cycles,
/// with its edges in random order and its nodes moved a little.
Grid_graph grid_graph(std::size_t cycles, Random& random, double jitter) {
  const std::array<std::uint32_t, 3> size = size_of_grid(cycles);
  const std::array<std::uint32_t, 3> stride = {1, size[0], size[0] * size[1]};
  std::vector<Vector> nodes;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for(std::uint32_t node = 0; node < stride[2] * size[2]; ++node) {
    std::array<double, 3> place;
    for(int axis = 0; axis < 3; ++axis) {
      const std::uint32_t at = node / stride[axis] % size[axis];
      place[axis] = at + random.uniform(-jitter, jitter);
      if(at + 1 < size[axis])
        edges.emplace_back(node, node + stride[axis]);
    }
    nodes.push_back(Vector(place[0], place[1], place[2]));
  }
  random.shuffle(edges);
  boost::disjoint_sets_with_storage<> components(nodes.size());
  Grid_graph graph;
  for(const auto& [a, b] : edges) {
    graph.segments.emplace_back(nodes[a], nodes[b]);
    graph.closes_cycle.push_back(components.find_set(a) == components.find_set(b));
    components.union_set(a, b);
  }
  return graph;
}

/// Tubes around segments, blended where they meet. Their radii are at most 0.24; segments that do
/// not meet are to be so far apart that the tubes do not either.
class Tubes : public Field
{
public:
  Tubes(const std::vector<Segment>& segments, double radius)
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
    list_segments_near_bins();
  }

  Box box() const override { return box_; }

  double operator()(const Vector& p) const override {
    std::size_t bin = 0;
    for(int axis = 2; axis >= 0; --axis) {
      const double index = std::floor((p[axis] - box_.low[axis]) / bin_side);
      bin = bin * bins_[axis] + static_cast<std::size_t>(std::clamp(index, 0., bins_[axis] - 1.));
    }
    double sum = 0.;
    for(const std::uint32_t s : near_[bin]) {
      const auto& [a, b] = segments_[s];
      sum += exponential(-(segment_distance(p, a, b) + lacking_[s]) / blend);
    }
    // Further tubes are at least reach - radius away from all points of the bin.
    const double far = reach - radius_;
    return sum > 0. ? (std::min)(-blend * logarithm(sum) - radius_, far) : far;
  }

private:
  static constexpr double blend = 0.035, reach = 0.42, bin_side = 1. / 3.;

  /// those closer than `reach` to a point of a bin, for each bin of the box.
  void list_segments_near_bins() {
    const double half_diagonal = std::sqrt(3.) / 2. * bin_side;
    const auto index = [this](double x, int axis) {
      return static_cast<std::size_t>((x - box_.low[axis]) / bin_side);
    };
    for(int axis = 0; axis < 3; ++axis)
      bins_[axis] = index(box_.high[axis], axis) + 1;
    near_.resize(bins_[0] * bins_[1] * bins_[2]);
    for(std::uint32_t s = 0; s < segments_.size(); ++s) {
      const auto& [a, b] = segments_[s];
      std::array<std::size_t, 3> first, last;
      for(int axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::minmax(a[axis], b[axis]);
        first[axis] = index((std::max)(low - reach, box_.low[axis]), axis);
        last[axis] = (std::min)(index(high + reach, axis), bins_[axis] - 1);
      }
      for(std::size_t k = first[2]; k <= last[2]; ++k)
        for(std::size_t j = first[1]; j <= last[1]; ++j)
          for(std::size_t i = first[0]; i <= last[0]; ++i) {
            const Vector centre = box_.low + bin_side * Vector(i + 0.5, j + 0.5, k + 0.5);
            if(segment_distance(centre, a, b) <= reach + half_diagonal)
              near_[(k * bins_[1] + j) * bins_[0] + i].push_back(s);
          }
    }
  }

  std::vector<Segment> segments_;
  double radius_;               ///< the largest
  std::vector<double> lacking_; ///< by segment: by how much its tube is thinner
  Box box_;
  std::array<std::size_t, 3> bins_;
  std::vector<std::vector<std::uint32_t>> near_; ///< by bin: the segments
};

/// The segments of one or two parallel torus knots, and of rungs between them. All that does not
/// meet is 0.85 apart or more.
std::vector<Segment> knotted_ladder(const Torus_knot& knot, std::size_t rungs) {
  constexpr double width = 0.85, step_length = 0.5;
  // Between the ladder and its next turn there is as much room as between its sides.
  const double turns = 2. * width / knot.distance(knot.period());
  const double length_of_rungs = width * static_cast<double>(rungs);
  const double scale = (std::max)(turns, length_of_rungs / (2. * CGAL_PI * knot.least_speed()));
  const Curve_by_length side([&](double t) { return scale * knot.point(t, 0.); });
  auto steps = static_cast<std::size_t>(std::ceil(side.length() / step_length));
  if(rungs > 0)
    steps = rungs * ((steps + rungs - 1) / rungs);

  std::vector<Segment> segments;
  const auto add_side = [&](double moved) {
    std::vector<Vector> nodes;
    for(std::size_t i = 0; i < steps; ++i)
      nodes.push_back(scale * knot.point(2. * CGAL_PI * i / steps, moved));
    for(std::size_t i = 0; i < steps; ++i)
      segments.emplace_back(nodes[i], nodes[(i + 1) % steps]);
    return nodes;
  };
  const std::vector<Vector> nodes = add_side(0.);
  if(rungs == 0)
    return segments;
  const std::vector<Vector> others = add_side(width / (scale * knot.distance_along_torus(1.)));
  for(std::size_t i = 0; i < rungs; ++i) {
    const Vector& from = nodes[i * steps / rungs];
    const auto is_closer = [&](const Vector& p, const Vector& q) {
      return (p - from).squared_length() < (q - from).squared_length();
    };
    segments.emplace_back(from, *std::min_element(others.begin(), others.end(), is_closer));
  }
  return segments;
}

/// tubes along the edges of a grid, moved by the same distance along all axes.
Soup make_grid(double moved, const Request& request, Random& random) {
  constexpr double jitter = 0.05, radius = 0.14;
  auto segments = grid_graph(request.genus, random, jitter).with_cycles(request.genus);
  for(auto& [a, b] : segments) {
    a += Vector(moved, moved, moved);
    b += Vector(moved, moved, moved);
  }
  return mesh_of_field(Tubes(segments, radius), request, "interlaced");
}

} // namespace

Soup make_foam(const Request& request) {
  constexpr double jitter = 0.22, least_radius = 0.1, most_radius = 0.2;
  require_faces(request, "foam", 600 + 600 * request.genus);
  Random random(request.seed);
  const auto segments = grid_graph(request.genus, random, jitter).with_cycles(request.genus);
  std::vector<double> radii;
  for(std::size_t i = 0; i < segments.size(); ++i)
    radii.push_back(random.uniform(least_radius, most_radius));
  return mesh_of_field(Tubes(segments, radii), request, "foam");
}

Soup make_interlaced(const Request& request) {
  require_faces(request, "interlaced", 1000 + 400 * request.genus);
  Random random(request.seed);
  const std::size_t genus = request.genus / 2, faces = request.faces / 2;
  const Soup first = make_grid(0., {request.faces - faces, request.genus - genus}, random);
  return joined({first, make_grid(0.5, {faces, genus}, random)});
}

Soup make_ladder(const Request& request) {
  constexpr double tube_radius = 0.22, faces_per_length = 200.;
  require_least_genus(request, "ladder", 1);
  const auto segments = knotted_ladder(Torus_knot(request.p, request.q), request.genus - 1);
  double sum = 0.;
  for(const auto& [a, b] : segments)
    sum += length(b - a);
  require_faces(request, "ladder", std::ceil(faces_per_length * sum));
  return mesh_of_field(Tubes(segments, tube_radius), request, "ladder");
}

Soup make_lattice(const Request& request) {
  require_faces(request, "lattice", 400 + 250 * request.genus);
  Random random(request.seed);
  const Grid_graph graph = grid_graph(request.genus, random, usual_jitter);
  return mesh_of_field(Tubes(graph.with_cycles(request.genus), 0.17), request, "lattice");
}

Soup make_shell(const Request& request) {
  constexpr double outer_radius = 0.24, inner_radius = 0.12;
  require_faces(request, "shell", 1000 + 600 * request.genus);
  Random random(request.seed);
  const std::size_t inner_genus = random.below(request.genus / 2 + 1);
  const std::size_t outer_genus = request.genus - inner_genus;
  const Grid_graph graph = grid_graph(outer_genus, random, usual_jitter);
  const auto outer = graph.with_cycles(outer_genus), inner = graph.with_cycles(inner_genus);
  // Thin tubes need as many faces as thick ones.
  const std::size_t inner_faces = request.faces * inner.size() / (inner.size() + outer.size());
  return joined(
      {mesh_of_field(Tubes(outer, outer_radius), {request.faces - inner_faces, outer_genus},
                     "shell"),
       reversed(mesh_of_field(Tubes(inner, inner_radius), {inner_faces, inner_genus}, "shell"))});
}

} // namespace CGAL::Handle_tunnel_loops::generators
