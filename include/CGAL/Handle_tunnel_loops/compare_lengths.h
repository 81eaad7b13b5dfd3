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

compares the lengths of two loops on `tm`, exactly: as the closed polylines through the places
`source(halfedge) + ratio * (target(halfedge) - source(halfedge))` of their steps, with ratios and
coordinates taken as doubles (those of an exact kernel are rounded). Neither
`Loop_on_surface::points()` nor `Loop_on_surface::length()` plays a part in it: these are rounded.

The lengths are sums of square roots of rational numbers. They are computed with intervals first, in
linear time; where these overlap, the sign of their difference is computed with as many digits as it
needs. Segments of the same length in both loops cancel in time n log n. If the sums are equal
nevertheless, that is found by comparing the remaining segments with each other, in quadratic time.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point the point type of the loops
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param a the first loop
\param b the second loop
\param tm the mesh
\param np named parameters

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `CGAL::SMALLER` if `a` is shorter than `b`, `CGAL::EQUAL` if they are equally long,
  `CGAL::LARGER` if `a` is longer

\pre the coordinates of `tm` are finite.

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

#endif // CGAL_HANDLE_TUNNEL_LOOPS_COMPARE_LENGTHS_H
