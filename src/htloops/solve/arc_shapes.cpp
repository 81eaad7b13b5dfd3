// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/arc_shapes.h"

#include "solve/girths.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace htloops {
namespace {

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// Vertices and points of a polyline follow each other by the same values, so that the nearest one
// is not far from that of the vertex before.
std::size_t nearest(const std::vector<Point>& line, const Point& p, std::size_t k) {
  const auto squared = [&](std::size_t i) { return CGAL::squared_distance(line[i], p); };
  while(k + 1 < line.size() && squared(k + 1) <= squared(k))
    ++k;
  while(k > 0 && squared(k - 1) < squared(k))
    --k;
  return k;
}

// Fills places without a number from both sides.
void fill_gaps(const std::vector<std::size_t>& counts, std::vector<double>& numbers) {
  const std::size_t n = numbers.size();
  for(std::size_t i = 0; i < n; ++i) {
    if(counts[i] > 0)
      continue;
    std::size_t end = i;
    while(end < n && counts[end] == 0)
      ++end;
    const double before = i > 0 ? numbers[i - 1] : numbers[end];
    const double after = end < n ? numbers[end] : before;
    for(std::size_t k = i; k < end; ++k) {
      const double t = static_cast<double>(k - i + 1) / static_cast<double>(end - i + 1);
      numbers[k] = before + t * (after - before);
    }
    i = end;
  }
}

std::vector<double> radii_of(const Mesh& mesh, const CGAL::Reeb_arc<Mesh>& arc, double girth) {
  std::vector<double> radii(arc.polyline.size(), 0.);
  std::vector<std::size_t> counts(radii.size(), 0);
  std::size_t k = 0;
  for(const Mesh::Vertex_index v : arc.vertices) {
    k = nearest(arc.polyline, mesh.point(v), k);
    radii[k] += distance(arc.polyline[k], mesh.point(v));
    ++counts[k];
  }
  if(arc.vertices.empty())
    return std::vector<double>(radii.size(), girth / (2. * CGAL_PI));
  for(std::size_t i = 0; i < radii.size(); ++i)
    if(counts[i] > 0)
      radii[i] /= static_cast<double>(counts[i]);
  fill_gaps(counts, radii);
  return radii;
}

using Graph = CGAL::Reeb_graph<Mesh>;
using Edge = boost::graph_traits<Graph>::edge_descriptor;

// Finds the arcs without which the graph falls apart, by a walk in depth: that to a node from
// which, and from all that is found beyond it, no other arc leads back to where the walk has been.
class Bridge_search
{
public:
  explicit Bridge_search(const Graph& graph)
      : arcs_at_(num_vertices(graph))
      , order_(num_vertices(graph), unseen)
      , earliest_(num_vertices(graph), unseen)
      , is_bridge_(num_edges(graph), false) {
    for(const Edge& e : CGAL::make_range(edges(graph))) {
      const std::size_t s = source(e, graph), t = target(e, graph), arc = graph[e].index;
      arcs_at_[s].emplace_back(arc, t);
      arcs_at_[t].emplace_back(arc, s);
    }
    for(std::size_t node = 0; node < arcs_at_.size(); ++node)
      if(order_[node] == unseen)
        walk_from(node);
  }

  const std::vector<bool>& is_bridge() const { return is_bridge_; }

private:
  static constexpr std::size_t unseen = static_cast<std::size_t>(-1);

  // A node on the way, the arc to it, and how many of its arcs have been tried.
  struct Place
  {
    std::size_t node, arc, tried = 0;
  };

  void walk_from(std::size_t start) {
    std::vector<Place> way;
    enter(way, start, unseen);
    while(!way.empty()) {
      Place& here = way.back();
      if(here.tried == arcs_at_[here.node].size()) {
        leave(way);
        continue;
      }
      const auto [arc, to] = arcs_at_[here.node][here.tried++];
      if(order_[to] == unseen)
        enter(way, to, arc);
      else if(arc != here.arc)
        earliest_[here.node] = (std::min)(earliest_[here.node], order_[to]);
    }
  }

  void enter(std::vector<Place>& way, std::size_t node, std::size_t arc) {
    order_[node] = earliest_[node] = number_seen_++;
    way.push_back({node, arc});
  }

  void leave(std::vector<Place>& way) {
    const Place last = way.back();
    way.pop_back();
    if(way.empty())
      return;
    is_bridge_[last.arc] = earliest_[last.node] == order_[last.node];
    std::size_t& earliest = earliest_[way.back().node];
    earliest = (std::min)(earliest, earliest_[last.node]);
  }

  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> arcs_at_; // and their other ends
  std::vector<std::size_t> order_, earliest_; // by node: when it was found, and what leads back
  std::vector<bool> is_bridge_;               // by arc
  std::size_t number_seen_ = 0;
};

} // namespace

Arc_shapes shapes_of_arcs(const Mesh& mesh, const Reeb_answer& answer) {
  Arc_shapes shapes;
  shapes.girths = girths_of(mesh, answer);
  shapes.is_on_cycle = Bridge_search(answer.graph).is_bridge();
  shapes.is_on_cycle.flip();
  shapes.radii.resize(shapes.girths.size());
  for(const Edge& e : CGAL::make_range(edges(answer.graph))) {
    const auto& arc = answer.graph[e];
    shapes.radii[arc.index] = radii_of(mesh, arc, shapes.girths[arc.index]);
  }
  return shapes;
}

} // namespace htloops
