// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_OFFSET_GROWTH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_OFFSET_GROWTH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// About how fast loops become longer when they are moved outwards (paper, 4.5): in floating point,
/// for choices of which each is right. `Offset_classifier` does the same exactly.
class Offset_growth
{
public:
  explicit Offset_growth(const Flat_mesh& mesh)
      : mesh_(mesh)
      , volume_(mesh.seeds.size(), 0.) {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      volume_[mesh.component[v]] += volume_at(v);
  }

  /// the derivative of the length by the way along the normals.
  double operator()(const Crossing_loop& loop) const {
    CGAL_precondition(!loop.empty());
    double sum = 0.;
    Vector p = position(mesh_, loop.back()), n = normal(loop.back());
    for(const Crossing& c : loop) {
      const Vector q = position(mesh_, c), m = normal(c);
      const double distance = norm(q - p);
      if(distance > 0.)
        sum += dot(m - n, q - p) / distance;
      p = q;
      n = m;
    }
    return volume_[mesh_.component[loop.front().left]] < 0. ? -sum : sum;
  }

private:
  // Of the cones from the seed over the faces that v is the smallest vertex of, six times.
  double volume_at(Index v) const {
    const Vector& origin = mesh_.points[mesh_.seeds[mesh_.component[v]]];
    const Ring ring = mesh_.ring(v);
    double sum = 0.;
    for(Index i = 0; i < ring.size(); ++i) {
      const Index a = ring[i], b = ring[ring.next(i)];
      if(v < a && v < b)
        sum += dot(mesh_.points[v] - origin,
                   cross(mesh_.points[a] - origin, mesh_.points[b] - origin));
    }
    return sum;
  }

  Vector normal(Index v) const {
    const Ring ring = mesh_.ring(v);
    Vector sum = {0., 0., 0.};
    for(Index i = 0; i < ring.size(); ++i)
      sum = sum + cross(mesh_.points[ring[i]] - mesh_.points[v],
                        mesh_.points[ring[ring.next(i)]] - mesh_.points[v]);
    return normalized(sum);
  }

  Vector normal(const Crossing& c) const {
    return normalized((1. - c.ratio) * normal(c.left) + c.ratio * normal(c.right));
  }

  static Vector normalized(const Vector& a) {
    const double length = norm(a);
    return length > 0. ? (1. / length) * a : a;
  }

  const Flat_mesh& mesh_;
  std::vector<double> volume_; // by component; negative if the faces look inwards
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_OFFSET_GROWTH_H
