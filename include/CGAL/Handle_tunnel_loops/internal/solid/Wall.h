// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_WALL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_WALL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Exact_meeting.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the point of a triangle that is nearest to `p`, about.
inline Vector nearest_point(const Vector& p, const Vector& a, const Vector& b, const Vector& c) {
  const Vector ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if(d1 <= 0. && d2 <= 0.)
    return a;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if(d3 >= 0. && d4 <= d3)
    return b;
  const double vc = d1 * d4 - d3 * d2;
  if(vc <= 0. && d1 >= 0. && d3 <= 0.)
    return a + (d1 / (d1 - d3)) * ab;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if(d6 >= 0. && d5 <= d6)
    return c;
  const double vb = d5 * d2 - d1 * d6;
  if(vb <= 0. && d2 >= 0. && d6 <= 0.)
    return a + (d2 / (d2 - d6)) * ac;
  const double va = d3 * d6 - d5 * d4;
  if(va <= 0. && d4 - d3 >= 0. && d5 - d6 >= 0.)
    return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  const double sum = va + vb + vc;
  return sum > 0. ? a + (vb / sum) * ab + (vc / sum) * ac : a;
}

/// The surface as it is seen from inside. What is said of distances is about right; whether a
/// segment meets a face is exact.
class Wall
{
public:
  /// \p points are the places of the vertices, hubs included. All must outlive it.
  Wall(const Flat_mesh& mesh, Span<const Vector> points, const Face_tree& faces)
      : mesh_(mesh)
      , points_(points)
      , faces_(faces) {}

  std::size_t size() const { return faces_.size(); }
  const Face_tree::Corners& operator[](Index f) const { return faces_.corners(f); }
  Index component(Index f) const { return mesh_.component[faces_.corners(f)[0]]; }
  const Vector& corner(Index f, int k) const { return points_[faces_.corners(f)[k]]; }
  /// whether a piece of the solid has several surfaces, which are one component then.
  bool has_cavities() const {
    for(Index c = 0; c < mesh_.seeds.size(); ++c)
      if(mesh_.component[mesh_.seeds[c]] != c)
        return true;
    return false;
  }
  bool is_of_cap(Index f) const {
    const Face_tree::Corners& corners = faces_.corners(f);
    return mesh_.number_of_hubs > 0 &&
           std::any_of(corners.begin(), corners.end(), [this](Index v) { return mesh_.is_hub(v); });
  }
  Vector normal(Index f) const {
    return cross(corner(f, 1) - corner(f, 0), corner(f, 2) - corner(f, 0));
  }

  /// the corner of a face that is opposite to its longest side.
  int apex(Index f) const {
    double longest = -1.;
    int apex = 0;
    for(int k = 0; k < 3; ++k)
      if(const double length = length_opposite(f, k); length > longest) {
        longest = length;
        apex = k;
      }
    return apex;
  }

  double length_opposite(Index f, int k) const {
    return norm(corner(f, (k + 1) % 3) - corner(f, (k + 2) % 3));
  }

  /// A face that is near a point, and where on it.
  struct Nearest
  {
    Index face = no_index;
    double distance; ///< what was given, if there is no face
    Vector point;
  };

  /// a face that is not of a cap and nearer to a point than a distance, if there is one. No other
  /// is nearer than \p precision, at most 1, times as far. In the middle of the solid, what is
  /// about equally near is much.
  Nearest nearest(const Vector& p, double distance, double precision = 1.) const {
    Nearest best;
    double limit = distance * distance;
    faces_.boxes().for_each_nearer(p, limit, [&](Index f) {
      if(!is_of_cap(f)) {
        const Vector q = nearest_on(f, p);
        const double square = dot(q - p, q - p);
        if(square < limit) {
          limit = square;
          best.face = f;
          best.point = q;
        }
      }
      return best.face == no_index ? limit : precision * precision * limit;
    });
    best.distance = best.face == no_index ? distance : std::sqrt(limit);
    return best;
  }

