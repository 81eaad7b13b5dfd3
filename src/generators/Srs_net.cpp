// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Srs_net.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace CGAL::Handle_tunnel_loops::generators {

const std::array<Srs_node, Srs_net::nodes_per_period>& Srs_net::nodes() {
  static constexpr std::array<Srs_node, nodes_per_period> all = {
      {{1, 1, 1}, {1, 7, 3}, {3, 1, 7}, {3, 7, 5}, {5, 3, 7}, {5, 5, 5}, {7, 3, 1}, {7, 5, 3}}};
  return all;
}

const std::array<Srs_node, 3>& Srs_net::steps(int node) {
  static constexpr std::array<std::array<Srs_node, 3>, nodes_per_period> all = {
      {{{{0, -2, 2}, {2, 0, -2}, {-2, 2, 0}}},
       {{{0, 2, -2}, {2, 0, 2}, {-2, -2, 0}}},
       {{{-2, 0, 2}, {0, -2, -2}, {2, 2, 0}}},
       {{{-2, 0, -2}, {0, 2, 2}, {2, -2, 0}}},
       {{{-2, -2, 0}, {0, 2, -2}, {2, 0, 2}}},
       {{{-2, 2, 0}, {0, -2, 2}, {2, 0, -2}}},
       {{{2, -2, 0}, {-2, 0, -2}, {0, 2, 2}}},
       {{{2, 2, 0}, {-2, 0, 2}, {0, -2, -2}}}}};
  return all[node];
}

int Srs_net::number(const Srs_node& node) {
  Srs_node reduced;
  for(int i = 0; i < 3; ++i)
    reduced[i] = ((node[i] % period) + period) % period;
  return static_cast<int>(std::find(nodes().begin(), nodes().end(), reduced) - nodes().begin());
}

namespace {

/// Takes in nodes in the order of their distance from a centre, each with its edges to those taken
/// in before.
class Srs_growth
{
public:
  explicit Srs_growth(Random& random) {
    for(double& c : centre_)
      c = random.uniform(0., Srs_net::period);
    const auto closer = [&](const Srs_node& a, const Srs_node& b) {
      return distance(a) < distance(b);
    };
    const Srs_node first =
        *std::min_element(Srs_net::nodes().begin(), Srs_net::nodes().end(), closer);
    graph_[first] = 0;
    add_neighbours_to_front(first);
  }

  std::size_t cycles() const { return cycles_; }
  Srs_subgraph take() { return std::move(graph_); }

  /// takes in the next node, but closes at most so many cycles.
  void take_in_next(std::size_t most_cycles) {
    const Srs_node node = front_.begin()->second;
    front_.erase(front_.begin());
    unsigned edges = 0;
    const auto& steps = Srs_net::steps(Srs_net::number(node));
    for(int s = 0; s < 3; ++s) {
      const auto neighbour = graph_.find(Srs_net::plus(node, steps[s]));
      if(neighbour == graph_.end() || (edges != 0 && most_cycles == 0))
        continue;
      if(edges != 0) {
        ++cycles_;
        --most_cycles;
      }
      edges |= 1u << s;
      neighbour->second |= 1u << step_back(neighbour->first, node);
    }
    graph_[node] = edges;
    add_neighbours_to_front(node);
  }

private:
  double distance(const Srs_node& node) const {
    double d = 0.;
    for(int i = 0; i < 3; ++i)
      d = (std::max)(d, std::abs(node[i] - centre_[i]));
    return d;
  }

  static int step_back(const Srs_node& from, const Srs_node& to) {
    const auto& steps = Srs_net::steps(Srs_net::number(from));
    int s = 0;
    while(Srs_net::plus(from, steps[s]) != to)
      ++s;
    return s;
  }

  void add_neighbours_to_front(const Srs_node& node) {
    for(const Srs_node& step : Srs_net::steps(Srs_net::number(node))) {
      const Srs_node neighbour = Srs_net::plus(node, step);
      if(graph_.count(neighbour) == 0)
        front_.emplace(distance(neighbour), neighbour);
    }
  }

  std::array<double, 3> centre_;
  Srs_subgraph graph_;
  std::set<std::pair<double, Srs_node>> front_;
  std::size_t cycles_ = 0;
};

} // namespace

Srs_subgraph grow_srs_subgraph(std::size_t cycles, Random& random) {
  Srs_growth growth(random);
  while(growth.cycles() < cycles)
    growth.take_in_next(cycles - growth.cycles());
  return growth.take();
}

} // namespace CGAL::Handle_tunnel_loops::generators
