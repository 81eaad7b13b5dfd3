// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORES_AROUND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORES_AROUND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Bore_section.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// for each loop, given by its places: the narrowest cylinder in the wall of the bore that it goes
/// around, if there is one, as long as its drilling. Those of one drilling are the same.
std::vector<std::optional<Cylinder>>
bores_around(Execution execution,
             const Surgery_mesh& mesh,
             const std::vector<std::vector<Place_on_edge>>& loops);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORES_AROUND_H
