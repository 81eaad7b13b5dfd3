// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINK_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINK_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Component_orientation.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Linking_numbers.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Projected_points.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/link.h>
#include <CGAL/Handle_tunnel_loops/internal/support/exact_vectors.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

CGAL_HTL_CORE Linking link(Execution execution, const Surface_curves& curves, bool do_link) {
  Linking_numbers numbers(execution, curves);
  if(do_link)
    numbers.link(execution);
  return {numbers.intersections(), numbers.linking(), numbers.defect(), numbers.contacts(),
          numbers.has_too_many_contacts()};
}

CGAL_HTL_CORE std::vector<int> signs_of_volumes(
    std::size_t number_of_components,
    const std::function<void(const std::function<void(std::size_t, const Triangle&)>&)>&
        for_each_triangle) {
  std::vector<Exact_number> volumes(number_of_components);
  for_each_triangle([&](std::size_t component, const Triangle& t) {
    volumes[component] += dot(exact(t[0]), cross(exact(t[1]), exact(t[2])));
  });
  std::vector<int> signs;
  for(const Exact_number& volume : volumes)
    signs.push_back(sign_of(volume));
  return signs;
}

CGAL_HTL_CORE Seen_triangle see_triangle(const Triangle& t, const Vector& point) {
  const std::vector<Vector> vertices = {t[0], t[1], t[2], point};
  const Projected_points points(vertices, {0., 0.});
  const int sense = points.turn(0, 1, 2);
  for(Index i = 0; i < 3; ++i)
    if(sense == 0 || points.turn_to_moved(i, (i + 1) % 3, 3) != sense)
      return Seen_triangle::NOWHERE;
  const int height = points.side(0, 1, 2, 3) * sense;
  return height == 0  ? Seen_triangle::HERE
         : height < 0 ? Seen_triangle::ABOVE
                      : Seen_triangle::BELOW;
}

CGAL_HTL_CORE void sort_positions(Execution execution, std::vector<Edge_position>& positions) {
  sort(execution, positions.begin(), positions.end(), std::less<Edge_position>());
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LINK_IMPL_H
