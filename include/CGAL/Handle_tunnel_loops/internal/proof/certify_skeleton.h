// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_CERTIFY_SKELETON_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_CERTIFY_SKELETON_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Skeleton_certificate.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the caller's number of a face of the surface, by its corners in the arrays, counterclockwise.
using Face_number = std::function<std::size_t(Index, Index, Index)>;

/// what a point of a skeleton is called.
using Point_name = std::function<std::string(Index)>;

/// places the hubs of the caps, of which only the vertices before them have places yet
/// (`Hub_places`).
void place_hubs(Execution execution, const Flat_mesh& mesh, std::vector<Vector>& places);

/// lets the components that bound the same piece of the solid be one, that of its outer surface
/// (`Solid_pieces`). Returns which components are taken alone, and why, in lines of text.
std::string
join_components_of_solids(Execution execution, Flat_mesh& mesh, const std::vector<Vector>& places);

/// proves what there is to prove of a skeleton. \p places are the coordinates of the vertices as
/// the caller has them, hubs included (`place_hubs()`), and the components of \p mesh are pieces of
/// the solid (`join_components_of_solids()`). \p loops are closed walks on the edges, by
/// their vertices: for each component as many as its genus, which are independent in the space
/// outside, as handle loops are; more do no harm, nor do other loops, but that less can be proved.
/// That the surface does not cross or touch itself is not looked at. Points are called by their
/// numbers, or by \p point_name if that is something. \p do_caps_meet is told whether the caps meet
/// anything, so that there is no inside whatever the skeleton.
Skeleton_certificate certify_skeleton(Execution execution,
                                      const Flat_mesh& mesh,
                                      const std::vector<Vector>& places,
                                      const Flat_skeleton& skeleton,
                                      const std::vector<std::vector<Index>>& loops,
                                      const Face_number& face_number,
                                      const Point_name& point_name = {},
                                      bool* do_caps_meet = nullptr);

/// finds out which points of a skeleton are inlets and what component each part belongs to, if
/// these arrays are empty.
void find_places(Execution execution,
                 const Flat_mesh& mesh,
                 const std::vector<Vector>& places,
                 Flat_skeleton& skeleton);

/// takes back what means nothing on a surface that crosses or touches itself, or does so \p
/// with_caps that close its boundary curves.
void note_self_contact(Skeleton_certificate& certificate, bool with_caps = false);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_CERTIFY_SKELETON_H
