// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SMOOTHING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SMOOTHING_H

#include "Field.h"
#include "generators.h"

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// moves each vertex half of the way to the mean of its neighbours, `rounds` times.
void relax(Soup& soup, int rounds);

/// moves each vertex along the normal of the mesh towards the surface of a solid: by the value of
/// the field, so never beyond the surface, and by no more than `limit`.
void approach_surface(Soup& soup, const Field& field, double limit);

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SMOOTHING_H
