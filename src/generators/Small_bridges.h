// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SMALL_BRIDGES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SMALL_BRIDGES_H

#include "Patched_surface.h"
#include "Points_in_cells.h"
#include "Random.h"
#include "Vertex_stars.h"
#include "annulus.h"
#include "vertex_normals.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/*!
Builds arches on a fine surface: tubes that leave it at one place and come back a few edges away,
above it or, as tunnels, below.

Each has a ball for its own in which the surface is nearly flat: a graph over a plane, between two
heights. The arch begins above all of that and stands on two discs that are taken out, so it meets
nothing. Its own parts do not meet as it is thinner than it bends, and the balls are disjoint.
*/
class Small_bridges
{
public:
  /// no loop around an arch or through it needs to be longer, in mean lengths of edges.
  static constexpr double most_length = 20.;

  Small_bridges(const Soup& soup, double edge_length)
      : soup_(soup)
      , edge_length_(edge_length)
      , stars_(soup)
      , cells_(soup, ball_radius(most_rings) + margin * edge_length)
      , normals_(vertex_normals(soup))
      , is_taken_(soup.points.size(), 0)
      , surface_(soup) {}

  /// builds one around a vertex in a random direction, if there is room for it.
  bool build(std::uint32_t centre, bool is_tunnel, Random& random) {
    const int rings = random.below(4) == 0 ? most_rings : 1;
    const double angle = random.uniform(0., 2. * CGAL_PI);
    const double span = (2. * rings + 1.5) * random.uniform(1., 1.3) * edge_length_;
    const double height = random.uniform(0.75, 1.);
    if(is_taken_[centre] != 0)
      return false;
    const Frame frame = frame_at(centre, angle, is_tunnel);
    const std::optional<Ground> ground = ground_around(frame, rings);
    if(!ground)
      return false;
    const Foot left = foot_near(frame, *ground, -span / 2., rings);
    const Foot right = foot_near(frame, *ground, span / 2., rings);
    if(!are_disjoint(left, right))
      return false;
    return build(turned(frame, left, right), *ground, left, right, height);
  }

  Soup take() { return surface_.take(); }

private:
  static constexpr int most_rings = 2;
  static constexpr double margin = 1.5; ///< more than an edge is long, in mean lengths

  double ball_radius(int rings) const { return (3.3 * rings + 1.) * edge_length_; }

  /// A plane that touches the surface, counterclockwise as seen from outside.
  struct Frame
  {
    Vector origin, along, aside, up; ///< up is inwards for a tunnel

    Point_2 in_plane(const Vector& p) const { return {(p - origin) * along, (p - origin) * aside}; }
    double height(const Vector& p) const { return (p - origin) * up; }
  };

  Frame frame_at(std::uint32_t v, double angle, bool is_tunnel) const {
    const Vector normal = normals_[v] / length(normals_[v]);
    const Vector axis = std::abs(normal.x()) < 0.6 ? Vector(1, 0, 0) : Vector(0, 1, 0);
    Vector x = CGAL::cross_product(axis, normal);
    x = x / length(x);
    const Vector along = std::cos(angle) * x + std::sin(angle) * CGAL::cross_product(normal, x);
    return {point_of(soup_, v), along, CGAL::cross_product(normal, along),
            is_tunnel ? -normal : normal};
  }

  /// The part of the surface around an arch.
  struct Ground
  {
    std::vector<std::uint32_t> own; ///< the vertices that no other arch may come near to
    double radius;
    double highest;
  };

  /// nothing if another arch is there, or the surface is not flat enough.
  std::optional<Ground> ground_around(const Frame& frame, int rings) const {
    const double most_difference = 1.3 * rings * edge_length_;
    Ground ground = {{}, ball_radius(rings), 0.};
    double lowest = 0.;
    const double own_radius = ground.radius + 0.5 * edge_length_;
    for(const std::uint32_t v : cells_.within(frame.origin, ground.radius + margin * edge_length_))
    {
      const Vector p = point_of(soup_, v);
      if((p - frame.origin).squared_length() < own_radius * own_radius) {
        if(is_taken_[v] != 0)
          return std::nullopt;
        ground.own.push_back(v);
      }
      lowest = (std::min)(lowest, frame.height(p));
      ground.highest = (std::max)(ground.highest, frame.height(p));
      const double slope = normals_[v] * CGAL::cross_product(frame.along, frame.aside);
      if(ground.highest - lowest > most_difference || slope < 0.6 * length(normals_[v]))
        return std::nullopt;
    }
    return ground;
  }

  /// A disc where an arch will stand.
  struct Foot
  {
    std::uint32_t centre;
    Indices triangles, cycle;
  };

  Foot foot_near(const Frame& frame, const Ground& ground, double along, int rings) const {
    const auto distance = [&](std::uint32_t v) {
      const auto [x, y] = frame.in_plane(point_of(soup_, v));
      return std::hypot(x - along, y);
    };
    Foot foot = {ground.own.front(), {}, {}};
    for(const std::uint32_t v : ground.own)
      if(distance(v) < distance(foot.centre))
        foot.centre = v;
    foot.triangles = stars_.triangles_around(foot.centre, rings);
    foot.cycle = stars_.boundary(foot.triangles);
    return foot;
  }

  static bool are_disjoint(const Foot& left, const Foot& right) {
    for(const std::uint32_t v : left.cycle)
      if(std::find(right.cycle.begin(), right.cycle.end(), v) != right.cycle.end())
        return false;
    return !left.cycle.empty() && !right.cycle.empty() && left.centre != right.centre;
  }

