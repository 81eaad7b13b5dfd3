// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_MEASURE_HANDLES_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_MEASURE_HANDLES_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Handle_measurer.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/measure_handles.h>

namespace CGAL::Handle_tunnel_loops::internal {

CGAL_HTL_CORE Flat_measures measure_handles(Execution execution,
                                            const Flat_mesh& mesh,
                                            const std::vector<Vector>& places,
                                            const std::vector<Polyline_pair>& pairs,
                                            double precision) {
  return Handle_measurer(execution, mesh, places, pairs, precision).measure();
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_MEASURE_HANDLES_IMPL_H
