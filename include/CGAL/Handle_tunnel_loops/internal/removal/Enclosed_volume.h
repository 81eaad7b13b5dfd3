// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_ENCLOSED_VOLUME_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_ENCLOSED_VOLUME_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The volume that a surface with its caps bounds, and how it changes if faces take the place of
/// others. Where there is a boundary, inside is behind the faces.
class Enclosed_volume
{
  using Point = Surgery_mesh::Point;

public:
  explicit Enclosed_volume(const Surgery_mesh& mesh) {
    Index first = 0;
    while(first < mesh.face_bound() && !mesh.is_alive(first))
      ++first;
    if(first == mesh.face_bound())
      return;
    origin_ = mesh.point(mesh.corners(first)[0]);
    double sum = 0.;
    for(Index f = first; f < mesh.face_bound(); ++f)
      if(mesh.is_alive(f))
        sum += below(mesh, f);
    outward_ = sum < 0. && mesh.number_of_hubs() == 0 ? -1. : 1.;
  }

  /// of what lies between a face, or a triangle, and the origin: positive if that is inside. It
  /// makes no difference whether the faces of the surface point outwards.
  double below(const Surgery_mesh& mesh, Index f) const {
    const Surgery_mesh::Face& c = mesh.corners(f);
    return below(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2]));
  }
  double below(const Point& p, const Point& q, const Point& r) const {
    return outward_ * CGAL::volume(origin_, p, q, r);
  }

private:
  Point origin_; // a vertex
  double outward_ = 1.;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_ENCLOSED_VOLUME_H
