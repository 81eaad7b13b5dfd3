// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_THROAT_SOLVER_H
#define HTLOOPS_THROAT_SOLVER_H

#include "mesh_types.h"

#include <CGAL/Handle_tunnel_loops/Certificate_record.h>
#include <CGAL/Handle_tunnel_loops/Throat.h>

#include <vector>

namespace htloops {

using Throat = CGAL::Handle_tunnel_loops::Throat<Mesh>;

/// The throats of a mesh, if they were asked for.
struct Throats
{
  bool are_wanted = false;
  bool are_sides_known = false; ///< whether each loop of the pairs bounds on its side
  std::vector<Throat> all;
  std::vector<Mesh::Vertex_index> in_vain; ///< vertices with no loop through them
  double seconds = 0.;
};

/// finds throats, and those from loops through vertices.
Throats find_throats(const Mesh& mesh,
                     const Pairs& pairs,
                     const CGAL::Handle_tunnel_loops::Certificate& certificate,
                     const std::vector<Mesh::Vertex_index>& through,
                     double least_prominence = 0.25);

/// what is known by their classes of throats that were found elsewhere, which are closed curves on
/// the surface: all but how prominent they are.
Throats classified_throats(const Mesh& mesh,
                           const Pairs& pairs,
                           const CGAL::Handle_tunnel_loops::Certificate& certificate,
                           const std::vector<Loop>& loops);

} // namespace htloops

#endif // HTLOOPS_THROAT_SOLVER_H
