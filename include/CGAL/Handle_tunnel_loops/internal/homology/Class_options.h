// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_OPTIONS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_OPTIONS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Basis_kind.h>

#include <limits>

namespace CGAL::Handle_tunnel_loops::internal {

/// What `find_right_classes()` is to do.
struct Class_options
{
  Basis_kind kind = Basis_kind::PURE;
  bool do_link = true; ///< without, nothing is known of sides
  bool do_shorten = true;
  double search_effort = 1.; ///< by how much more to search than by default
  double maximum_running_time = (std::numeric_limits<double>::infinity)(); ///< seconds
  double offset = 0.; ///< by which loops are moved that linking numbers do not name
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_OPTIONS_H
