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

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

using Index = std::uint32_t;

/// the angle around the origin, or a corner of a bore, of the i-th of n.
double turn(double i, double n) { return 2. * CGAL_PI * i / n; }

/// A drum with bores in a circle: a vertex in the middle of either end sees the near sides of all,
/// and has nearly half of all vertices as neighbours.
class Hub_drum
{
public:
  /// The numbers of edges on the near and the far side of a bore.
  Hub_drum(std::size_t bores, std::size_t near, std::size_t far)
      : bores_(bores)
      , near_(near)
      , far_(far) {
    add_pair(Vector(0., 0., 0.));
    for(std::size_t b = 0; b < bores; ++b)
      add_bore(turn(double(b), double(bores)));
    for(std::size_t b = 0; b < bores; ++b)
      add_sector(b);
  }

  Soup take() { return std::move(soup_); }

private:
  /// Vertices come in pairs, at the low and the high end: the index is that of the low one.
  Index add_pair(const Vector& p) {
    const Index low = add_point(soup_, p);
    add_point(soup_, p + Vector(0., 0., 1.));
    return low;
  }

  /// the corners around a bore, from where the hub sees it end, over the far side, and back; and
  /// those of the rim beyond its far side.
  void add_bore(double angle) {
    constexpr double distance = 0.6;
    const double radius = 0.7 * distance * sine(CGAL_PI / double(bores_));
    const Vector out(cosine(angle), sine(angle), 0.), left(-out.y(), out.x(), 0.);
    const double end = arc_cosine(-radius / distance); // where tangents from the hub touch
    const auto corner = [&](double a) {
      return distance * out + radius * (cosine(a) * out + sine(a) * left);
    };
    bore_.push_back(static_cast<Index>(soup_.points.size()));
    for(std::size_t i = 0; i < far_; ++i)
      add_pair(corner(end * (2. * double(i) / double(far_) - 1.)));
    for(std::size_t i = 0; i < near_; ++i)
      add_pair(corner(end + 2. * (CGAL_PI - end) * double(i) / double(near_)));
    rim_.push_back(static_cast<Index>(soup_.points.size()));
    for(std::size_t i = 0; i <= far_; ++i)
      add_pair(unit(corner(end * (2. * double(i) / double(far_) - 1.))));
  }

  Index corner_of_bore(std::size_t b, std::size_t i) const {
    return bore_[b] + 2 * static_cast<Index>(i % (near_ + far_));
  }

  /// the faces of a bore, and of what is between it and the next.
  void add_sector(std::size_t b) {
    const std::size_t next = (b + 1) % bores_;
    for(std::size_t i = 0; i < near_ + far_; ++i)
      add_wall(corner_of_bore(b, i), corner_of_bore(b, i + 1));
    for(std::size_t i = far_; i < near_ + far_; ++i)
      add_at_both_ends(0, corner_of_bore(b, i + 1), corner_of_bore(b, i));
    add_at_both_ends(0, corner_of_bore(b, far_), corner_of_bore(next, 0));
    for(std::size_t i = 0; i <= far_; ++i) {
      const Index a = corner_of_bore(b, i), rim = rim_[b] + 2 * static_cast<Index>(i);
      const Index c = i < far_ ? corner_of_bore(b, i + 1) : corner_of_bore(next, 0);
      const Index next_rim = i < far_ ? rim + 2 : rim_[next];
      add_at_both_ends(a, rim, next_rim);
      add_at_both_ends(a, next_rim, c);
      add_wall(next_rim, rim);
    }
  }

  void add_at_both_ends(Index a, Index b, Index c) {
    soup_.triangles.push_back({a + 1, b + 1, c + 1});
    soup_.triangles.push_back({a, c, b});
  }

  /// between the ends, with the solid to the right of the way from one vertex to the other.
  void add_wall(Index a, Index b) {
    soup_.triangles.push_back({a, a + 1, b + 1});
    soup_.triangles.push_back({a, b + 1, b});
  }

  std::size_t bores_, near_, far_;
  std::vector<Index> bore_, rim_; ///< by bore: the first vertex
  Soup soup_;
};

} // namespace

Soup make_hubs(const Request& request) {
  constexpr std::size_t far = 3, least = 8 * (far + 1); // of the faces, per bore
  require_least_genus(request, "hubs", 3);
  require_faces(request, "hubs", double(request.genus) * double(least + 8));
  return Hub_drum(request.genus, (request.faces / request.genus - least) / 4, far).take();
}

Soup make_fan(const Request& request) {
  require_genus(request, "fan", 0);
  require_faces(request, "fan", 6);
  Random random(request.seed);
  const auto corners = static_cast<Index>(request.faces / 2);
  Soup soup;
  add_point(soup, Vector(0., 0., -2.));
  add_point(soup, Vector(0., 0., 0.));
  for(Index i = 0; i < corners; ++i) {
    const double angle = turn(i, corners);
    const Index a = add_point(soup, Vector(cosine(angle), sine(angle), random.uniform(-1., 1.)));
    const Index b = 2 + (i + 1) % corners;
    soup.triangles.push_back({1, a, b});
    soup.triangles.push_back({0, b, a});
  }
  return soup;
}

} // namespace CGAL::Handle_tunnel_loops::generators
