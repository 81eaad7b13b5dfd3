// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/surgery/self_contact.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Face_planes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Placed_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangle_contact.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/near_pairs.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

bool touches_itself(Execution execution,
                    const std::vector<Vector>& points,
                    const std::vector<std::array<Index, 3>>& faces) {
  const auto triangle = [&](std::size_t i) {
    Placed_triangle t;
    for(std::size_t k = 0; k < 3; ++k) {
      const Index v = faces[i][k];
      t.vertices[k] = v;
      t.points[k] = {points[v][0], points[v][1], points[v][2]};
    }
    return t;
  };
  std::atomic<bool> is_found(false);
  std::vector<Box<3>> boxes(faces.size());
  for_each_index(execution, faces.size(), [&](std::size_t i) {
    const Placed_triangle t = triangle(i);
    boxes[i] = t.box();
    if(t.is_degenerate())
      is_found = true;
  });
  if(is_found)
    return true;
  const auto are_touching = [&](Index i, Index j) {
    return are_in_contact(triangle(i), triangle(j));
  };
  const auto box = [&](std::size_t i) { return boxes[i]; };
  const Placed_boxes placed(execution, faces.size(), box);
  constexpr double usual_crowding = 32., largest_crowding_of_planes = 256.;
  const auto one = [](Index, Index) { return 1.; };
  if(placed.crowding(box, usual_crowding, one) <= usual_crowding)
    return placed.any_pair(box, are_touching, execution);
  const Face_planes planes(execution, faces.size(), triangle);
  const auto are_beside = [&](Index i, const Placed_triangle& s, Index j,
                              const Placed_triangle& t) {
    return planes.is_beside(t, i) || planes.is_beside(s, j);
  };
  // What its plane tells apart is a matter of half the time.
  const auto cost = [&](Index i, Index j) {
    return are_beside(i, triangle(i), j, triangle(j)) ? 0.5 : 1.;
  };
  if(placed.crowding(box, largest_crowding_of_planes, cost) <= largest_crowding_of_planes)
    return placed.any_pair(
        box,
        [&](Index i, Index j) {
          const Placed_triangle s = triangle(i), t = triangle(j);
          return !are_beside(i, s, j, t) && are_in_contact(s, t);
        },
        execution);
  return contact_search(execution, faces.size(), triangle).any_candidate(execution, are_touching);
}

bool touches_itself(Execution execution, const Flat_mesh& mesh, const std::vector<Vector>& places) {
  std::vector<std::array<Index, 3>> faces;
  faces.reserve(mesh.number_of_faces());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const Ring ring = mesh.ring(v);
    for(Index p = 0; p < ring.size(); ++p) {
      const Index u = ring[p], w = ring[ring.next(p)];
      if(v < u && v < w)
        faces.push_back({v, u, w});
    }
  }
  return touches_itself(execution, places, faces);
}

} // namespace CGAL::Handle_tunnel_loops::internal
