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
#include "functions.h"
#include "kinds.h"
#include "mesh_of_field.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// A node of the net srs, in units of an eighth of the period.
using Srs_node = std::array<int, 3>;

/*!
The net srs, the periodic graph along which the solid sin x cos y + sin y cos z + sin z cos x > 0
runs: its nodes are the maxima of that function, eight to a period of 2 pi, and each has three
neighbours. Verified numerically: the points of the solid that are closest to a node have only
neighbours of it as their next closest node, so that cutting the solid in the middle of an edge of
the net cuts one neck.
*/
constexpr int srs_period = 8;
constexpr double srs_unit = CGAL_PI / 4.;
constexpr double srs_edge_length = srs_unit * 2. * 1.41421356237309504880;
constexpr std::size_t nodes_per_period = 8;

constexpr std::array<Srs_node, nodes_per_period> srs_nodes = {
    {{1, 1, 1}, {1, 7, 3}, {3, 1, 7}, {3, 7, 5}, {5, 3, 7}, {5, 5, 5}, {7, 3, 1}, {7, 5, 3}}};

/// the steps from each of these nodes to its neighbours.
constexpr std::array<std::array<Srs_node, 3>, nodes_per_period> srs_steps = {
    {{{{0, -2, 2}, {2, 0, -2}, {-2, 2, 0}}},
     {{{0, 2, -2}, {2, 0, 2}, {-2, -2, 0}}},
     {{{-2, 0, 2}, {0, -2, -2}, {2, 2, 0}}},
     {{{-2, 0, -2}, {0, 2, 2}, {2, -2, 0}}},
     {{{-2, -2, 0}, {0, 2, -2}, {2, 0, 2}}},
     {{{-2, 2, 0}, {0, -2, 2}, {2, 0, -2}}},
     {{{2, -2, 0}, {-2, 0, -2}, {0, 2, 2}}},
     {{{2, 2, 0}, {-2, 0, 2}, {0, -2, -2}}}}};

Vector position(const Srs_node& node) { return Vector(node[0], node[1], node[2]) * srs_unit; }

