// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

struct Fill_rows
{
  Mesh_view mesh;
  Span<Neighbor_row> rows;

  CGAL_HTL_HOST_DEVICE void operator()(Index v) const {
    const Ring ring = mesh.ring(v);
    Neighbor_row row;
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      row.at[i] = i < ring.size() ? ring[i] : no_index;
    rows[v] = row;
  }
};

/// A mesh in the memory of an executor.
template <typename Executor> class Device_mesh
{
  template <typename T> using Buffer = typename Executor::template Buffer<T>;

public:
  /// The rows are filled when the last copy has been waited for.
  Device_mesh(Executor& executor, const Mesh_view& host)
      : row_begin_(copy(executor, host.row_begin))
      , neighbor_(copy(executor, host.neighbor))
      , rows_(filled_rows(executor))
      , points_(copy(executor, host.points)) {}

  std::size_t number_of_vertices() const { return row_begin_.span().size() - 1; }

  Mesh_view view() const {
    return {points_.span(), row_begin_.span(), neighbor_.span(), rows_.span()};
  }

  static std::size_t bytes(const Mesh_view& host) {
    return host.points.size() * sizeof(double) +
           (host.row_begin.size() + host.neighbor.size()) * sizeof(Index) +
           host.number_of_vertices() * sizeof(Neighbor_row);
  }

private:
  template <typename T> static Buffer<T> copy(Executor& executor, const Span<const T>& values) {
    return uploaded(executor, values.data(), values.size());
  }

  Buffer<Neighbor_row> filled_rows(Executor& executor) const {
    auto rows = executor.template make<Neighbor_row>(number_of_vertices());
    const Mesh_view rings = {{}, row_begin_.span(), neighbor_.span(), {}};
    executor.for_each(number_of_vertices(), Fill_rows{rings, rows.span()});
    return rows;
  }

  Buffer<Index> row_begin_, neighbor_;
  Buffer<Neighbor_row> rows_;
  Buffer<double> points_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_MESH_H
