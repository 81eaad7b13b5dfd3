// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_OUT_OF_FRAME_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_OUT_OF_FRAME_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Own_frame.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// whether no edges meet the surface, but for those at inlets.
inline bool is_free(const Wall& wall, const Flat_skeleton& flat) {
  return std::none_of(flat.edges.begin(), flat.edges.end(), [&](const auto& e) {
    return flat.is_inlet[e[0]] == 0 && flat.is_inlet[e[1]] == 0 &&
           wall.meets(flat.points[e[0]], flat.points[e[1]]);
  });
}

/// gives points their distances to the surface, but for inlets.
inline void measure_radii(Execution execution, const Wall& wall, Flat_skeleton& flat) {
  constexpr double any = std::numeric_limits<double>::infinity();
  for_each_index(
      execution, flat.points.size(),
      [&](std::size_t p) {
        if(flat.is_inlet[p] == 0)
          flat.radii[p] = wall.nearest(flat.points[p], any).distance;
      },
      64);
}

/// the distance from a point of the frame of the caller to the faces, of which it is known but for
/// rounding in the frame of the wall, where the point is \p point.
inline double distance_of_caller(const Wall& wall,
                                 const Vector& point,
                                 double about,
                                 const Own_frame& frame_of_caller,
                                 const std::vector<Vector>& places,
                                 const Vector& point_of_caller) {
  constexpr double rounding = 0x1p-30;
  const Vector p = frame_of_caller.into(point_of_caller);
  double least = std::numeric_limits<double>::infinity();
  wall.for_each_within(point, about + rounding, [&](Index f) {
    const auto corner = [&](int k) { return frame_of_caller.into(places[wall[f][k]]); };
    least = (std::min)(least, norm(nearest_point(p, corner(0), corner(1), corner(2)) - p));
  });
  return frame_of_caller.length_out_of(least);
}

/// turns a skeleton that was found in a frame, with its radii, to the coordinates of the caller,
/// with those that it has there. Inlets are where the caller has them.
inline void take_out_of(Execution execution,
                        const Own_frame& frame,
                        const Solid_balls& solid,
                        const std::vector<Vector>& places,
                        Flat_skeleton& flat) {
  const Own_frame frame_of_caller = Own_frame::of_caller(places);
  std::map<Vector, Index> hub_at;
  for(Index hub = solid.mesh().first_hub; hub < places.size(); ++hub)
    hub_at.emplace(solid.points()[hub], hub);
  for_each_index(
      execution, flat.points.size(),
      [&](std::size_t p) {
        const Vector point = flat.points[p];
        if(flat.is_inlet[p] != 0) {
          flat.points[p] = places[hub_at.at(point)];
          flat.radii[p] = frame.length_out_of(flat.radii[p]);
        } else {
          flat.points[p] = frame.out_of(point);
          flat.radii[p] = distance_of_caller(solid.wall(), point, flat.radii[p], frame_of_caller,
                                             places, flat.points[p]);
        }
      },
      64);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_OUT_OF_FRAME_H
