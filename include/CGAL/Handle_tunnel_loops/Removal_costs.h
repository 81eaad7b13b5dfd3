// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_REMOVAL_COSTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_REMOVAL_COSTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Removal_report.h>

#include <optional>
#include <string>

namespace CGAL::Handle_tunnel_loops {

/*!
\ingroup PkgHandleTunnelLoopsRef

What it would take to remove a handle either way: the areas and volumes that would change.
*/
struct Removal_costs
{
  std::optional<Removed_handle> cut;   ///< along the handle loop; nothing if that cannot be
  std::optional<Removed_handle> fill;  ///< along the tunnel loop; nothing if that cannot be
  std::string why_no_cut, why_no_fill; ///< in words; empty if it can be
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_REMOVAL_COSTS_H
