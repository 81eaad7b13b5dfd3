// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LOOPS_BINDING_H
#define HTLOOPS_LOOPS_BINDING_H

#include "mesh_types.h"
#include "read/loops_json_reader.h"

#include <string>
#include <vector>

namespace htloops {

/// Loops from a file as loops on a mesh, as far as they are ones.
struct Bound_loops
{
  CGAL::Handle_tunnel_loops::Basis_kind basis_kind; ///< what they are meant to be
  Pairs pairs;                                      ///< complete only if there is no problem
  bool has_boundaries = false;                      ///< whether the file tells of them
  std::vector<Loop> curves, waists;                 ///< of the boundary
  std::vector<std::string> problems;                ///< in words, naming pair, kind and position
};

/// finds the places that a file names on the mesh. A problem is an index or a ratio out of range,
/// two vertices without an edge, a point that is not where its location is, a wrong length.
Bound_loops bind_loops(const Loops_record& record, const Mesh& mesh);

} // namespace htloops

#endif // HTLOOPS_LOOPS_BINDING_H
