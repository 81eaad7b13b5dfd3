// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REMOVAL_SOLVER_H
#define HTLOOPS_REMOVAL_SOLVER_H

#include "mesh_types.h"
#include "solve/changeable_mesh.h"
#include "solve/progress.h"

#include <CGAL/Handle_tunnel_loops/Removal_report.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace htloops {

using CGAL::Handle_tunnel_loops::Refused_handle;
using CGAL::Handle_tunnel_loops::Removal_method;
using CGAL::Handle_tunnel_loops::Removal_report;
using CGAL::Handle_tunnel_loops::Removal_way;
using CGAL::Handle_tunnel_loops::Removed_handle;
using CGAL::Handle_tunnel_loops::Shape_change;

/// Which handles are to be removed, and how. What is not given selects all handles.
struct Removal_options : CGAL::Handle_tunnel_loops::Removal_options
{
  std::optional<std::vector<std::size_t>> pairs; ///< by number
  int number_of_threads = 0;                     ///< 0: as many as the machine has
};

struct Removal_answer : Changed_mesh
{
  static constexpr std::size_t no_patch = static_cast<std::size_t>(-1);

  Removal_report report;
  std::vector<std::size_t> patches; ///< by face, the `Removed_handle::patch` of which it is a cap
  int number_of_threads = 1;
};

/// removes handles, given the pairs of loops of a mesh. Throws `Failure` if there is nothing that
/// the options could mean.
Removal_answer remove_handles(const Mesh& mesh,
                              const Pairs& pairs,
                              const Removal_options& options,
                              Progress& progress);

/// turns properties of the vertices before into some of those afterwards: each new one gets the
/// mean of its neighbours that have a value, in turn from those beside the known ones.
void spread_properties(const Changed_mesh& changed, Vertex_properties& properties);

} // namespace htloops

#endif // HTLOOPS_REMOVAL_SOLVER_H
