// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_SWEPT_VERTICES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_SWEPT_VERTICES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What a sweep tells of each vertex; empty where nobody asks.
struct Swept_vertices
{
  std::vector<Index> layers; ///< from 1, see `Front_log`
  std::vector<double> times; ///< in steps of the field
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_SWEPT_VERTICES_H
