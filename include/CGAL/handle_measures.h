// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_MEASURES_H
#define CGAL_HANDLE_MEASURES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Handle_measures.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Measure_converter.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/measure_handles.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/places_of_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Watch_by_callback.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/self_contact.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <functional>
#include <stdexcept>
#include <type_traits>

/// \file handle_measures.h
/// Measures the thickness of handles and the clear width of their holes.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Measures the thickness of the handle and the clear width of its hole for each pair of loops. The
thickness is the diameter of the largest ball that can move around the handle inside the material.
The clear width is the diameter of the largest ball that can pass through the hole.

The centers of all balls of a given radius that fit inside the surface form a set that grows as the
radius decreases. Whenever a closed curve appears in this set that goes around a handle in a new way
(its linking numbers with the loops are independent of those of the earlier curves), the diameter of
the ball is a thickness. There are exactly g of them for genus g. The same construction outside
gives g clear widths. In terms of persistent homology, these are the births, from above, of the
essential classes of dimension 1 of the distance to the surface. The values depend on the shape
only, not on the mesh or the choice of the loops.

The assignment of values to pairs is a convention. A curve is linked with a loop of its pair. In the
order of increasing diameters, each curve takes the pair with the shortest such loop that leaves
suitable pairs for the remaining curves. If there are several components, the inside is the
material, between an outer shell and its cavities, and a ball that moves through it may be linked
with loops of any component.

Distances are measured to the faces, not only to the vertices. Each value has an error bound: the
true value lies between the clearance of the returned curve and an upper bound for all such curves:
the clearance on caps that they pass, which are cones over loops and plane sections; or, where these
do not suffice, that of the Voronoi diagram of points on the surface. The function adds points where
the bounds differ. The values are computed in floating-point arithmetic and are not certified; the
error bound does not include rounding errors.

Boundary curves are closed by caps, which are fans of faces around their centers and count as
surface. If the surface with its caps touches or crosses itself, there is no inside and nothing is
measured; `Handle_measures::why` gives the reason.

The running time is \f$ O(n \log n) \f$ per round, for a small number of rounds. Here
\f$ n \f$ is the number of vertices and points on the surface. More points are needed if faces
are large relative to the measured widths; their number is bounded by a multiple of the number of
vertices. The memory is \f$ O(n) \f$, about one kilobyte per vertex or point.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result does
  not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam OutputIterator a model of `OutputIterator` that accepts
  `Handle_tunnel_loops::Handle_measures<Point>`, where `Point` is the value type of the vertex point
  map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param pairs all pairs of loops of `tm`, as `handle_tunnel_loops()` writes them
\param out the output iterator that receives the measures, in the order of the pairs
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a function that returns `false` to stop the computation. Its argument is
      always 0, because the progress is not known. One thread at a time calls it, but not always the
      same one}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{an empty function}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last measures written

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
  mesh with finite coordinates
\throws Handle_tunnel_loops::Interrupted_exception if the callback returned `false`

\sa `handle_tunnel_loops()`
\sa `remove_handles()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename PairRange,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator handle_measures(const TriangleMesh& tm,
                               const PairRange& pairs,
                               OutputIterator out,
                               const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  impl::Watch_by_callback watch(
      choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>()));
  const impl::Execution execution = impl::execution_of<ConcurrencyTag>().watched_by(watch);
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(vertex_point, tm));
  const impl::Prepared_surface surface(execution, tm, vertex_index, point);
  const auto places = impl::places_of_vertices(execution, surface);
  const auto polylines = impl::polylines_of(pairs);
  impl::Flat_measures found;
  if(impl::touches_itself(execution, surface.mesh, places)) {
    found.pairs.resize(polylines.size());
    found.why =
        surface.mesh.number_of_hubs == 0
            ? "the surface touches or crosses itself, or has a degenerate face"
            : "the surface with its caps touches or crosses itself, or has a degenerate face";
  } else
    found = impl::measure_handles(execution, surface.mesh, places, polylines);
  using Point = typename std::decay_t<decltype(surface)>::Point;
  for(const auto& pair : found.pairs)
    *out++ = impl::measures_of_caller<Point>(pair, found.why);
  return out;
}

} // namespace CGAL

#endif // CGAL_HANDLE_MEASURES_H
