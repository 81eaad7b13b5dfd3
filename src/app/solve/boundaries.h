// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors
//
// The boundary curves of a surface, and its components.

#ifndef HTLOOPS_BOUNDARIES_H
#define HTLOOPS_BOUNDARIES_H

#include "mesh_types.h"

#include <cstddef>
#include <vector>

namespace htloops {

/// The boundary curves, and for each that is not the only one of its component a short loop of its
/// class, if that is wanted.
struct Boundaries
{
  std::vector<Loop> curves, waists;

  /// of the curve of a number; null if there is none.
  const Loop* waist(std::size_t curve) const;
};

Boundaries find_boundaries(const Mesh& mesh, bool do_find_waists);

/// by vertex, the number of its component, of so many: in the order of their smallest vertices.
std::vector<std::size_t> components_of_vertices(const Mesh& mesh, std::size_t number);

/// by pair, the number of the component that it is on, counted in the same way.
std::vector<std::size_t> components_of_pairs(const Mesh& mesh, const Pairs& pairs);

} // namespace htloops

#endif // HTLOOPS_BOUNDARIES_H
