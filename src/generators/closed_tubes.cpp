// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Random.h"
#include "closed_curves.h"
#include "functions.h"
#include "kinds.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// The numbers of rings along a tube and of vertices around it.
struct Grid_size
{
  std::size_t along, around;
};

/// the torus of a grid that is periodic both ways, its quadrangles cut in two. It is oriented by
/// (along, around), as are the arguments of `point`.
template <typename Point_function> Soup grid_surface(Grid_size size, const Point_function& point) {
  const auto vertex = [&](std::size_t i, std::size_t j) {
    return static_cast<std::uint32_t>((i % size.along) * size.around + j % size.around);
  };
  Soup soup;
  soup.points.reserve(size.along * size.around);
  soup.triangles.reserve(2 * size.along * size.around);
  for(std::size_t i = 0; i < size.along; ++i)
    for(std::size_t j = 0; j < size.around; ++j) {
      add_point(soup, point(i, j));
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return soup;
}

/// A point of the centre line with two unit vectors normal to the line and each other.
struct Ring
{
  Vector centre, tangent, normal, binormal;

  void set_normal(const Vector& v) {
    normal = unit(v - (v * tangent) * tangent);
    binormal = CGAL::cross_product(tangent, normal);
  }
};

/// some direction that is not along the tangent.
Vector away_from(const Vector& tangent) {
  return std::abs(tangent.z()) < 0.9 ? Vector(0, 0, 1) : Vector(1, 0, 0);
}

/// rings along the closed curve whose frames turn as little as possible: they are carried along it,
/// and the angle by which the last misses the first is shared among all.
std::vector<Ring> carry_frames(const Curve_by_length& curve, std::size_t count) {
  const double step = curve.length() / count;
  std::vector<Ring> rings(count + 1);
  for(std::size_t i = 0; i <= count; ++i) {
    const double s = step * (i % count);
    const double h = 1e-3 * curve.length();
    rings[i].centre = curve.point(s);
    rings[i].tangent = unit(curve.point(s + h < curve.length() ? s + h : s + h - curve.length()) -
                            curve.point(s > h ? s - h : s - h + curve.length()));
    rings[i].set_normal(i == 0 ? away_from(rings[0].tangent) : rings[i - 1].normal);
  }
  const double miss =
      arc_tangent(rings[count].normal * rings[0].binormal, rings[count].normal * rings[0].normal);
  rings.pop_back();
  for(std::size_t i = 0; i < count; ++i) {
    const double angle = -miss * i / count;
    rings[i].set_normal(cosine(angle) * rings[i].normal + sine(angle) * rings[i].binormal);
  }
  return rings;
}

/// the grid of about a number of faces whose quadrangles are nearly square on a tube of which the
/// length is `aspect` times the circumference.
Grid_size grid_size(std::size_t faces, double aspect) {
  // A side of three is the least for which no two edges join the same vertices.
  const auto at_least_3 = [](double n) { return (std::max<std::size_t>)(3, std::lround(n)); };
  Grid_size size;
  size.around = at_least_3(std::sqrt(faces / (2. * aspect)));
  size.along = at_least_3(faces / (2. * size.around));
  return size;
}

/// a round tube of about a number of faces around a closed curve. It does not cross itself if the
/// curve keeps away from itself and the faces are enough to follow it.
Soup closed_tube(const Curve_by_length& curve, double radius, std::size_t faces) {
  const Grid_size size = grid_size(faces, curve.length() / (2. * CGAL_PI * radius));
  const std::vector<Ring> rings = carry_frames(curve, size.along);
  return grid_surface(size, [&](std::size_t i, std::size_t j) {
    const double v = 2. * CGAL_PI * j / size.around;
    const Ring& ring = rings[i];
    return ring.centre + radius * (cosine(v) * ring.normal - sine(v) * ring.binormal);
  });
}

/// One ring of a chain along the x axis: an ellipse whose plane contains the axis and is about
/// upright to those of its neighbours. Rings of these sizes pass through the next and touch none.
Curve_by_length ring_curve(std::size_t number, Random& random) {
  constexpr double distance = 1.4, most_tilt = CGAL_PI / 12.;
  const double half_width = random.uniform(0.9, 1.25);
  const double angle = (number % 2) * CGAL_PI / 2. + random.uniform(-most_tilt, most_tilt);
  const Vector centre(distance * number, 0, 0), across(0, cosine(angle), sine(angle));
  return Curve_by_length([=](double t) {
    return centre + cosine(t) * Vector(1, 0, 0) + half_width * sine(t) * across;
  });
}

Vector trefoil(double t) {
  return Vector(sine(t) + 2. * sine(2. * t), cosine(t) - 2. * cosine(2. * t), -sine(3. * t));
}

// A third of the room is for the tubes, and some of the rest for the difference to their chords.
constexpr double tube_part = 0.3, error_part = 0.15;

/// of one tube, so that it has rings enough to follow its curve; see `grid_size()`.
std::size_t least_faces(const Torus_knot& knot, double room, double length) {
  const auto rings = static_cast<double>(knot.least_samples(error_part * room));
  const double aspect = length / (2. * CGAL_PI * tube_part * room);
  return static_cast<std::size_t>((std::max)(6. * rings, 2. * rings * rings / aspect)) + 6;
}

} // namespace

Soup make_chain(const Request& request) {
  require_least_genus(request, "chain", 1);
  require_faces(request, "chain", 72 * request.genus);
  Random random(request.seed);
  std::vector<Soup> rings;
  for(std::size_t i = 0; i < request.genus; ++i) {
    const Curve_by_length curve = ring_curve(i, random);
    rings.push_back(closed_tube(curve, random.uniform(0.1, 0.25), request.faces / request.genus));
  }
  return joined(rings);
}

Soup make_knot(const Request& request) {
  constexpr double tube_radius = 0.45;
  require_genus(request, "knot", 1);
  require_faces(request, "knot", 150);
  return closed_tube(Curve_by_length(trefoil), tube_radius, request.faces);
}

Soup make_torus(const Request& request) {
  constexpr double radius = 1., tube_radius = 0.4;
  require_genus(request, "torus", 1);
  require_faces(request, "torus", 18);

  const Grid_size size = grid_size(request.faces, radius / tube_radius);
  return grid_surface(size, [&](std::size_t i, std::size_t j) {
    const double u = 2. * CGAL_PI * i / size.along, v = 2. * CGAL_PI * j / size.around;
    const double r = radius + tube_radius * cosine(v);
    return Vector(r * cosine(u), r * sine(u), tube_radius * sine(v));
  });
}

Soup make_torus_link(const Request& request) {
  require_least_genus(request, "torus-link", 1);
  const Torus_knot knot(request.p, request.q);
  const std::size_t strands = request.genus;
  const double angle = knot.period() / strands, room = knot.distance(angle);
  std::vector<Soup> tubes;
  for(std::size_t i = 0; i < strands; ++i) {
    const Curve_by_length curve([&](double t) { return knot.point(t, i * angle); });
    if(i == 0)
      require_faces(request, "torus-link", strands * least_faces(knot, room, curve.length()));
    tubes.push_back(closed_tube(curve, tube_part * room, request.faces / strands));
  }
  return joined(tubes);
}

} // namespace CGAL::Handle_tunnel_loops::generators