  /// the frame with its origin half-way between the feet, and its first axis from one to the other.
  Frame turned(const Frame& frame, const Foot& left, const Foot& right) const {
    const auto [x, y] = frame.in_plane(point_of(soup_, left.centre));
    const auto [u, v] = frame.in_plane(point_of(soup_, right.centre));
    const double size = std::hypot(u - x, v - y), c = (u - x) / size, s = (v - y) / size;
    return {frame.origin + (x + u) / 2. * frame.along + (y + v) / 2. * frame.aside,
            c * frame.along + s * frame.aside, c * frame.aside - s * frame.along, frame.up};
  }

  /// the cycle around a foot as seen from above, its centre at the origin.
  std::vector<Point_2> outline(const Frame& frame, const Foot& foot) const {
    const Point_2 centre = frame.in_plane(point_of(soup_, foot.centre));
    std::vector<Point_2> points;
    for(const std::uint32_t v : foot.cycle) {
      const Point_2 p = frame.in_plane(point_of(soup_, v));
      points.push_back({p[0] - centre[0], p[1] - centre[1]});
    }
    return points;
  }

  static double inner_radius(const std::vector<Point_2>& outline) {
    const Point_2 origin = {0., 0.};
    double radius = std::hypot(outline[0][0], outline[0][1]);
    for(std::size_t i = 0; i < outline.size(); ++i) {
      const Point_2 &p = outline[i], &q = outline[i + 1 == outline.size() ? 0 : i + 1];
      radius = (std::min)(radius, cross(origin, p, q) / std::hypot(q[0] - p[0], q[1] - p[1]));
    }
    return radius;
  }

  static std::vector<Point_2> circle(std::size_t size, double radius, bool is_mirrored) {
    std::vector<Point_2> points;
    for(std::size_t i = 0; i < size; ++i) {
      const double angle = 2. * CGAL_PI * static_cast<double>(i) / static_cast<double>(size);
      // Mirrored in the second axis, and in the opposite order to be counterclockwise again.
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      points.push_back(is_mirrored ? Point_2{-x, -y} : Point_2{x, y});
    }
    return points;
  }

  /// \p frame is between the feet; \p height is relative to half of the span.
  bool build(const Frame& frame,
             const Ground& ground,
             const Foot& left,
             const Foot& right,
             double height) {
    const std::vector<Point_2> left_outline = outline(frame, left),
                               right_outline = outline(frame, right);
    const double radius =
        0.55 * (std::min)(inner_radius(left_outline), inner_radius(right_outline));
    const double half_span = -frame.in_plane(point_of(soup_, left.centre))[0];
    const double base = ground.highest + 0.25 * edge_length_;
    height = (std::min)(height * half_span, ground.radius - radius - base);
    if(radius < 0.2 * edge_length_ || height < 1.5 * radius)
      return false;
    const std::size_t size = (left.cycle.size() + right.cycle.size()) / 2;
    const auto left_annulus = annulus(left_outline, circle(size, radius, false));
    const auto right_annulus = annulus(right_outline, circle(size, radius, true));
    if(left_annulus.empty() || right_annulus.empty())
      return false;
    surface_.remove(left.triangles);
    surface_.remove(right.triangles);
    for(const std::uint32_t v : ground.own)
      is_taken_[v] = 1;
    const auto [first, last] = add_tube(frame, base, half_span, height, radius, size);
    add(left_annulus, left.cycle, first);
    add(right_annulus, right.cycle, last);
    return true;
  }

  /// half of an ellipse. Returns the rings at its ends, counterclockwise as seen from outside.
  std::pair<Indices, Indices> add_tube(const Frame& frame,
                                       double base,
                                       double half_span,
                                       double height,
                                       double radius,
                                       std::size_t size) {
    const auto steps =
        (std::max<std::size_t>)(5, std::lround(CGAL_PI * half_span / (0.9 * edge_length_)));
    Indices first, last;
    for(std::size_t step = 0; step <= steps; ++step) {
      const double angle = CGAL_PI * static_cast<double>(step) / static_cast<double>(steps);
      const double c = std::cos(angle), s = std::sin(angle);
      const Vector centre =
          frame.origin - half_span * c * frame.along + (base + height * s) * frame.up;
      Vector inwards = height * c * frame.along - half_span * s * frame.up;
      inwards = inwards / length(inwards);
      Indices ring;
      for(const auto& [x, y] : circle(size, radius, false))
        ring.push_back(surface_.add_point(centre + x * inwards + y * frame.aside));
      if(step == 0)
        first = ring;
      else
        surface_.add_band(last, ring);
      last = std::move(ring);
    }
    return {first, mirrored(last)};
  }

  /// in the order of the mirrored circle.
  static Indices mirrored(const Indices& ring) {
    Indices result;
    for(std::size_t i = 0; i < ring.size(); ++i)
      result.push_back(ring[(ring.size() - i) % ring.size()]);
    return result;
  }

  void add(const std::vector<std::array<std::uint32_t, 3>>& triangles,
           const Indices& outer,
           const Indices& inner) {
    const auto vertex = [&](std::uint32_t i) {
      return i < outer.size() ? outer[i] : inner[i - outer.size()];
    };
    for(const auto& [a, b, c] : triangles)
      surface_.add_triangle(vertex(a), vertex(b), vertex(c));
  }

  const Soup& soup_;
  double edge_length_;
  Vertex_stars stars_;
  Points_in_cells cells_;
  std::vector<Vector> normals_;
  std::vector<char> is_taken_;
  Patched_surface surface_;
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SMALL_BRIDGES_H
