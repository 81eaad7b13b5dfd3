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

  CGAL_HTL_HOST_DEVICE Index vertex(Index cell) const { return cell; }
  CGAL_HTL_HOST_DEVICE Index pass(Index) const { return 0; }
  CGAL_HTL_HOST_DEVICE Index find(Index, Index u) const { return u; }
  CGAL_HTL_HOST_DEVICE Index insert(Index, Index u) const { return u; }

  CGAL_HTL_HOST_DEVICE static bool is_starved(Index) { return false; }

  CGAL_HTL_HOST_DEVICE bool may_have_walls(Index cell) const {
    return has_walls() && walls_.may_be_beside(0, cell);
  }
  CGAL_HTL_HOST_DEVICE bool is_wall(Index cell, Index u) const {
    return walls_.is_wall(0, cell, u);
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