Srs_node plus(const Srs_node& a, const Srs_node& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Srs_node period_of(const Srs_node& node) {
  Srs_node result;
  for(int i = 0; i < 3; ++i)
    result[i] = static_cast<int>(std::floor(double(node[i]) / srs_period));
  return result;
}

/// the number of a node in `srs_nodes`, whatever its period.
int number_of(const Srs_node& node) {
  Srs_node reduced = period_of(node);
  for(int i = 0; i < 3; ++i)
    reduced[i] = node[i] - srs_period * reduced[i];
  return static_cast<int>(std::find(srs_nodes.begin(), srs_nodes.end(), reduced) -
                          srs_nodes.begin());
}

/// the number of the step from a node to a neighbour.
int step_between(const Srs_node& from, const Srs_node& to) {
  const auto& steps = srs_steps[number_of(from)];
  int s = 0;
  while(plus(from, steps[s]) != to)
    ++s;
  return s;
}

/// A finite connected part of the net: its nodes, each with the set of the steps, as bits, along
/// which it has an edge.
using Srs_subgraph = std::map<Srs_node, unsigned>;

/// a part of the net with a given number of independent cycles, grown like a box around a random
/// point: it takes in nodes in the order of their distance, each with its edges to those taken in
/// before.
Srs_subgraph grow_srs_subgraph(std::size_t cycles, Random& random) {
  std::array<double, 3> centre;
  for(double& c : centre)
    c = random.uniform(0., srs_period);
  const auto distance = [&](const Srs_node& node) {
    double d = 0.;
    for(int i = 0; i < 3; ++i)
      d = (std::max)(d, std::abs(node[i] - centre[i]));
    return d;
  };
  Srs_subgraph graph;
  std::set<std::pair<double, Srs_node>> front;
  for(const Srs_node& node : srs_nodes)
    front.emplace(distance(node), node);
  front.erase(std::next(front.begin()), front.end());
  do {
    const Srs_node node = front.begin()->second;
    front.erase(front.begin());
    unsigned edges = 0;
    for(int s = 0; s < 3; ++s) {
      const Srs_node beside = plus(node, srs_steps[number_of(node)][s]);
      const auto neighbour = graph.find(beside);
      if(neighbour == graph.end())
        front.emplace(distance(beside), beside);
      else if(edges == 0 || cycles > 0) {
        cycles -= edges != 0;
        edges |= 1u << s;
        neighbour->second |= 1u << step_between(beside, node);
      }
    }
    graph[node] = edges;
  } while(cycles > 0);
  return graph;
}

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

  /// A node near a bin of a period, both relative to that period.
  struct Near_node
  {
    Srs_node period;
    int number;
    Vector position;
  };

  /// the level set function divided by the largest length of its gradient, negative in the solid.
  static double gyroid(const Vector& p) {
    const auto x = sine_and_cosine(p.x()), y = sine_and_cosine(p.y()), z = sine_and_cosine(p.z());
    return -(x.sine * y.cosine + y.sine * z.cosine + z.sine * x.cosine) / std::sqrt(3.);
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
      const std::size_t index = period_index(plus(period, near.period));
      if(index == no_period)
        continue;
      if(const auto edges = nodes_[index][near.number])
        nearest = (std::min)(nearest, cell(from_node, near.number, *edges));
    }
    return nearest;
  }

  /// the distance to the cell of a node: beyond the middles of its edges for edges of the part,
  /// which joins the cells, and short of them for others.
  static double cell(const Vector& from_node, int number, unsigned edges) {
    double distance = length(from_node) - reach;
    const auto& steps = srs_steps[number];
    for(int s = 0; s < 3; ++s) {
      const Vector direction = position(steps[s]) / srs_edge_length;
      const double beyond_middle = from_node * direction - srs_edge_length / 2.;
      const bool is_joined = ((edges >> s) & 1) != 0;
      distance = (std::max)(distance, beyond_middle + (is_joined ? -slab : slab));
    }
    return distance;
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
    nodes_box_ = {position(first), position(last)};
    first_period_ = period_of(first);
    for(int i = 0; i < 3; ++i)
      periods_[i] = period_of(last)[i] - first_period_[i] + 1;
    nodes_.resize(std::size_t(periods_[0]) * periods_[1] * periods_[2]);
    for(const auto& [node, edges] : graph)
      nodes_[period_index(period_of(node))][number_of(node)] = static_cast<std::uint8_t>(edges);
  }

  /// lists, for each bin of a period, the nodes whose cell may be closer than `margin` to a point
  /// of it.
  void list_near_nodes() {
    const double side = 2. * CGAL_PI / bins_per_period;
    const double far = reach + margin + std::sqrt(3.) / 2. * side;
    constexpr int n = bins_per_period;
    for(int bin = 0; bin < n * n * n; ++bin) {
      const Vector centre = side * Vector(bin / (n * n) + 0.5, bin / n % n + 0.5, bin % n + 0.5);
      auto& near = near_nodes_[bin];
      for(const Srs_node& node : nodes_around_period())
        if(length(position(node) - centre) < far)
          near.push_back({period_of(node), number_of(node), position(node)});
      // The closest first: they most often rule the others out.
      std::sort(near.begin(), near.end(), [&](const Near_node& a, const Near_node& b) {
        return length(a.position - centre) < length(b.position - centre);
      });
    }
  }

  static std::vector<Srs_node> nodes_around_period() {
    std::vector<Srs_node> around;
    for(int x : {-srs_period, 0, srs_period})
      for(int y : {-srs_period, 0, srs_period})
        for(int z : {-srs_period, 0, srs_period})
          for(const Srs_node& node : srs_nodes)
            around.push_back(plus(node, {x, y, z}));
    return around;
  }

  Box nodes_box_;
  Srs_node first_period_;
  std::array<int, 3> periods_;
  // By period and number, of those that are in the part: with which of its edges.
  std::vector<std::array<std::optional<std::uint8_t>, nodes_per_period>> nodes_;
  std::array<std::vector<Near_node>, bins_per_period * bins_per_period * bins_per_period>
      near_nodes_;
};

/// a direction, all equally likely.
Vector random_direction(Random& random) {
  const double z = random.uniform(-1., 1.), angle = random.uniform(0., 2. * CGAL_PI);
  const double r = std::sqrt(1. - z * z);
  return Vector(r * cosine(angle), r * sine(angle), z);
}

/// Where a sum of random plane waves is negative, in a cube of side two.
class Waves_in_box : public Field
{
public:
  Waves_in_box(double frequency, Random& random)
      : level_(random.uniform(-0.7, 0.7)) {
    for(Wave& wave : waves_) {
      const Vector direction = random_direction(random);
      wave.direction = CGAL_PI * frequency * random.uniform(0.5, 1.) * direction;
      wave.phase = random.uniform(0., 2. * CGAL_PI);
      steepest_ += length(wave.direction);
    }
  }

  Box box() const override { return Box{Vector(0, 0, 0), Vector(0, 0, 0)}.grown(1.); }

  double operator()(const Vector& p) const override {
    const double beyond_box = (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) - 1.;
    double sum = level_;
    for(const Wave& wave : waves_)
      sum += sine(wave.direction * p + wave.phase);
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

} // namespace

Soup make_gyroid(const Request& request) {
  require_faces(request, "gyroid", 400 + 300 * request.genus);
  Random random(request.seed);
  return mesh_of_field(Gyroid_part(grow_srs_subgraph(request.genus, random)), request, "gyroid");
}

Soup make_waves(const Request& request) {
  const std::size_t f = (std::max<std::size_t>)(request.frequency, 1);
  require_faces(request, "waves", 1000. + 400. * double(f * f * f),
                "with frequency " + std::to_string(f));
  Random random(request.seed);
  return mesh_of_field(Waves_in_box(static_cast<double>(f), random), request.faces);
}

} // namespace CGAL::Handle_tunnel_loops::generators
