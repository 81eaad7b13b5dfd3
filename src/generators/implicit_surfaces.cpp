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
#include "Srs_net.h"
#include "kinds.h"
#include "mesh_of_field.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/*!
One of the two halves into which the gyroid parts space, as far as it belongs to a part of its net:
each node owns the points between the middles of its three edges, and is cut off there where the
edge is not in the part.
*/
class Gyroid_part : public Field
{
public:
  explicit Gyroid_part(const Srs_subgraph& graph) {
    store(graph);
    list_near_nodes();
  }

  Box box() const override { return nodes_box_.grown(reach); }

  double operator()(const Vector& p) const override {
    const double surface = gyroid(p);
    if(surface > rounding)
      return surface - rounding;
    return blended_maximum(surface, cut(p));
  }

private:
  // A node owns no point of the solid further away than 1.917, and the edges are 2.221 long.
  static constexpr double reach = 2., slab = 0.3, rounding = 0.2, margin = 0.5;
  static constexpr int bins_per_period = 4;
  static constexpr auto no_period = static_cast<std::size_t>(-1);

  /// What a node owns: whether it is in the part, and with which of its edges.
  struct Node
  {
    bool is_in = false;
    std::uint8_t edges = 0;
  };

  /// A node near a bin of a period, both relative to that period.
  struct Near_node
  {
    Srs_node period;
    int number;
    Vector position;
  };

  /// the level set function divided by the largest length of its gradient, negative in the solid.
  static double gyroid(const Vector& p) {
    const double sx = std::sin(p.x()), cx = std::cos(p.x()), sy = std::sin(p.y()),
                 cy = std::cos(p.y()), sz = std::sin(p.z()), cz = std::cos(p.z());
    return -(sx * cy + sy * cz + sz * cx) / std::sqrt(3.);
  }

  /// a bit more than the maximum where both are close, so that the rims of the cuts are round.
  static double blended_maximum(double a, double b) {
    return (a + b + std::sqrt((a - b) * (a - b) + rounding * rounding)) / 2.;
  }

  /// the distance to the union of the cells of the part's nodes.
  double cut(const Vector& p) const {
    Srs_node period;
    std::size_t bin = 0;
    for(int i = 0; i < 3; ++i) {
      const double periods = p[i] / (2. * CGAL_PI), whole = std::floor(periods);
      period[i] = static_cast<int>(whole);
      // Just below a whole number of periods the difference rounds to one.
      const double in_period = (periods - whole) * bins_per_period;
      bin = bin * bins_per_period + (std::min)(static_cast<int>(in_period), bins_per_period - 1);
    }
    const Vector from_corner = p - 2. * CGAL_PI * Vector(period[0], period[1], period[2]);
    double nearest = margin;
    for(const Near_node& near : near_nodes_[bin]) {
      const Vector from_node = from_corner - near.position;
      if(from_node.squared_length() >= square(nearest + reach))
        continue; // its cell is further away
      const std::size_t index = period_index(Srs_net::plus(period, near.period));
      if(index == no_period)
        continue;
      const Node node = nodes_[index][near.number];
      if(node.is_in)
        nearest = (std::min)(nearest, cell(from_node, near.number, node.edges));
    }
    return nearest;
  }

  /// the distance to the cell of a node: beyond the middles of its edges for edges of the part,
  /// which joins the cells, and short of them for others.
  static double cell(const Vector& from_node, int number, unsigned edges) {
    double distance = length(from_node) - reach;
    const auto& steps = Srs_net::steps(number);
    for(int s = 0; s < 3; ++s) {
      const Vector direction = Srs_net::position(steps[s]) / Srs_net::edge_length;
      const double beyond_middle = from_node * direction - Srs_net::edge_length / 2.;
      const bool is_joined = ((edges >> s) & 1) != 0;
      distance = (std::max)(distance, beyond_middle + (is_joined ? -slab : slab));
    }
    return distance;
  }

  static Srs_node period_of(const Srs_node& node) {
    Srs_node period;
    for(int i = 0; i < 3; ++i)
      period[i] = static_cast<int>(std::floor(double(node[i]) / Srs_net::period));
    return period;
  }

  /// the number of a period in the array of those that have nodes of the part, or `no_period`.
  std::size_t period_index(const Srs_node& period) const {
    std::size_t index = 0;
    for(int i = 0; i < 3; ++i) {
      const int c = period[i] - first_period_[i];
      if(c < 0 || c >= periods_[i])
        return no_period;
      index = index * periods_[i] + c;
    }
    return index;
  }

