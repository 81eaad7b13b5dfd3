// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_WHOLE_MESH_DOMAIN_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_WHOLE_MESH_DOMAIN_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/kernels/Located_cell.h>
#include <CGAL/Handle_tunnel_loops/internal/kernels/Wall_arrays.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// Where one field runs over all of the mesh: its cells are the vertices. `Paged_domain` provides
/// the same for many passes at once.
class Whole_mesh_domain
{
public:
  explicit Whole_mesh_domain(const Mesh_view& mesh)
      : mesh_(mesh) {}

  /// all loops are walls.
  Whole_mesh_domain(const Mesh_view& mesh, const Wall_arrays<Loops_from>& walls)
      : mesh_(mesh)
      , walls_(walls) {}

  CGAL_HTL_HOST_DEVICE const Mesh_view& mesh() const { return mesh_; }
  CGAL_HTL_HOST_DEVICE bool has_walls() const { return !walls_.begins.empty(); }

  /// of a cell, all that a list of the band keeps.
  using Banded_cell = Index;
  static constexpr bool has_sides = false;

  CGAL_HTL_HOST_DEVICE static Banded_cell banded(const Located_cell& c) { return c.cell; }
  CGAL_HTL_HOST_DEVICE static Located_cell located(Banded_cell cell) { return {cell, cell, 0}; }
  CGAL_HTL_HOST_DEVICE static Index find(const Located_cell&, Index u) { return u; }
  CGAL_HTL_HOST_DEVICE static void
  insert(Index (&)[stencil_width], const Index (&)[stencil_width], Index) {}

  CGAL_HTL_HOST_DEVICE static bool is_starved(Index) { return false; }

  CGAL_HTL_HOST_DEVICE bool may_have_walls(Index v, bool is_source) const {
    return has_walls() && walls_.may_be_beside(v, is_source);
  }
  CGAL_HTL_HOST_DEVICE std::uint32_t walls_among(const Index (&neighbors)[stencil_width],
                                                 const Located_cell& c) const {
    return walls_.walls_among(neighbors, 0, c.vertex);
  }

private:
  Mesh_view mesh_;
  Wall_arrays<Loops_from> walls_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_KERNELS_WHOLE_MESH_DOMAIN_H
