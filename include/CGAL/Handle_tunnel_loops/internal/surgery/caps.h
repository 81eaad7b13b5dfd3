// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CAPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CAPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Among which triangulations of a hole the best one is looked for.
enum class Cap_search {
  ALL,     ///< takes the cube of the number of sides: for holes of few hundred
  DELAUNAY ///< those of faces of Delaunay tetrahedra. Of equally good ones it is not determined
           ///< which is found: it depends on where these are in memory
};

/// What may take the place of a region: a cap on each of its holes, in several ways, the one that
/// fits best first. Caps are refined to the density of the mesh around them and made smooth
/// with it (where Eigen is there); or refined only; or without vertices of their own. None where
/// the holes cannot be triangulated. Whether the caps meet anything has still to be seen.
CGAL_HTL_CORE std::vector<Patch>
caps_of(const Surgery_mesh& mesh, const Cut_region& region, Cap_search search = Cap_search::ALL);

} // namespace CGAL::Handle_tunnel_loops::internal

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/surgery/caps_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CAPS_H
