// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_WHOLE_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_WHOLE_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Located_cell.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Walls.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// Where one field runs over all of the mesh: its cells are the vertices. `Paged_region` provides
/// the same for many passes at once.
class Whole_mesh
{
public:
  explicit Whole_mesh(const Mesh_view& mesh)
      : mesh_(mesh) {}

  /// all loops are walls.
  Whole_mesh(const Mesh_view& mesh, const Walls<Loops_from>& walls)
      : mesh_(mesh)
      , walls_(walls) {}

  CGAL_HTL_HOST_DEVICE const Mesh_view& mesh() const { return mesh_; }
  CGAL_HTL_HOST_DEVICE bool has_walls() const { return !walls_.begins.empty(); }

  CGAL_HTL_HOST_DEVICE static Located_cell located(Index cell) { return {cell, cell, 0}; }
  CGAL_HTL_HOST_DEVICE static Index find(const Located_cell&, Index u) { return u; }
  CGAL_HTL_HOST_DEVICE static Index insert(const Located_cell&, Index u) { return u; }

  CGAL_HTL_HOST_DEVICE static bool is_starved(Index) { return false; }

  CGAL_HTL_HOST_DEVICE bool may_have_walls(const Located_cell& c) const {
    return has_walls() && walls_.may_be_beside(0, c.vertex);
  }
  CGAL_HTL_HOST_DEVICE bool is_wall(const Located_cell& c, Index u) const {
    return walls_.is_wall(0, c.vertex, u);
  }

private:
  Mesh_view mesh_;
  Walls<Loops_from> walls_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_WHOLE_MESH_H
