// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SELF_CONTACT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SELF_CONTACT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Face_planes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Placed_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangle_contact.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/near_pairs.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// whether two faces meet elsewhere than in a common vertex or edge, or a face has no area: then
/// the surface is not the boundary of a solid. Decided exactly, of faces whose boxes meet. Takes
/// about as long as reading the mesh, and a few times as long where the boxes of most of them meet,
/// as they are long, or large and in many layers. (`Polygon_mesh_processing::does_self_intersect()`
/// says the same, but does not let itself be interrupted, and copies the mesh.)
template <typename TriangleMesh, typename VertexPointMap, typename VertexIndexMap>
bool touches_itself(Execution execution,
                    const TriangleMesh& tm,
                    VertexPointMap point,
                    VertexIndexMap index) {
  const std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> all(
      faces(tm).begin(), faces(tm).end());
  const auto triangle = [&](std::size_t i) {
    Placed_triangle t;
    std::size_t corner = 0;
    for(const auto v : CGAL::vertices_around_face(halfedge(all[i], tm), tm)) {
      const auto& p = get(point, v);
      t.vertices[corner] = static_cast<Index>(get(index, v));
      t.points[corner++] = {p.x(), p.y(), p.z()};
    }
    return t;
  };
  std::atomic<bool> is_found(false);
  std::vector<Box<3>> boxes(all.size());
  for_each_index(execution, all.size(), [&](std::size_t i) {
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
  const Placed_boxes placed(execution, all.size(), box);
  constexpr double usual_crowding = 32., largest_crowding_of_planes = 256.;
  const auto one = [](Index, Index) { return 1.; };
  if(placed.crowding(box, usual_crowding, one) <= usual_crowding)
    return placed.any_pair(box, are_touching, execution);
  const Face_planes planes(execution, all.size(), triangle);
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
  return contact_search(execution, all.size(), triangle).any_candidate(execution, are_touching);
}

/// the same for a surface with the caps that close its boundary curves. \p places are those of its
/// vertices, hubs included.
inline bool
touches_itself(Execution execution, const Flat_mesh& mesh, const std::vector<Vector>& places) {
  std::vector<Flat_surface::Point> points;
  points.reserve(places.size());
  for(const Vector& p : places)
    points.emplace_back(p[0], p[1], p[2]);
  using Identity = boost::typed_identity_property_map<Index>;
  return touches_itself(execution, Flat_graph(mesh),
                        boost::make_iterator_property_map(points.begin(), Identity()),
                        boost::make_iterator_property_map(mesh.original.data(), Identity()));
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SELF_CONTACT_H
