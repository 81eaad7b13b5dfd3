// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_ISOSURFACE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_ISOSURFACE_H

#include "Field.h"
#include "generators.h"

namespace CGAL::Handle_tunnel_loops::generators {

/*!
The surface of a solid by marching tetrahedra on the body-centred cubic lattice whose cubes have
side `spacing`, with its vertices in the middle of the lattice's edges. Whatever the field, the
surface is closed, manifold, oriented outwards and a simplicial complex: it is the boundary of the
piecewise linear solid that the signs at the lattice's points give.

`expected_faces` only saves memory.
*/
Soup isosurface(const Field& field, double spacing, std::size_t expected_faces = 0);

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_ISOSURFACE_H
