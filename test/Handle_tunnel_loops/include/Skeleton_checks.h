// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Skeletons drawn by hand, the surfaces around them, and whether their certificate says what holds
// by definition.

#ifndef HTL_TEST_SKELETON_CHECKS_H
#define HTL_TEST_SKELETON_CHECKS_H

#include "Generated_soups.h"
#include "Meshes_of_soups.h"
#include "Skeleton_definitions.h"
#include "Solids.h"

#include <CGAL/certify_curve_skeleton.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace skeleton_checks {

using Graph = CGAL::Curve_skeleton<Mesh>;
using Certificate = CGAL::Handle_tunnel_loops::Skeleton_certificate;
using Line = std::vector<Vector>;

// ---- surfaces

// A tube around a circle of the plane z = 0, with so many corners across and along it.
inline Soup torus(double radius, double thickness, int across, int along) {
  Soup soup;
  constexpr double turn = 2. * 3.14159265358979;
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < across; ++j) {
      const double u = turn * i / along, v = turn * (j + 0.5) / across,
                   r = radius + thickness * std::cos(v);
      soup.points.push_back({r * std::cos(u), r * std::sin(u), thickness * std::sin(v)});
    }
  const auto number = [&](int i, int j) {
    return static_cast<std::uint32_t>(i % along * across + j % across);
  };
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < across; ++j) {
      soup.triangles.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      soup.triangles.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return soup;
}

// A tube along x, open at both ends.
inline Soup pipe(double length, double thickness, int across, int along) {
  Soup soup;
  constexpr double turn = 2. * 3.14159265358979;
  for(int i = 0; i <= along; ++i)
    for(int j = 0; j < across; ++j)
      soup.points.push_back({length * i / along, thickness * std::cos(turn * j / across),
                             thickness * std::sin(turn * j / across)});
  const auto number = [&](int i, int j) {
    return static_cast<std::uint32_t>(i * across + j % across);
  };
  for(int i = 0; i < along; ++i)
    for(int j = 0; j < across; ++j) {
      soup.triangles.push_back({number(i, j), number(i, j + 1), number(i + 1, j + 1)});
      soup.triangles.push_back({number(i, j), number(i + 1, j + 1), number(i + 1, j)});
    }
  return soup;
}

inline Soup together(Soup soup, const Soup& other) {
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  for(const auto& [a, b, c] : other.triangles)
    soup.triangles.push_back({first + a, first + b, first + c});
  return soup;
}

// Eight blocks around a hole, all faces of which are halves of squares.
inline Soup block_ring() {
  Soup soup;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto number = [&](const std::array<int, 3>& p) {
    const auto [it, is_new] = numbers.emplace(p, static_cast<std::uint32_t>(numbers.size()));
    if(is_new)
      soup.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return it->second;
  };
  const auto is_solid = [](const std::array<int, 3>& p) {
    return *std::min_element(p.begin(), p.end()) >= 0 && p[0] < 6 && p[1] < 6 && p[2] < 2 &&
           (p[0] / 2 != 1 || p[1] / 2 != 1);
  };
  for(int i = 0; i < 72; ++i)
    for(int side = 0; side < 6; ++side) {
      const std::array<int, 3> cell = {i % 6, i / 6 % 6, i / 36};
      std::array<int, 3> beside = cell, corner = cell;
      const int d = side / 2;
      beside[d] += side % 2 == 0 ? -1 : 1;
      if(!is_solid(cell) || is_solid(beside))
        continue;
      corner[d] += side % 2;
      std::array<std::uint32_t, 4> square;
      for(int k = 0; k < 4; ++k) {
        std::array<int, 3> p = corner;
        p[(d + 1) % 3] += k == 1 || k == 2;
        p[(d + 2) % 3] += k >= 2;
        square[side % 2 == 0 ? 3 - k : k] = number(p);
      }
      soup.triangles.push_back({square[0], square[1], square[2]});
      soup.triangles.push_back({square[0], square[2], square[3]});
    }
  return soup;
}

// ---- skeletons

inline std::size_t add_point(Graph& graph, const Vector& p, std::size_t component = 0) {
  const auto v = add_vertex(graph);
  graph[v].point = Mesh::Point(p[0], p[1], p[2]);
  graph[v].component = component;
  return v;
}

// Points along a line, as new vertices.
inline void add_line(Graph& graph, const Line& line, bool is_closed, std::size_t component = 0) {
  const std::size_t first = num_vertices(graph);
  for(const Vector& p : line) {
    const std::size_t v = add_point(graph, p, component);
    if(v != first)
      add_edge(v - 1, v, graph);
  }
  if(is_closed)
    add_edge(num_vertices(graph) - 1, first, graph);
}

// Around the axis z, so many times, rising and falling so far to come back without meeting itself.
inline Line wound(double radius, int times, double amplitude, int points, double spread = 0.) {
  Line line;
  for(int i = 0; i < points * times; ++i) {
    const double t = 2. * 3.14159265358979 * i / points, s = t / times;
    line.emplace_back((radius + spread * std::cos(s)) * std::cos(t),
                      (radius + spread * std::cos(s)) * std::sin(t), amplitude * std::sin(s));
  }
  return line;
}

// ---- certificates

inline Certificate check(const Mesh& mesh, const Graph& graph, const Pairs& pairs) {
  const Certificate certificate = CGAL::certify_curve_skeleton(mesh, graph, pairs);
  const Certificate by_threads =
      CGAL::certify_curve_skeleton<CGAL::Parallel_if_available_tag>(mesh, graph, pairs);
  EXPECT_EQ(by_threads.failure, certificate.failure);
  EXPECT_EQ(by_threads.edges_that_meet, certificate.edges_that_meet);
  const auto skeleton = skeleton_definitions::skeleton_of(graph);
  const auto truth = skeleton_definitions::truth(mesh, skeleton, pairs);
  EXPECT_EQ(certificate.connected, truth.is_connected) << certificate.failure;
  EXPECT_EQ(certificate.inside, truth.is_inside) << certificate.failure;
  EXPECT_EQ(certificate.embedded, truth.is_embedded) << certificate.failure;
  EXPECT_EQ(certificate.basis, truth.is_basis) << certificate.failure;
  EXPECT_EQ(certificate.failure.empty(), static_cast<bool>(certificate)) << certificate.failure;
  std::set<skeleton_definitions::Edge> outside;
  for(const auto& e : certificate.edges_outside)
    outside.insert({e.edge.first, e.edge.second});
  EXPECT_EQ(outside, truth.edges_outside);
  return certificate;
}

inline Certificate check(const Mesh& mesh, const Graph& graph) {
  return check(mesh, graph, find_loops(mesh));
}

inline void expect_failure(const Certificate& certificate, const std::string& words) {
  EXPECT_FALSE(certificate);
  EXPECT_NE(certificate.failure.find(words), std::string::npos) << certificate.failure;
}

} // namespace skeleton_checks

#endif // HTL_TEST_SKELETON_CHECKS_H
