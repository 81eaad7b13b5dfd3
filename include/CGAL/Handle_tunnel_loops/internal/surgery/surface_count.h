// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURFACE_COUNT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURFACE_COUNT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Concurrent_disjoint_sets.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// What a closed surface is, by counting.
struct Surface_count
{
  std::size_t components = 0;
  std::size_t genus = 0; ///< summed over the components
};

/// the pieces that the faces for which `stays(f)` form, as sets of faces. Linear in the size of the
/// mesh.
template <typename Predicate>
Concurrent_disjoint_sets
pieces(Execution execution, const Surgery_mesh& mesh, const Predicate& stays) {
  Concurrent_disjoint_sets sets(execution, mesh.face_bound());
  for_each_index(execution, mesh.face_bound(), [&](std::size_t f) {
    if(stays(static_cast<Index>(f)))
      sets.insert(static_cast<Index>(f));
  });
  for_each_index(execution, 3 * std::size_t(mesh.face_bound()), [&](std::size_t i) {
    const Index h = static_cast<Index>(i);
    if(stays(mesh.face(h)) && h < mesh.twin(h) && stays(mesh.face(mesh.twin(h))))
      sets.unite(mesh.face(h), mesh.face(mesh.twin(h)));
  });
  return sets;
}

/// the number of pieces of the surface. Linear in its size.
inline std::size_t number_of_pieces(Execution execution, const Surgery_mesh& mesh) {
  return pieces(execution, mesh, [&](Index f) { return mesh.is_alive(f); })
      .flatten(execution)
      .size();
}

/// whether a halfedge has a twin that leads back.
inline bool is_matched(const Surgery_mesh& mesh, Index h) {
  const Index twin = mesh.twin(h);
  return twin != no_index && mesh.is_alive(mesh.face(twin)) && mesh.twin(twin) == h &&
         mesh.source(twin) == mesh.target(h) && mesh.target(twin) == mesh.source(h);
}

/// whether each halfedge has a twin that leads back, and the faces at each vertex are one fan that
/// comes to no neighbour twice.
inline bool is_closed_manifold(Execution execution, const Surgery_mesh& mesh) {
  std::atomic<bool> is_good(true);
  for_each_index(execution, 3 * std::size_t(mesh.face_bound()), [&](std::size_t i) {
    const Index h = static_cast<Index>(i);
    if(mesh.is_alive(mesh.face(h)) && !is_matched(mesh, h))
      is_good = false;
  });
  if(!is_good)
    return false; // not all fans end
  std::atomic<std::size_t> number_in_fans(0);
  execution.for_ranges(mesh.vertex_bound(), 16384, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> neighbors;
    std::size_t number = 0;
    for(Index v = static_cast<Index>(begin); v < end; ++v) {
      neighbors.clear();
      mesh.for_each_outgoing(v, [&](Index h) { neighbors.push_back(mesh.target(h)); });
      number += neighbors.size();
      std::sort(neighbors.begin(), neighbors.end());
      if(std::adjacent_find(neighbors.begin(), neighbors.end()) != neighbors.end())
        is_good = false;
    }
    number_in_fans += number;
  });
  return is_good && number_in_fans == 3 * mesh.number_of_faces();
}

/// throws `std::logic_error` if the mesh is no closed manifold, which nothing that is done to it
/// may make of it. Linear in the size of the mesh.
inline Surface_count count_surface(Execution execution, const Surgery_mesh& mesh) {
  if(!is_closed_manifold(execution, mesh))
    throw std::logic_error("the surface is no closed manifold after the removal of handles");
  Surface_count count;
  count.components = number_of_pieces(execution, mesh);
  std::size_t vertices = 0;
  for(Index v = 0; v < mesh.vertex_bound(); ++v)
    vertices += mesh.outgoing(v) != no_index;
  // V - E + F = 2 c - 2 g, with 2 E = 3 F.
  count.genus = (2 * count.components + mesh.number_of_faces() / 2 - vertices) / 2;
  return count;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURFACE_COUNT_H
