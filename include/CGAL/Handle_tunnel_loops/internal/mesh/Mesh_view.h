// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_MESH_VIEW_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_MESH_VIEW_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <cstddef>

namespace CGAL::Handle_tunnel_loops::internal {

/// The first neighbours of a vertex, for a thread to load in two pieces; `no_index` beyond the
/// last.
struct alignas(32) Neighbor_row
{
  Index at[stencil_width];
};

/// The arrays of a `Flat_mesh`, in the memory of the host or of the device.
struct Mesh_view
{
  Span<const double> points; ///< x, y, z of one vertex after the other
  Span<const Index> row_begin;
  Span<const Index> neighbor;
  Span<const Neighbor_row> rows; ///< by vertex; only in the memory of an executor

  CGAL_HTL_HOST_DEVICE Index number_of_vertices() const {
    return static_cast<Index>(row_begin.size() - 1);
  }

  CGAL_HTL_HOST_DEVICE Ring ring(Index v) const {
    return Ring(neighbor.data() + row_begin[v], row_begin[v + 1] - row_begin[v]);
  }

  /// as `Flat_mesh::edge_length()`, to the last bit.
  CGAL_HTL_HOST_DEVICE double edge_length(Index u, Index v) const {
    const double* p = points.data() + 3 * std::size_t(u);
    const double* q = points.data() + 3 * std::size_t(v);
    return rounded_length(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  }
};

/// the arrays of a mesh on the host.
inline Mesh_view view_of(const Flat_mesh& mesh) {
  const double* coordinates = mesh.points.empty() ? nullptr : mesh.points.front().data();
  return {{coordinates, 3 * mesh.points.size()},
          {mesh.row_begin.data(), mesh.row_begin.size()},
          {mesh.neighbor.data(), mesh.neighbor.size()},
          {}};
}

/// calls `f(length)` for some of the edges, spread over the mesh.
template <typename Function>
void for_each_sampled_edge_length(const Flat_mesh& mesh, const Function& f) {
  const std::size_t n = mesh.first_hub, stride = n / 10000 + 1;
  for(std::size_t v = 0; v < n; v += stride)
    f(mesh.edge_length(static_cast<Index>(v), mesh.ring(static_cast<Index>(v))[0]));
}

/// the mean length of some of the edges.
inline double mean_edge_length(const Flat_mesh& mesh) {
  double sum = 0.;
  std::size_t count = 0;
  for_each_sampled_edge_length(mesh, [&](double length) {
    sum += length;
    ++count;
  });
  return sum / double(count);
}

/// the mean square of the lengths of some of the edges, over the square of their mean: one if all
/// are as long.
inline double unevenness(const Flat_mesh& mesh) {
  const double mean = mean_edge_length(mesh);
  double sum = 0.;
  std::size_t count = 0;
  for_each_sampled_edge_length(mesh, [&](double length) {
    sum += length * length;
    ++count;
  });
  return mean > 0. ? sum / (double(count) * mean * mean) : 1.;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_MESH_VIEW_H
