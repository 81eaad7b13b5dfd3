// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_COMPARE_LENGTHS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_COMPARE_LENGTHS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_lengths.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/enum.h>

#include <utility>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Compares the exact lengths of two loops on `tm`. The length of a loop is that of the closed polyline
through the points `source(halfedge) + ratio * (target(halfedge) - source(halfedge))` of its steps,
with ratios and coordinates taken as doubles (coordinates of an exact kernel are rounded). The
function does not use `Loop_on_surface::points()` and `Loop_on_surface::length()`, which are
rounded.

The lengths are sums of square roots of rational numbers. The function first computes them with
interval arithmetic in linear time. If the intervals overlap, it computes the sign of the difference
with as many digits as necessary. Segments of equal length in both loops cancel in
\f$ O(n \log n) \f$ time. If the sums are still equal, the function decides this by comparing the
remaining segments with each other in quadratic time.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point the point type of the loops
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param a the first loop
\param b the second loop
\param tm the mesh
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `CGAL::SMALLER` if `a` is shorter than `b`, `CGAL::EQUAL` if both have the same length, and
  `CGAL::LARGER` if `a` is longer

\pre The coordinates of `tm` are finite.

\sa `CGAL::length_interval()`
*/
template <typename TriangleMesh,
          typename Point,
          typename NamedParameters = parameters::Default_named_parameters>
Comparison_result compare_lengths(const Loop_on_surface<TriangleMesh, Point>& a,
                                  const Loop_on_surface<TriangleMesh, Point>& b,
                                  const TriangleMesh& tm,
                                  const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  return impl::compare_lengths(impl::edge_places(tm, a, np), impl::edge_places(tm, b, np));
}

/*!
\ingroup PkgHandleTunnelLoopsRef

Computes an interval that contains the exact length of a loop on `tm`. The length of a loop is that
of the closed polyline through the points
`source(halfedge) + ratio * (target(halfedge) - source(halfedge))` of its steps, with ratios and
coordinates taken as doubles (coordinates of an exact kernel are rounded). The width of the interval
is due to rounding: for each step, it is some \f$ 10^{-16} \f$ times the coordinates and the length.
The complexity is linear.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point the point type of the loop
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param loop the loop
\param tm the mesh
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the lower and the upper end of the interval; the upper end is infinite if a square exceeds
  the range of `double`

\pre The coordinates of `tm` are finite.

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

#endif // CGAL_HANDLE_TUNNEL_LOOPS_COMPARE_LENGTHS_H
