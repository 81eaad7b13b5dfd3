// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_BODIES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_BODIES_H

#include "Field.h"
#include "functions.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {

/// A ball with handles around its equator, like those of a pot, and with smaller balls as bumps,
/// all blended. The handles are the same however many there are, the ball is as large as they need.
/// No loop that is not contractible is shorter than one.
class Rounded_body : public Field
{
public:
  struct Ball
  {
    Vector centre;
    double radius;
  };

  static constexpr double ring_radius = 0.5, tube_radius = 0.2;

  static double radius(std::size_t handles) {
    return (std::max)(1., 0.12 * static_cast<double>(handles));
  }

  /// the number of faces from which edges are short beside the handles.
  static std::size_t least_faces(std::size_t handles) {
    return static_cast<std::size_t>(25000. * radius(handles) * radius(handles));
  }

  /// \p bumps are those of a ball of radius one.
  Rounded_body(std::size_t handles, double first_angle, const std::vector<Ball>& bumps)
      : radius_(radius(handles)) {
    for(std::size_t i = 0; i < handles; ++i) {
      const double angle = first_angle + 2. * CGAL_PI * static_cast<double>(i) / handles;
      handles_.push_back(Vector(cosine(angle), sine(angle), 0.));
    }
    balls_.push_back({Vector(0., 0., 0.), radius_});
    for(const Ball& bump : bumps)
      balls_.push_back({radius_ * bump.centre, radius_ * bump.radius});
  }

  Box box() const override {
    return Box{Vector(0., 0., 0.), Vector(0., 0., 0.)}.grown(1.5 * radius_ + 0.5);
  }

  double operator()(const Vector& p) const override {
    constexpr double blend_of_balls = 0.1, blend_of_handles = 0.05;
    double sum = 0.;
    for(const Ball& ball : balls_)
      sum += exponential((ball.radius - length(p - ball.centre)) / (blend_of_balls * radius_));
    const double to_balls = -blend_of_balls * radius_ * logarithm(sum);
    double least = to_balls;
    for(const Vector& outwards : handles_)
      least = (std::min)(least, distance_to_handle(p, outwards));
    // Relative to the least one: what is far must not vanish altogether.
    double blended = exponential((least - to_balls) / blend_of_handles);
    for(const Vector& outwards : handles_)
      blended += exponential((least - distance_to_handle(p, outwards)) / blend_of_handles);
    return least - blend_of_handles * logarithm(blended);
  }

private:
  /// to the ring that stands upright on the equator.
  double distance_to_handle(const Vector& p, const Vector& outwards) const {
    const double out = p * outwards - radius_;
    const double aside = p.y() * outwards.x() - p.x() * outwards.y();
    return hypotenuse(hypotenuse(out, p.z()) - ring_radius, aside) - tube_radius;
  }

  double radius_;
  std::vector<Ball> balls_;
  std::vector<Vector> handles_; ///< the directions in which they are
};

using Indices = std::vector<std::uint32_t>;

/// Which triangles of a surface are at each vertex.
class Vertex_stars
{
public:
  explicit Vertex_stars(const Soup& soup)
      : soup_(soup)
      , triangles_(soup.points.size()) {
    for(std::uint32_t t = 0; t < soup.triangles.size(); ++t)
      for(const std::uint32_t v : soup.triangles[t])
        triangles_[v].push_back(t);
  }

  /// the triangles at the vertices up to `rings - 1` edges away.
  Indices triangles_around(std::uint32_t centre, int rings) const {
    Indices vertices = {centre}, triangles;
    while(true) {
      for(const std::uint32_t v : vertices)
        triangles.insert(triangles.end(), triangles_[v].begin(), triangles_[v].end());
      make_unique(triangles);
      if(--rings == 0)
        return triangles;
      for(const std::uint32_t t : triangles)
        vertices.insert(vertices.end(), soup_.triangles[t].begin(), soup_.triangles[t].end());
      make_unique(vertices);
    }
  }

  /// the boundary of a set of triangles, to the left of which they are, if it is one cycle without
  /// a vertex twice; otherwise nothing.
  Indices boundary(const Indices& triangles) const {
    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    std::set<Edge> edges;
    for(const std::uint32_t t : triangles)
      for(int i = 0; i < 3; ++i)
        edges.emplace(soup_.triangles[t][i], soup_.triangles[t][(i + 1) % 3]);
    std::map<std::uint32_t, std::uint32_t> next;
    for(const auto& [u, v] : edges)
      if(edges.count(Edge(v, u)) == 0 && !next.emplace(u, v).second)
        return {};
    Indices cycle;
    if(next.empty())
      return cycle;
    std::uint32_t v = next.begin()->first;
    do {
      cycle.push_back(v);
      v = next.at(v);
    } while(v != cycle.front());
    return cycle.size() == next.size() ? cycle : Indices();
  }

private:
  static void make_unique(Indices& indices) {
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  }

  const Soup& soup_;
  std::vector<Indices> triangles_; ///< by vertex
};

/// A surface out of which triangles are taken and to which others are added. Numbers of vertices
/// and triangles stay what they are until it is taken.
class Patched_surface
{
public:
  explicit Patched_surface(Soup soup)
      : soup_(std::move(soup))
      , is_removed_(soup_.triangles.size(), 0) {}

  std::uint32_t add_point(const Vector& p) { return generators::add_point(soup_, p); }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    soup_.triangles.push_back({a, b, c});
  }

  void remove(const Indices& triangles) {
    for(const std::uint32_t t : triangles)
      is_removed_[t] = 1;
  }

  /// joins two cycles of one size by a band, which is to the left of the lower one.
  void add_band(const Indices& lower, const Indices& upper) {
    for(std::size_t i = 0; i < lower.size(); ++i) {
      const std::size_t j = i + 1 == lower.size() ? 0 : i + 1;
      add_triangle(lower[i], lower[j], upper[i]);
      add_triangle(lower[j], upper[j], upper[i]);
    }
  }

  /// the surface, without the vertices that no triangle has any more.
  Soup take() {
    Soup rest;
    constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
    Indices new_index(soup_.points.size(), none);
    for(std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      if(t < is_removed_.size() && is_removed_[t] != 0)
        continue;
      rest.triangles.push_back(soup_.triangles[t]);
      for(const std::uint32_t v : soup_.triangles[t])
        new_index[v] = 0;
    }
    for(std::size_t v = 0; v < new_index.size(); ++v)
      if(new_index[v] != none) {
        new_index[v] = static_cast<std::uint32_t>(rest.points.size());
        rest.points.push_back(soup_.points[v]);
      }
    for(auto& triangle : rest.triangles)
      for(std::uint32_t& v : triangle)
        v = new_index[v];
    return rest;
  }

private:
  Soup soup_;
  std::vector<char> is_removed_; ///< of the triangles that were there first
};

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_BODIES_H
