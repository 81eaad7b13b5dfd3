// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_MESH_CHECKS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_MESH_CHECKS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <atomic>
#include <string>

namespace CGAL::Handle_tunnel_loops::internal {

/// Remembers the smallest index at which something was seen, whatever the order of the threads.
class First_index
{
public:
  void see(std::size_t i) {
    std::size_t current = first_.load(std::memory_order_relaxed);
    while(i < current && !first_.compare_exchange_weak(current, i, std::memory_order_relaxed))
      ;
  }
  bool found() const { return first_.load() != none; }
  std::size_t get() const { return first_.load(); }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::atomic<std::size_t> first_{none};
};

[[noreturn]] inline void
throw_vertex_defect(Mesh_defect defect, std::size_t v, const std::string& what) {
  throw Invalid_mesh_exception(defect, {v}, what + ": vertex " + std::to_string(v));
}

[[noreturn]] inline void
throw_edge_defect(Mesh_defect defect, std::size_t u, std::size_t v, const std::string& what) {
  throw Invalid_mesh_exception(defect, {u, v},
                               what + ": edge " + std::to_string(u) + " - " + std::to_string(v));
}

/// throws `Invalid_mesh_exception` where indices are not enough for halfedges, those of caps with
/// them.
inline void check_number_of_halfedges(std::size_t number) {
  if(number > most_halfedges)
    throw Invalid_mesh_exception(Mesh_defect::TOO_LARGE, {}, "the mesh has too many halfedges");
}

/// ... and for vertices, of which twice the number is an index as well.
inline void check_size(std::size_t number_of_triangles, std::size_t number_of_vertices) {
  if(number_of_vertices >= no_index / 2)
    throw Invalid_mesh_exception(Mesh_defect::TOO_LARGE, {}, "the mesh has too many vertices");
  check_number_of_halfedges(3 * number_of_triangles);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_MESH_CHECKS_H
