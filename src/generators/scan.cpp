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
#include "bodies.h"
#include "functions.h"
#include "kinds.h"
#include "mesh_of_field.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/number_type_config.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

using Point_2 = std::array<double, 2>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

double cross(const Point_2& o, const Point_2& p, const Point_2& q) {
  return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
}

/// by how much one direction is counterclockwise of another, in [-pi, pi].
double turn(const Point_2& from, const Point_2& to) {
  return arc_tangent(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
}

/*!
Triangles between two cycles in the plane around the origin, both counterclockwise, one within the
other. Corners below the size of the outer cycle are its vertices, the others those of the inner
one. Nothing if the triangles overlapped: those here are all counterclockwise and go around once.
*/
Triangles annulus(const std::vector<Point_2>& outer, const std::vector<Point_2>& inner) {
  const auto n = static_cast<std::uint32_t>(outer.size());
  const auto m = static_cast<std::uint32_t>(inner.size());
  std::uint32_t nearest = 0;
  for(std::uint32_t j = 1; j < m; ++j)
    if(std::abs(turn(outer[0], inner[j])) < std::abs(turn(outer[0], inner[nearest])))
      nearest = j;
  Triangles triangles;
  double angle = 0., inner_angle = turn(outer[0], inner[nearest]);
  for(std::uint32_t i = 0, j = 0; i < n || j < m;) {
    const std::uint32_t u = i % n, next_u = (i + 1) % n;
    const std::uint32_t v = (nearest + j) % m, next_v = (nearest + j + 1) % m;
    const double step = turn(outer[u], outer[next_u]), inner_step = turn(inner[v], inner[next_v]);
    if(step <= 0. || inner_step <= 0.)
      return {};
    // The edge whose middle comes first.
    if(j == m || (i < n && angle + step / 2. <= inner_angle + inner_step / 2.)) {
      if(cross(outer[u], outer[next_u], inner[v]) <= 0.)
        return {};
      triangles.push_back({u, next_u, n + v});
      angle += step;
      ++i;
    } else {
      if(cross(outer[u], inner[next_v], inner[v]) <= 0.)
        return {};
      triangles.push_back({u, n + next_v, n + v});
      inner_angle += inner_step;
      ++j;
    }
  }
  const bool is_once_around = std::abs(angle - 2. * CGAL_PI) < 1e-6;
  return is_once_around ? triangles : Triangles();
}

/// The points of a mesh, with their numbers, to find those near a place.
using Numbered_point = std::pair<CGAL::Simple_cartesian<double>::Point_3, std::uint32_t>;
using Search_traits =
    CGAL::Search_traits_adapter<Numbered_point,
                                CGAL::First_of_pair_property_map<Numbered_point>,
                                CGAL::Search_traits_3<CGAL::Simple_cartesian<double>>>;
using Point_tree = CGAL::Kd_tree<Search_traits>;

/*!
Builds arches on a fine surface: tubes that leave it at one place and come back a few edges away,
above it or, as tunnels, below.

Each has a ball for its own in which the surface is nearly flat: a graph over a plane, between two
heights. The arch begins above all of that and stands on two discs that are taken out, so it meets
nothing. Its own parts do not meet as it is thinner than it bends, and the balls are disjoint.
No loop around an arch or through it needs to be longer than 20 mean lengths of edges.
*/
class Small_bridges
{
public:
  Small_bridges(const Soup& soup, double edge_length)
      : soup_(soup)
      , edge_length_(edge_length)
      , stars_(soup)
      , normals_(vertex_normals(soup))
      , is_taken_(soup.points.size(), 0)
      , surface_(soup) {
    for(std::uint32_t v = 0; v < soup.points.size(); ++v)
      tree_.insert(Numbered_point(CGAL::ORIGIN + point_of(soup, v), v));
  }

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
    const Vector normal = unit(normals_[v]);
    const Vector axis = std::abs(normal.x()) < 0.6 ? Vector(1, 0, 0) : Vector(0, 1, 0);
    const Vector x = unit(CGAL::cross_product(axis, normal));
    const Vector along = cosine(angle) * x + sine(angle) * CGAL::cross_product(normal, x);
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
    std::vector<Numbered_point> near;
    tree_.search(std::back_inserter(near),
                 CGAL::Fuzzy_sphere<Search_traits>(CGAL::ORIGIN + frame.origin,
                                                   ground.radius + margin * edge_length_));
    for(const auto& [point, v] : near) {
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
      return hypotenuse(x - along, y);
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
    const auto &a = left.cycle, &b = right.cycle;
    return !a.empty() && !b.empty() && left.centre != right.centre &&
           std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) == a.end();
  }

  /// the frame with its origin half-way between the feet, and its first axis from one to the other.
  Frame turned(const Frame& frame, const Foot& left, const Foot& right) const {
    const auto [x, y] = frame.in_plane(point_of(soup_, left.centre));
    const auto [u, v] = frame.in_plane(point_of(soup_, right.centre));
    const double size = hypotenuse(u - x, v - y), c = (u - x) / size, s = (v - y) / size;
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
    double radius = hypotenuse(outline[0][0], outline[0][1]);
    for(std::size_t i = 0; i < outline.size(); ++i) {
      const Point_2 &p = outline[i], &q = outline[i + 1 == outline.size() ? 0 : i + 1];
      radius = (std::min)(radius, cross(origin, p, q) / hypotenuse(q[0] - p[0], q[1] - p[1]));
    }
    return radius;
  }

  static std::vector<Point_2> circle(std::size_t size, double radius, bool is_mirrored) {
    std::vector<Point_2> points;
    for(std::size_t i = 0; i < size; ++i) {
      const double angle = 2. * CGAL_PI * static_cast<double>(i) / static_cast<double>(size);
      // Mirrored in the second axis, and in the opposite order to be counterclockwise again.
      const double x = radius * cosine(angle), y = radius * sine(angle);
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
      const double c = cosine(angle), s = sine(angle);
      const Vector centre =
          frame.origin - half_span * c * frame.along + (base + height * s) * frame.up;
      const Vector inwards = unit(height * c * frame.along - half_span * s * frame.up);
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
  static Indices mirrored(Indices ring) {
    std::reverse(ring.begin() + 1, ring.end());
    return ring;
  }

  void add(const Triangles& triangles, const Indices& outer, const Indices& inner) {
    const auto vertex = [&](std::uint32_t i) {
      return i < outer.size() ? outer[i] : inner[i - outer.size()];
    };
    for(const auto& [a, b, c] : triangles)
      surface_.add_triangle(vertex(a), vertex(b), vertex(c));
  }

  const Soup& soup_;
  double edge_length_;
  Vertex_stars stars_;
  Point_tree tree_;
  std::vector<Vector> normals_;
  std::vector<char> is_taken_;
  Patched_surface surface_;
};

Rounded_body random_body(std::size_t handles, Random& random) {
  std::vector<Rounded_body::Ball> bumps;
  for(const double side : {-1., 1., 1.}) {
    const double angle = random.uniform(0., 2. * CGAL_PI), radius = random.uniform(0.45, 0.6);
    bumps.push_back(
        {Vector(0.3 * cosine(angle), 0.3 * sine(angle), side * random.uniform(0.5, 0.7)), radius});
  }
  return Rounded_body(handles, random.uniform(0., 2. * CGAL_PI), bumps);
}

/// Waves in random directions, with a height that keeps their slopes small.
class Random_relief
{
public:
  explicit Random_relief(Random& random) {
    for(Wave& wave : waves_) {
      const double steepness = random.uniform(6., 30.);
      for(double& x : wave.steps)
        x = steepness * random.uniform(-1., 1.);
      wave.phase = random.uniform(0., 2. * CGAL_PI);
      wave.height = 0.1 / steepness;
    }
  }

  double operator()(const std::array<double, 3>& p) const {
    double sum = 0.;
    for(const Wave& wave : waves_)
      sum += wave.height *
             sine(wave.steps[0] * p[0] + wave.steps[1] * p[1] + wave.steps[2] * p[2] + wave.phase);
    return sum;
  }

private:
  struct Wave
  {
    std::array<double, 3> steps;
    double phase, height;
  };
  std::array<Wave, 10> waves_;
};

/// a relief, and what a scanner gets wrong at each point.
void roughen(Soup& soup, double edge_length, Random& random) {
  const Random_relief relief(random);
  const std::vector<Vector> normals = vertex_normals(soup);
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    const double height = relief(soup.points[v]) + edge_length * random.uniform(-0.1, 0.1);
    const Vector by = height / length(normals[v]) * normals[v];
    for(int i = 0; i < 3; ++i)
      soup.points[v][i] += by[i];
  }
}

Soup with_small_bridges(const Soup& soup,
                        double edge_length,
                        const Request& request,
                        Random& random) {
  std::vector<char> is_tunnel(request.bridges + request.tunnels, 0);
  std::fill_n(is_tunnel.begin(), request.tunnels, char(1));
  random.shuffle(is_tunnel);
  std::vector<std::uint32_t> places(soup.points.size());
  std::iota(places.begin(), places.end(), 0u);
  random.shuffle(places);

  Small_bridges bridges(soup, edge_length);
  std::size_t built = 0;
  for(std::size_t i = 0; i < places.size() && built < is_tunnel.size(); ++i)
    built += bridges.build(places[i], is_tunnel[built] != 0, random);
  if(built < is_tunnel.size())
    throw std::invalid_argument(
        std::to_string(request.faces) + " faces have room for only " +
        counted(built, "small bridge or tunnel", "small bridges and tunnels") + ", not " +
        std::to_string(is_tunnel.size()));
  return bridges.take();
}

} // namespace

Soup make_scan(const Request& request) {
  constexpr std::size_t faces_of_bridge = 80;
  const std::size_t planted = request.bridges + request.tunnels;
  require_faces(request, "scan", Rounded_body::least_faces(request.genus) + 600 * planted,
                "with " + counted(request.genus, "large handle", "large handles") + " and " +
                    counted(planted, "bridge or tunnel", "bridges and tunnels"));
  Random random(request.seed);
  Soup soup = mesh_of_field(random_body(request.genus, random),
                            {request.faces - faces_of_bridge * planted, request.genus}, "scan");
  const double edge_length = mean_edge_length(soup);
  roughen(soup, edge_length, random);
  return with_small_bridges(soup, edge_length, request, random);
}

} // namespace CGAL::Handle_tunnel_loops::generators
