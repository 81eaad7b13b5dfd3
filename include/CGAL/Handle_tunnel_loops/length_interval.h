// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_LENGTH_INTERVAL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_LENGTH_INTERVAL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_lengths.h>

#include <CGAL/Named_function_parameters.h>

#include <utility>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

computes an interval that holds the length of a loop on `tm`: that of the closed polyline through
the places `source(halfedge) + ratio * (target(halfedge) - source(halfedge))` of its steps, with
ratios and coordinates taken as doubles (those of an exact kernel are rounded). It is as wide as
rounding makes it: for each step some \f$ 10^{-16} \f$ of its coordinates and of the length. The
complexity is linear.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point the point type of the loop
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param loop the loop
\param tm the mesh
\param np named parameters

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the ends of the interval, the smaller one first; the larger one is infinite where a square
  is beyond the range of `double`

\pre the coordinates of `tm` are finite.

\sa `CGAL::compare_lengths()`
*/
template <typename TriangleMesh,
          typename Point,
          typename NamedParameters = parameters::Default_named_parameters>
std::pair<double, double>
length_interval(const Loop_on_surface<TriangleMesh, Point>& loop,
                const TriangleMesh& tm,
                const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  return impl::length_interval(impl::edge_places(tm, loop, np));
}

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_LENGTH_INTERVAL_H