  /// keeps the nodes of the part in an array over the periods of a box.
  void store(const Srs_subgraph& graph) {
    Srs_node first = graph.begin()->first, last = first;
    for(const auto& [node, edges] : graph)
      for(int i = 0; i < 3; ++i) {
        first[i] = (std::min)(first[i], node[i]);
        last[i] = (std::max)(last[i], node[i]);
      }
    nodes_box_ = {Srs_net::position(first), Srs_net::position(last)};
    std::size_t count = 1;
    first_period_ = period_of(first);
    for(int i = 0; i < 3; ++i) {
      periods_[i] = period_of(last)[i] - first_period_[i] + 1;
      count *= periods_[i];
    }
    nodes_.resize(count);
    for(const auto& [node, edges] : graph)
      nodes_[period_index(period_of(node))][Srs_net::number(node)] = {
          true, static_cast<std::uint8_t>(edges)};
  }

  /// lists, for each bin of a period, the nodes whose cell may be closer than `margin` to a point
  /// of it.
  void list_near_nodes() {
    const double side = 2. * CGAL_PI / bins_per_period;
    const double far = reach + margin + std::sqrt(3.) / 2. * side;
    for(int i = 0; i < bins_per_period; ++i)
      for(int j = 0; j < bins_per_period; ++j)
        for(int k = 0; k < bins_per_period; ++k) {
          const Vector centre = side * Vector(i + 0.5, j + 0.5, k + 0.5);
          auto& near = near_nodes_[(i * bins_per_period + j) * bins_per_period + k];
          for(const Srs_node& node : nodes_around_period())
            if(length(Srs_net::position(node) - centre) < far)
              near.push_back({period_of(node), Srs_net::number(node), Srs_net::position(node)});
          // The closest first: they most often rule the others out.
          std::sort(near.begin(), near.end(), [&](const Near_node& a, const Near_node& b) {
            return length(a.position - centre) < length(b.position - centre);
          });
        }
  }

  static std::vector<Srs_node> nodes_around_period() {
    std::vector<Srs_node> around;
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z)
          for(const Srs_node& node : Srs_net::nodes())
            around.push_back(Srs_net::plus(
                node, {x * Srs_net::period, y * Srs_net::period, z * Srs_net::period}));
    return around;
  }

  Box nodes_box_;
  Srs_node first_period_;
  std::array<int, 3> periods_;
  std::vector<std::array<Node, Srs_net::nodes_per_period>> nodes_; // by period and number
  std::array<std::vector<Near_node>, bins_per_period * bins_per_period * bins_per_period>
      near_nodes_;
};

Soup make_gyroid(const Request& request) {
  require_faces(request, "gyroid", 400 + 300 * request.genus);
  Random random(request.seed);
  return mesh_of_field(Gyroid_part(grow_srs_subgraph(request.genus, random)), request, "gyroid");
}

/// a direction, all equally likely.
Vector random_direction(Random& random) {
  const double z = random.uniform(-1., 1.), angle = random.uniform(0., 2. * CGAL_PI);
  const double r = std::sqrt(1. - z * z);
  return Vector(r * std::cos(angle), r * std::sin(angle), z);
}

/// Where a sum of random plane waves is negative, in a cube of side two.
class Waves_in_box : public Field
{
public:
  Waves_in_box(double frequency, Random& random)
      : level_(random.uniform(-0.7, 0.7)) {
    for(Wave& wave : waves_) {
      wave.direction = CGAL_PI * frequency * random.uniform(0.5, 1.) * random_direction(random);
      wave.phase = random.uniform(0., 2. * CGAL_PI);
      steepest_ += length(wave.direction);
    }
  }

  Box box() const override { return Box{Vector(0, 0, 0), Vector(0, 0, 0)}.grown(1.); }

  double operator()(const Vector& p) const override {
    const double beyond_box = (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) - 1.;
    double sum = level_;
    for(const Wave& wave : waves_)
      sum += std::sin(wave.direction * p + wave.phase);
    return (std::max)(beyond_box, sum / steepest_);
  }

private:
  struct Wave
  {
    Vector direction;
    double phase;
  };

  std::array<Wave, 12> waves_;
  double level_, steepest_ = 0.;
};

Soup make_waves(const Request& request) {
  const std::size_t f = (std::max<std::size_t>)(request.frequency, 1);
  require_faces(request, "waves", 1000. + 400. * std::pow(f, 3));
  Random random(request.seed);
  return mesh_of_field(Waves_in_box(static_cast<double>(f), random), request.faces);
}

} // namespace

const Kind gyroid_kind = {
    "gyroid",
    "a block of the gyroid, cut so that it has the handles asked for; any genus g, from "
    "400 + 300 g faces",
    make_gyroid};

const Kind waves_kind = {
    "waves",
    "a level set of a sum of random waves in a box; the genus and the number of components are "
    "what comes out, from 1000 + 400 f^3 faces for frequency f",
    make_waves, WAVE_FREQUENCY, 20000};

} // namespace CGAL::Handle_tunnel_loops::generators
