// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FRONT_MEAN_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FRONT_MEAN_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <algorithm>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The sum of places with weights; a front is summed up by the middles of the edges that it
/// crosses, each with about the length that the front has around it.
struct Front_mean
{
  Vector sum = {0., 0., 0.};
  double weight = 0.;

  Front_mean& operator+=(const Front_mean& other) {
    sum = sum + other.sum;
    weight += other.weight;
    return *this;
  }
  Front_mean& operator-=(const Front_mean& other) {
    sum = sum - other.sum;
    weight -= other.weight;
    return *this;
  }

  /// about the length of the front: on a regular triangulation each edge that it crosses counts
  /// with 1.73 edge lengths, and there are two of them on one.
  float girth() const { return static_cast<float>((std::max)(weight, 0.) / 3.46); }

  /// the mean of the places; `otherwise` if they weigh next to nothing, as on degenerate triangles.
  Vector mean(const Vector& otherwise) const {
    return weight > 1e-9 ? (1. / weight) * sum : otherwise;
  }
};

/// the part of a front that crosses the edge to the neighbour at a position in the ring of `v`; the
/// same from both ends of the edge. The vertices across it tell how far apart its neighbours are.
inline Front_mean crossing_of_front(const Flat_mesh& mesh, Index v, Ring ring, Index position) {
  const Vector& before = mesh.points[ring[ring.previous(position)]];
  const Vector& after = mesh.points[ring[ring.next(position)]];
  const double weight = norm(after - before);
  return {(0.5 * weight) * (mesh.points[v] + mesh.points[ring[position]]), weight};
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FRONT_MEAN_H
