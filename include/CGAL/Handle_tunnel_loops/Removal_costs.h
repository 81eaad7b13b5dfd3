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

The costs of removing one handle by a cut and by a fill: the areas and volumes that would change.
*/
struct Removal_costs
{
  std::optional<Removed_handle> cut;   ///< along the handle loop; empty if no cut is possible
  std::optional<Removed_handle> fill;  ///< along the tunnel loop; empty if no fill is possible
  std::string why_no_cut, why_no_fill; ///< the reason, as text; empty if it is possible
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_REMOVAL_COSTS_H