  /// whether a face that is not of a cap is nearer to a point than a distance.
  bool is_within(const Vector& p, double distance) const {
    const double limit = distance * distance;
    bool is_found = false;
    faces_.boxes().for_each_nearer(p, limit, [&](Index f) {
      if(!is_of_cap(f)) {
        const Vector q = nearest_on(f, p);
        is_found = is_found || dot(q - p, q - p) < limit;
      }
      return is_found ? 0. : limit;
    });
    return is_found;
  }

  /// calls `f(face)` for the faces that are not of a cap and about as near to a point as this, or
  /// nearer.
  template <typename Function>
  void for_each_within(const Vector& p, double distance, const Function& f) const {
    const double limit = distance * distance;
    faces_.boxes().for_each_nearer(p, limit, [&](Index face) {
      if(!is_of_cap(face))
        f(face);
      return limit;
    });
  }

  /// how far one can go from a point of a face in a direction of length 1 until one meets another
  /// face, about; what is nearer than \p free is not looked at. Where the point is on an edge,
  /// rounding decides whether the way begins on the other face there.
  double free_way(const Vector& p, const Vector& direction, Index from, double free = 0.) const {
    return first_on_way(p, direction, from, free).way;
  }

  /// What is met on a way, and how far from its beginning.
  struct Met
  {
    double way = (std::numeric_limits<double>::infinity)();
    Index face = no_index;
  };

  /// the same with the face; what is farther away than \p most is not looked at, either.
  Met first_on_way(const Vector& p,
                   const Vector& direction,
                   Index from,
                   double free = 0.,
                   double most = (std::numeric_limits<double>::infinity)()) const {
    Met met = {most, no_index};
    faces_.boxes().for_each_on_way(p, direction, met.way, [&](Index f) {
      if(const double way = f != from ? way_to_face(p, direction, f) : 0.;
         way > free && way < met.way)
        met = {way, f};
      return met.way;
    });
    return met;
  }

  /// whether a segment meets the surface or a cap.
  bool meets(const Vector& a, const Vector& b) const {
    const Exact_segment segment = {exact_point(a), exact_point(b)};
    return faces_.any_near(a, b, [&](Index f) { return do_meet(segment, triangle(f)); });
  }

  /// whether a segment meets a cap, which balls may reach across.
  bool meets_cap(const Vector& a, const Vector& b) const {
    if(mesh_.number_of_hubs == 0)
      return false;
    const Exact_segment segment = {exact_point(a), exact_point(b)};
    return faces_.any_near(a, b,
                           [&](Index f) { return is_of_cap(f) && do_meet(segment, triangle(f)); });
  }

  /// whether a segment from a hub meets the surface or a cap other than there.
  bool is_met_from_hub(Index hub, const Vector& to) const {
    const Exact_point end = exact_point(to);
    const Exact_segment segment = {exact_point(points_[hub]), end};
    return faces_.any_near(points_[hub], to, [&](Index f) {
      const Exact_triangle t = triangle(f);
      for(int i = 0; i < 3; ++i)
        if(faces_.corners(f)[i] == hub)
          return do_meet_beyond_corner(end, {t[i], t[(i + 1) % 3], t[(i + 2) % 3]});
      return do_meet(segment, t);
    });
  }

private:
  Vector nearest_on(Index f, const Vector& p) const {
    return nearest_point(p, corner(f, 0), corner(f, 1), corner(f, 2));
  }

  Exact_triangle triangle(Index f) const {
    return {exact_point(corner(f, 0)), exact_point(corner(f, 1)), exact_point(corner(f, 2))};
  }

  double way_to_face(const Vector& p, const Vector& direction, Index f) const {
    constexpr double none = (std::numeric_limits<double>::infinity)();
    const Vector ab = corner(f, 1) - corner(f, 0), ac = corner(f, 2) - corner(f, 0);
    const Vector h = cross(direction, ac);
    const double det = dot(ab, h);
    if(det == 0.)
      return none;
    const Vector ap = p - corner(f, 0), q = cross(ap, ab);
    constexpr double margin = 1e-9;
    const double u = dot(ap, h) / det, v = dot(direction, q) / det, t = dot(ac, q) / det;
    return u >= -margin && v >= -margin && u + v <= 1. + margin ? t : none;
  }

  const Flat_mesh& mesh_;
  Span<const Vector> points_;
  const Face_tree& faces_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_WALL_H
