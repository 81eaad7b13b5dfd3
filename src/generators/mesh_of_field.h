// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_MESH_OF_FIELD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_MESH_OF_FIELD_H

#include "Field.h"

#include <cstddef>
#include <limits>

namespace CGAL::Handle_tunnel_loops::generators {

/// meshes a solid whose surface is connected and has the requested genus, with about the requested
/// number of faces and even triangles. Throws `std::invalid_argument` if the faces are too few to
/// resolve all handles.
Soup mesh_of_field(const Field& field, const Request& request, const char* kind);

/// meshes a solid with about the given number of faces, of any genus. The mesh is smoothed only as
/// far as it does not cross itself.
Soup mesh_of_field(const Field& field, std::size_t faces);

/// The mesh on the lattice: it approximates the surface of the solid, but is rough.
struct Lattice_mesh
{
  Soup soup;
  double spacing; ///< of the lattice
};

/// the first step of `mesh_of_field()`. Throws `std::invalid_argument` if the solid is empty, or
/// too thin for so many faces; at once if a lattice with the largest spacing, `most_spacing`, has
/// too many points.
Lattice_mesh lattice_mesh(const Field& field,
                          std::size_t faces,
                          double most_spacing = (std::numeric_limits<double>::infinity)());

/// the second step: the mesh moved onto the surface of the solid.
Soup fitted(const Lattice_mesh& mesh, const Field& field);

/// moves each vertex halfway to the mean of its neighbors, `rounds` times.
void relax(Soup& soup, int rounds);

/*!
The surface of a solid by marching tetrahedra on the body-centred cubic lattice whose cubes have
side `spacing`, with its vertices in the middle of the lattice's edges. Whatever the field, the
surface is closed, manifold, oriented outwards and a simplicial complex: it is the boundary of the
piecewise linear solid that the signs at the lattice's points give.

`expected_faces` only saves memory.
*/
Soup isosurface(const Field& field, double spacing, std::size_t expected_faces = 0);

/// whether triangles of a closed surface meet that are not neighbors. About as slow as making a
/// mesh.
bool crosses_itself(const Soup& soup);

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_MESH_OF_FIELD_H
