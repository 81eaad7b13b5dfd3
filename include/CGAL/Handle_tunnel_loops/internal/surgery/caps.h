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
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Divided_strip.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Polygon_in_space.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <functional>

namespace CGAL::Handle_tunnel_loops::internal {

/// Looks at a patch, and says whether it is the one that is wanted.
using Patch_visitor = std::function<bool(const Patch&)>;

/// Calls a function with what may take the place of a region, a cap on each of its holes, in
/// several ways, the one that fits best first, until that returns true. A hole in a plane is closed
/// in that plane. Other caps are refined to the density of the mesh around them and made smooth
/// with it (where Eigen is there); or refined only; or without vertices of their own. There are
/// none where the holes cannot be triangulated. Whether the caps meet anything has still to be
/// seen.
void for_each_cap(const Surgery_mesh& mesh,
                  const Cut_region& region,
                  const Patch_visitor& is_wanted);

/// The same for a strip: two membranes with the same triangles, one on either side of the curve,
/// which stand on the faces there, or on collars of several heights. They have no vertices but
/// those of the curve and the collar; where such are wanted, they are shown once more, refined.
void for_each_membrane(const Surgery_mesh& mesh,
                       const Curve_off_vertices& curve,
                       const Divided_strip& strip,
                       Polygon_in_space::At_sides side,
                       const Patch_visitor& is_wanted);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CAPS_H
