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

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Class_options.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <functional>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// computes the relations of the loops of pairs, handles and tunnels in turn; from those before
/// some were replaced, which it takes, if they are known.
using Relate_pairs =
    std::function<Loop_relations(const std::vector<Flat_pair>&, const Known_relations*)>;

/// changes pairs, which are a basis, to pairs of the kind that is wanted: makes them pure where
/// their linking numbers allow, and as short as it can. Returns the relations of the pairs, if it
/// has come to know them. Long loops are searched for on the coarse mesh, if there is one. It looks
/// for shorter loops while there is time.
std::optional<Loop_relations> find_right_classes(Execution execution,
                                                 const Flat_mesh& mesh,
                                                 const Class_options& options,
                                                 const Relate_pairs& relate,
                                                 std::vector<Flat_pair>& pairs,
                                                 Progress& progress,
                                                 const Coarse_mesh* coarse = nullptr);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_FIND_RIGHT_CLASSES_H
