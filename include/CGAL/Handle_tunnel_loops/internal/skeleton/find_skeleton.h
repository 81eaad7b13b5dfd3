// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_FIND_SKELETON_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_FIND_SKELETON_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Curve_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/certify_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <functional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

class Own_frame;

/// A skeleton, to which of its points each vertex of the mesh belongs, and what is proved of it.
struct Found_skeleton
{
  Flat_skeleton skeleton;
  std::vector<Index> point_of_vertex; ///< hubs included
  std::size_t number_of_balls = 0;
  Skeleton_certificate certificate;
};

/// finds a skeleton. The mesh lies in a frame; \p places are the coordinates of the vertices as the
/// caller has them, hubs included, \p pairs a basis of loops. Between steps, \p look may throw.
Found_skeleton find_skeleton(Execution execution,
                             const Flat_mesh& mesh,
                             const Own_frame& frame,
                             const std::vector<Vector>& places,
                             const std::vector<Flat_pair>& pairs,
                             const Skeleton_options& options,
                             const Face_number& face_number,
                             const std::function<void()>& look);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_FIND_SKELETON_H
