// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/skeleton/find_skeleton.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Skeleton_builder.h>

#include <functional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

Found_skeleton find_skeleton(Execution execution,
                             const Flat_mesh& mesh,
                             const Own_frame& frame,
                             const std::vector<Vector>& places,
                             const std::vector<Flat_pair>& pairs,
                             const Skeleton_options& options,
                             const Face_number& face_number,
                             const std::function<void()>& look) {
  return Skeleton_builder(execution, mesh, frame, places, pairs, options, face_number, look)
      .build();
}

} // namespace CGAL::Handle_tunnel_loops::internal
