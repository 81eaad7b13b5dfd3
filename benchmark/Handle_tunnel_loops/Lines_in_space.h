// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_LINES_IN_SPACE_H
#define BENCHMARK_LINES_IN_SPACE_H

#include "Solid.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// \file Lines_in_space.h
/// Curve skeletons of any origin as points and segments, and what can be counted of these.

/// A graph of segments.
struct Lines_in_space
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 2>> edges;

  Kernel::Segment_3 segment(std::size_t i) const {
    return {points[edges[i][0]], points[edges[i][1]]};
  }
};

/// the lines of a graph whose vertices have a property `point`.
template <typename Graph> Lines_in_space lines_of(const Graph& graph) {
  Lines_in_space lines;
  for(const auto v : CGAL::make_range(vertices(graph)))
    lines.points.push_back(graph[v].point);
  for(const auto e : CGAL::make_range(edges(graph)))
    lines.edges.push_back({source(e, graph), target(e, graph)});
  return lines;
}

inline double length(const Kernel::Segment_3& s) { return std::sqrt(s.squared_length()); }

inline double length(const Lines_in_space& lines) {
  double sum = 0.;
  for(std::size_t i = 0; i < lines.edges.size(); ++i)
    sum += length(lines.segment(i));
  return sum;
}

inline std::size_t number_of_parts(const Lines_in_space& lines) {
  boost::disjoint_sets_with_storage<> sets(lines.points.size());
  std::size_t number = lines.points.size();
  for(const auto& [a, b] : lines.edges)
    if(sets.find_set(a) != sets.find_set(b)) {
      sets.union_set(a, b);
      --number;
    }
  return number;
}

inline std::size_t number_of_cycles(const Lines_in_space& lines) {
  return lines.edges.size() + number_of_parts(lines) - lines.points.size();
}

/// the number of ways between nodes; a cycle alone has one.
inline std::size_t number_of_arcs(const Lines_in_space& lines) {
  std::vector<std::size_t> degree(lines.points.size(), 0);
  for(const auto& edge : lines.edges)
    for(const std::size_t v : edge)
      ++degree[v];
  boost::disjoint_sets_with_storage<> sets(lines.points.size());
  for(const auto& [a, b] : lines.edges)
    sets.union_set(a, b);
  std::vector<char> has_node(lines.points.size(), 0);
  std::size_t ends = 0, alone = 0;
  for(std::size_t v = 0; v < degree.size(); ++v)
    if(degree[v] != 2) {
      ends += degree[v];
      has_node[sets.find_set(v)] = 1;
    }
  for(std::size_t v = 0; v < degree.size(); ++v)
    alone += sets.find_set(v) == v && !has_node[v] ? 1 : 0;
  return ends / 2 + alone;
}

/// A place on a line, and the direction of the line there.
struct Place_on_line
{
  Point point;
  Kernel::Vector_3 direction;
};

/// places that stand for equal lengths of the lines: the middles of them.
inline std::vector<Place_on_line> places_on(const Lines_in_space& lines, std::size_t number) {
  const double step = length(lines) / double(number);
  std::vector<Place_on_line> places;
  double next = 0.5 * step; // counted from the start of the edge
  for(std::size_t i = 0; i < lines.edges.size(); ++i) {
    const Kernel::Segment_3 s = lines.segment(i);
    const double l = length(s);
    for(; next < l; next += step)
      places.push_back({s.source() + (next / l) * s.to_vector(), s.to_vector() / l});
    next -= l;
  }
  return places;
}

/// the distances to `b` of the ends of edges of `a`, and of places on them not farther apart than
/// `step`, are appended.
inline void add_distances(const Lines_in_space& a,
                          const Lines_in_space& b,
                          double step,
                          std::vector<double>& to) {
  std::vector<Kernel::Segment_3> segments;
  for(std::size_t i = 0; i < b.edges.size(); ++i)
    segments.push_back(b.segment(i));
  using Primitive =
      CGAL::AABB_segment_primitive<Kernel, std::vector<Kernel::Segment_3>::const_iterator>;
  const CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(segments.cbegin(),
                                                                   segments.cend());
  for(std::size_t i = 0; i < a.edges.size(); ++i) {
    const Kernel::Segment_3 s = a.segment(i);
    const double n = (std::max)(1., std::ceil(length(s) / step));
    for(double k = 0.; k <= n; ++k)
      to.push_back(std::sqrt(tree.squared_distance(s.source() + (k / n) * s.to_vector())));
  }
}

/// the distances of places on either lines to the others: the largest is the Hausdorff distance,
/// but for up to half a step. None if either has no edges.
inline std::vector<double>
distances_between(const Lines_in_space& a, const Lines_in_space& b, double step) {
  std::vector<double> distances;
  if(!a.edges.empty() && !b.edges.empty()) {
    add_distances(a, b, step, distances);
    add_distances(b, a, step, distances);
  }
  return distances;
}

#endif // BENCHMARK_LINES_IN_SPACE_H
