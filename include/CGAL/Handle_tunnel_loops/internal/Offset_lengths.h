// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_OFFSET_LENGTHS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_OFFSET_LENGTHS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Crossing_loop.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Tells handle loops from tunnel loops as the paper does (4.5): by the length of the loop after it
/// has been moved slightly along the normals. In floating point, for uses in which a wrong name
/// does no harm.
class Offset_lengths
{
public:
  explicit Offset_lengths(const Flat_mesh& mesh)
      : mesh_(mesh)
      , normal_(mesh.number_of_vertices(), Vector{0., 0., 0.})
      , volume_(mesh.seeds.size(), 0.) {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      const Ring ring = mesh.ring(v);
      for(Index i = 0; i < ring.size(); ++i)
        add_face(v, ring[i], ring[ring.next(i)]);
    }
  }

  /// by which part of its length a loop grows when it is moved outwards, per unit of the offset:
  /// the mean curvature of the surface along the loop. (The part, because a long loop that is not
  /// straight may well grow more than a short one around a thin tube.)
  double growth(const Crossing_loop& loop) const {
    const double offset = 1e-4 * length(mesh_, loop) / (1. + static_cast<double>(loop.size()));
    if(!(offset > 0.))
      return 0.;
    const double sign = volume_[mesh_.component[loop.front().left]] < 0. ? -1. : 1.;
    double before = 0., after = 0.;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const Crossing &c = loop[i], &d = loop[(i + 1) % loop.size()];
      const Vector step = position(mesh_, d) - position(mesh_, c);
      before += norm(step);
      after += norm(step + sign * offset * (normal(d) - normal(c)));
    }
    return (after - before) / (offset * before);
  }

private:
  // Of a face, each of its corners takes a part.
  void add_face(Index v, Index a, Index b) {
    const Vector p = mesh_.points[v], q = mesh_.points[a], r = mesh_.points[b];
    normal_[v] = normal_[v] + cross(q - p, r - p);
    const Vector& origin = mesh_.points[mesh_.seeds[mesh_.component[v]]];
    volume_[mesh_.component[v]] += dot(p - origin, cross(q - origin, r - origin));
  }

  Vector normal(const Crossing& c) const {
    return normalized((1. - c.ratio) * normalized(normal_[c.left]) +
                      c.ratio * normalized(normal_[c.right]));
  }

  static Vector normalized(const Vector& v) {
    const double length = norm(v);
    return length > 0. ? (1. / length) * v : v;
  }

  const Flat_mesh& mesh_;
  std::vector<Vector> normal_; // by vertex, of any length
  std::vector<double> volume_; // by component, eighteen times what it encloses
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_OFFSET_LENGTHS_H
