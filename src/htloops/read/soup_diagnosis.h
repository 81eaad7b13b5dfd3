// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SOUP_DIAGNOSIS_H
#define HTLOOPS_SOUP_DIAGNOSIS_H

#include "read/soup.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace htloops {

using CGAL::Handle_tunnel_loops::Mesh_defect;

/// What keeps a soup from being an oriented 2-manifold of triangles, with or without boundary.
struct Defect
{
  Mesh_defect kind;
  std::size_t count;   ///< how often it was found
  std::string message; ///< says it in words and names the first element that has it
};

/// The defects of a soup, and its edges if there is none.
struct Diagnosis
{
  std::vector<Defect> defects;
  std::vector<std::array<std::uint32_t, 2>> edges; ///< the two halfedges of each, or one

  static constexpr std::uint32_t no_halfedge = static_cast<std::uint32_t>(-1); ///< the other one
};

/// finds all defects, of every kind. Vertices that no face uses are none, nor is a face without
/// area.
Diagnosis diagnose(const Soup& soup);

} // namespace htloops

#endif // HTLOOPS_SOUP_DIAGNOSIS_H
