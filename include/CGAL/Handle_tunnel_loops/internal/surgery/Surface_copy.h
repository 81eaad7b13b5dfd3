// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURFACE_COPY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURFACE_COPY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Mesh_link.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/Surface_mesh.h>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A mesh under surgery as a `Surface_mesh`, for what finds loops on such a one.
class Surface_copy
{
public:
  using Mesh = Surface_mesh<Surgery_mesh::Point>;

  explicit Surface_copy(const Surgery_mesh& original) {
    Mesh_link<Mesh, std::decay_t<decltype(mesh_.points())>> link(mesh_, mesh_.points());
    link.write_back(
        original, [this](Index number, Mesh::Vertex_index) { numbers_.push_back(number); },
        [](Index, Mesh::Face_index) {});
  }

  const Mesh& mesh() const { return mesh_; }

  /// where a loop on the copy lies on the original.
  template <typename Loop> std::vector<Place_on_edge> places(const Loop& loop) const {
    std::vector<Place_on_edge> places;
    for(const auto& step : loop.steps())
      places.push_back({numbers_[source(step.halfedge, mesh_)],
                        numbers_[target(step.halfedge, mesh_)], step.ratio});
    return places;
  }

private:
  Mesh mesh_;
  std::vector<Index> numbers_; // by vertex
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURFACE_COPY_H
