// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_RIM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_RIM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Polygon_in_space.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// as large as can be without overflow, or none where the face is too small for that.
inline Simple_cartesian<double>::Vector_3 normal_of(const Surgery_mesh& mesh, Index face) {
  using Normal = Simple_cartesian<double>::Vector_3;
  const Surgery_mesh::Face& c = mesh.corners(face);
  const auto from_first = [&](std::size_t i, int axis) {
    return mesh.point(c[i])[axis] / 2. - mesh.point(c[0])[axis] / 2.;
  };
  Normal u(from_first(1, 0), from_first(1, 1), from_first(1, 2)),
      v(from_first(2, 0), from_first(2, 1), from_first(2, 2));
  double size = 0.;
  for(int axis = 0; axis < 3; ++axis)
    size = (std::max)({size, std::abs(u[axis]), std::abs(v[axis])});
  return size > 0. ? CGAL::cross_product(u / size, v / size) : Normal(NULL_VECTOR);
}

/// a hole of a region, in the order of what closes it.
inline Polygon_in_space
rim_of(const Surgery_mesh& mesh, const Cut_region& region, std::size_t border) {
  Polygon_in_space rim;
  std::vector<Index> vertices;
  for(Index h : region.border(border)) {
    vertices.push_back(mesh.source(h));
    rim.points.push_back(mesh.point(mesh.source(h)));
    rim.normals_beyond.push_back(normal_of(mesh, mesh.face(mesh.twin(h))));
    rim.corners_beyond.push_back(mesh.point(mesh.target(mesh.next(mesh.twin(h)))));
  }
  rim.are_joined = [&mesh, &region, vertices](std::size_t i, std::size_t j) {
    const Index h = mesh.halfedge(vertices[i], vertices[j]);
    return h != no_index &&
           !(region.contains(mesh.face(h)) && region.contains(mesh.face(mesh.twin(h))));
  };
  return rim;
}

/// whether the face beyond a side of a flat rim continues its plane, so far as can be told from
/// coordinates that are rounded: a face may be so narrow that it has any normal.
inline bool is_level(const Polygon_in_space& rim, const Scaled_polygon& scaled, std::size_t side) {
  constexpr double cosine = 1. - 1e-5; // of a quarter of a degree
  const auto& beyond = rim.normals_beyond[side];
  const double lengths = std::sqrt(scaled.normal.squared_length() * beyond.squared_length()),
               product = scaled.normal * beyond;
  if(lengths == 0. || product >= cosine * lengths)
    return true;
  const auto corner = scaled.scaled(rim.corners_beyond[side]), &p = scaled.points[side],
             &q = scaled.points[(side + 1) % scaled.points.size()];
  if(!scaled.is_level(corner))
    return false;
  const double area = std::sqrt(CGAL::cross_product(q - p, corner - p).squared_length());
  return product > 0. || area <= Scaled_polygon::tolerance * std::sqrt((q - p).squared_length());
}

/// whether a hole is one in a plane: its border lies on that, and so do the faces beyond.
inline bool is_flush(const Polygon_in_space& rim) {
  const Scaled_polygon scaled(rim);
  if(!scaled.is_flat())
    return false;
  for(std::size_t side = 0; side < rim.size(); ++side)
    if(!is_level(rim, scaled, side))
      return false;
  return true;
}

/// the same but for what is left where a part was meshed anew: borders that leave the plane a
/// little, and faces beyond that do so here and there.
inline bool is_nearly_flush(const Polygon_in_space& rim) {
  constexpr double most_height = 0.03 /* of the size */, cosine = 0.966 /* of 15 degrees */,
                   most_of_rim = 0.1;
  const Scaled_polygon scaled(rim);
  if(!scaled.is_flat(most_height))
    return false;
  double length = 0., uneven = 0.;
  for(std::size_t side = 0; side < rim.size(); ++side) {
    const auto& beyond = rim.normals_beyond[side];
    const double step = std::sqrt(CGAL::squared_distance(
        scaled.points[side], scaled.points[(side + 1) % scaled.points.size()]));
    length += step;
    if(!(scaled.normal * beyond >=
         cosine * std::sqrt(scaled.normal.squared_length() * beyond.squared_length())))
      uneven += step;
  }
  return uneven <= most_of_rim * length;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_RIM_H
