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

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// Two surfaces with the same vertices and triangles, the second one turned over, between which
/// nothing is: the lines from the vertices of one to those of the other do not meet.
struct Two_walls
{
  Soup first;
  std::vector<Vector> opposite; ///< of each vertex of the first
};

/// Joins the walls by tubes from the star of a vertex to the star of the opposite one, narrower
/// half-way.
class Joined_walls
{
public:
  explicit Joined_walls(const Two_walls& walls)
      : walls_(walls)
      , stars_(walls.first)
      , is_taken_(walls.first.points.size(), 0)
      , edge_length_(mean_edge_length(walls.first))
      , surface_(both(walls)) {}

  /// joins them at a vertex, unless they are joined beside it.
  bool join(std::uint32_t centre) {
    const Indices triangles = stars_.triangles_around(centre, 1);
    const Indices cycle = stars_.boundary(triangles);
    const auto is_taken = [&](std::uint32_t v) { return is_taken_[v] != 0; };
    if(cycle.empty() || is_taken(centre) || std::any_of(cycle.begin(), cycle.end(), is_taken))
      return false;
    is_taken_[centre] = 1;
    for(const std::uint32_t v : cycle)
      is_taken_[v] = 1;
    take_out(triangles);
    add_tube(centre, cycle);
    return true;
  }

  Soup take() { return surface_.take(); }

private:
  static Soup both(const Two_walls& walls) {
    Soup second = {{}, reversed(walls.first).triangles};
    for(const Vector& p : walls.opposite)
      add_point(second, p);
    return joined({walls.first, second});
  }

  void take_out(Indices triangles) {
    surface_.remove(triangles);
    for(std::uint32_t& t : triangles)
      t += static_cast<std::uint32_t>(walls_.first.triangles.size());
    surface_.remove(triangles);
  }

  void add_tube(std::uint32_t centre, const Indices& cycle) {
    const double way = length(between(centre, 1.) - between(centre, 0.));
    const auto steps = std::clamp<std::size_t>(std::lround(way / edge_length_), 3, 12);
    Indices lower = cycle, upper(cycle.size());
    for(std::size_t step = 1; step < steps; ++step) {
      const double part = static_cast<double>(step) / static_cast<double>(steps);
      const double width = 1. - 0.4 * sine(CGAL_PI * part);
      for(std::size_t i = 0; i < cycle.size(); ++i)
        upper[i] = surface_.add_point(width * between(cycle[i], part) +
                                      (1. - width) * between(centre, part));
      surface_.add_band(lower, upper);
      lower = upper;
    }
    for(std::size_t i = 0; i < cycle.size(); ++i)
      upper[i] = cycle[i] + static_cast<std::uint32_t>(walls_.first.points.size());
    surface_.add_band(lower, upper);
  }

  Vector between(std::uint32_t v, double part) const {
    return (1. - part) * point_of(walls_.first, v) + part * walls_.opposite[v];
  }

  const Two_walls& walls_;
  Vertex_stars stars_;
  std::vector<char> is_taken_;
  double edge_length_;
  Patched_surface surface_;
};

/// joins the walls at some of the vertices for which `is_place(v)` holds.
template <typename IsPlace>
Soup joined_at_random(const Two_walls& walls,
                      const Request& request,
                      Random& random,
                      const IsPlace& is_place) {
  Joined_walls result(walls);
  Indices places;
  for(std::uint32_t v = 0; v < walls.first.points.size(); ++v)
    if(is_place(v))
      places.push_back(v);
  random.shuffle(places);
  std::size_t built = 0;
  for(std::size_t i = 0; i < places.size() && built < request.necks; ++i)
    built += result.join(places[i]);
  if(built < request.necks)
    throw std::invalid_argument(std::to_string(request.faces) + " faces have room for only " +
                                counted(built, "neck", "necks") + ", not " +
                                std::to_string(request.necks));
  return result.take();
}

/// half of the faces are for each of the walls.
Soup wall(const Request& request, const char* kind, Random& random) {
  constexpr std::size_t faces_of_neck = 60;
  require_faces(request, kind,
                2 * Rounded_body::least_faces(request.genus) + 3 * faces_of_neck * request.necks,
                "with genus " + std::to_string(request.genus) + " and " +
                    counted(request.necks, "neck", "necks"));
  if(request.necks == 0)
    refuse(kind, "needs at least one neck");
  // The bump is below, so that what is above is a cap of a ball.
  const Rounded_body body(request.genus, random.uniform(0., 2. * CGAL_PI),
                          {{Vector(0.1, 0., -0.6), 0.55}});
  const std::size_t faces = (request.faces - faces_of_neck * request.necks) / 2;
  return mesh_of_field(body, {faces, request.genus}, kind);
}

} // namespace

Soup make_twins(const Request& request) {
  constexpr double gap = 0.1;
  Random random(request.seed);
  Two_walls walls = {wall(request, "twins", random), {}};
  const double radius = Rounded_body::radius(request.genus), plane = radius + gap;
  for(std::uint32_t v = 0; v < walls.first.points.size(); ++v) {
    const Vector p = point_of(walls.first, v);
    walls.opposite.push_back(Vector(p.x(), p.y(), 2. * plane - p.z()));
  }
  // As near to where they face each other as there is room.
  const double edge_length = mean_edge_length(walls.first);
  const double place_radius = (std::min)(
      0.6 * radius, edge_length * (5. + 2.6 * std::sqrt(static_cast<double>(request.necks))));
  return joined_at_random(walls, request, random, [&](std::uint32_t v) {
    const Vector p = point_of(walls.first, v);
    return p.z() > 0. && hypotenuse(p.x(), p.y()) < place_radius;
  });
}

Soup make_hollow(const Request& request) {
  constexpr double thickness = 0.06;
  Random random(request.seed);
  Two_walls walls = {wall(request, "hollow", random), {}};
  const std::vector<Vector> normals = vertex_normals(walls.first);
  for(std::uint32_t v = 0; v < walls.first.points.size(); ++v)
    walls.opposite.push_back(point_of(walls.first, v) -
                             thickness / length(normals[v]) * normals[v]);
  return joined_at_random(walls, request, random, [](std::uint32_t) { return true; });
}

} // namespace CGAL::Handle_tunnel_loops::generators
