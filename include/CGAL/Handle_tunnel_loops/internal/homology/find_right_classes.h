// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_FIND_RIGHT_CLASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_FIND_RIGHT_CLASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Basis_kind.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// computes the relations of the loops of pairs, handles and tunnels in turn; from those before
/// some were replaced, which it takes, if they are known.
using Relate_pairs =
    std::function<Loop_relations(const std::vector<Flat_pair>&, const Known_relations*)>;

/// What `find_right_classes()` is to do.
struct Class_options
{
  Basis_kind kind = Basis_kind::PURE;
  bool do_link = true; ///< without, nothing is known of sides
  bool do_shorten = true;
  double search_effort = 1.; ///< by how much more to search than by default
  double maximum_running_time = (std::numeric_limits<double>::infinity)(); ///< seconds
  double offset = 0.; ///< by which loops are moved that linking numbers do not name
};

/// changes pairs, which are a basis, to pairs of the kind that is wanted: makes them pure where
/// their linking numbers allow, and as short as it can. Returns the relations of the pairs, if it
/// has come to know them. Long loops are searched for on the coarse mesh, if there is one. It looks
/// for shorter loops while there is time.
CGAL_HTL_CORE std::optional<Loop_relations> find_right_classes(Execution execution,
                                                               const Flat_mesh& mesh,
                                                               const Class_options& options,
                                                               const Relate_pairs& relate,
                                                               std::vector<Flat_pair>& pairs,
                                                               Progress& progress,
                                                               const Coarse_mesh* coarse = nullptr);

} // namespace CGAL::Handle_tunnel_loops::internal

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/homology/find_right_classes_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_FIND_RIGHT_CLASSES_H
