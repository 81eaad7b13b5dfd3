// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CROSSES_FACES_ALONG_AXIS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CROSSES_FACES_ALONG_AXIS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Polyline_shape.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// whether at least half of the edges and vertices of a loop have a face beside them that lies
/// along the axis of the loop, up to three degrees, as those of a cylinder do around which it goes.
template <typename Loop, typename TriangleMesh, typename PointMap>
bool crosses_faces_along_axis(const Loop& loop, const TriangleMesh& tm, PointMap point) {
  using Direction = Polyline_shape::Vector;
  constexpr double sine = 0.05;
  const auto place = [](const auto& p) {
    return Polyline_shape::Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                 CGAL::to_double(p.z()));
  };
  std::vector<Polyline_shape::Point> places;
  for(const auto& p : loop.points())
    places.push_back(place(p));
  const Direction axis = Polyline_shape(places).normal;
  // In a unit in which squares are numbers.
  const auto side = [&](auto from, auto to) {
    const Direction v = place(get(point, to)) - place(get(point, from));
    const double size = (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
    return size > 0. ? v / size : v;
  };
  const auto lies_along = [&](auto h) {
    if(is_border(h, tm))
      return false;
    const auto v = source(h, tm);
    const Direction n =
        CGAL::cross_product(side(v, target(h, tm)), side(v, target(next(h, tm), tm)));
    return std::abs(n * axis) <= sine * std::sqrt(n.squared_length());
  };
  // A loop along a mouth goes from vertex to vertex.
  const auto is_beside_one = [&](const auto& step) {
    const auto h = step.halfedge;
    if(!step.is_vertex())
      return lies_along(h) || lies_along(opposite(h, tm));
    const auto around = halfedges_around_target(step.ratio == 1. ? h : opposite(h, tm), tm);
    return std::any_of(around.begin(), around.end(), lies_along);
  };
  const auto number = std::count_if(loop.steps().begin(), loop.steps().end(), is_beside_one);
  return 2 * static_cast<std::size_t>(number) >= loop.size();
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CROSSES_FACES_ALONG_AXIS_H
