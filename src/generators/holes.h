// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors
//
// Surfaces with boundary: closed ones with holes.

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_HOLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_HOLES_H

#include "generators/generators.h"

#include <cstddef>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// Discs to be taken out of a closed surface, no two with a common vertex.
struct Hole_request
{
  std::size_t number = 0;
  std::size_t faces = 20; ///< of each, about: at least those around a vertex
  bool is_ragged = false; ///< with about as many boundary edges as faces; else they are round
  unsigned seed = 0;
};

/// the mesh without these discs, and without the vertices that are left alone. There are fewer
/// discs, or smaller ones, where there is no room for more.
Soup with_holes(const Soup& mesh, const Hole_request& holes);

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_HOLES_H
