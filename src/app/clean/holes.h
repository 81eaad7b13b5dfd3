// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_HOLES_H
#define HTLOOPS_HOLES_H

#include "clean/crossings.h"
#include "solve/changeable_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace htloops {

/// A boundary curve that stays.
struct Open_hole
{
  Changeable_mesh::Vertex_index vertex; ///< one of it
  std::string why;                      ///< in words, with the place
};

/// What became of the boundary curves of a mesh.
struct Closed_holes
{
  std::size_t number_of_curves = 0, closed = 0;
  double longest = 0.;              ///< of those that are closed
  std::vector<Open_hole> open = {}; ///< those that are not
  Crossings crossings = {};         ///< of the mesh as it is then
};

/*!
Closes boundary curves by triangles between their vertices, of least area; those that lie in a plane
exactly there. Where such a cap would cross the surface or another cap, a smooth one with vertices
of its own is tried; where that does, too, the curve stays as it is: the mesh has the crossings that
it had before, and no other ones. Near linear in the size of the mesh; for each curve, quadratic in
the number of its edges, or cubic, up to 300, where the first way fails.
*/
Closed_holes close_holes(Changeable_mesh& mesh);

} // namespace htloops

#endif // HTLOOPS_HOLES_H
