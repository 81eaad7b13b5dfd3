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
/// How thick handles are, and how wide their holes.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

measures, for each pair of loops, how thick the handle is and how wide its hole: the largest ball
that can be led around the handle in the material, and the largest one that can be threaded through
the hole.

Of balls of a radius that fit inside the surface, the centres are a set that grows as the radius
falls. Each time a closed curve appears in it that leads around a handle in a new way - its linking
numbers with the loops are independent of those of the curves before - the diameter of the ball is a
thickness: there are exactly g of them for genus g. The same outside gives g clear widths. These are
numbers of the shape: they depend neither on the mesh, nor on how the loops are chosen. (In the
words of persistent homology they are where the essential classes of dimension 1 of the distance to
the surface are born, from above.) Which pair each of them belongs to is a convention: the curve is
linked with a loop of that pair, and in the order of rising diameters each takes the pair with the
shortest such loop that leaves to the others what they need. With several components, inside is
where the material is, between a shell and what is hollow in it, and what goes through it may be
linked with loops of any component.

Distances are those to the faces, not to the vertices alone. Each number comes with a bound of its
error: it is between how wide the curve that is returned is at least, and how wide any such curve
could be among points on the surface, as the edges of their Voronoi diagram tell; points are added
where the two differ. Numbers are computed, not proved: to the error that is given, that of rounding
is to be added.

Boundary curves are closed by caps, fans of faces around their middles, which count as surface.

Where the surface, with its caps, touches or crosses itself, there is no inside, and nothing is
measured; `Handle_measures::why` says so.

The time is \f$ O(n \log n) \f$ for \f$ n \f$ vertices and points on the surface, of which there are
the more the larger faces are against the width of what is measured, times a few rounds, bounded by
a multiple of the number of vertices; memory is
\f$ O(n) \f$, about a kilobyte for each of them.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result does
not depend on it.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam OutputIterator a model of `OutputIterator` that accepts
  `Handle_tunnel_loops::Handle_measures<Point>`, where `Point` is the value type of the vertex point
map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param pairs its pairs, all of them, as `handle_tunnel_loops()` writes them
\param out the iterator that the measures are written to, in the order of the pairs
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{relative_precision}
    \cgalParamDescription{the largest error that is wanted, as a part of the diameter, from 0.001 to
      0.2. It may be larger where that would take very many points}
    \cgalParamType{`double`}
    \cgalParamDefault{0.01}
  \cgalParamNEnd
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
    \cgalParamDescription{asks to stop by returning `false`; how much is done is not known, and what it
      is given is 0. It is called by one thread at a time, not always the same}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{an empty function}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last measures written

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
  mesh with finite coordinates
\throws Handle_tunnel_loops::Interrupted_exception if the callback asked to stop
\throws std::invalid_argument if the precision is not in its range

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
  const double precision =
      choose_parameter(get_parameter(np, internal_np::relative_precision), 0.01);
  if(!(precision >= 0.001 && precision <= 0.2))
    throw std::invalid_argument("the relative precision must be from 0.001 to 0.2");
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
            ? "the surface touches or crosses itself, or has a face without area"
            : "the surface with its caps touches or crosses itself, or has a face without area";
  } else
    found = impl::measure_handles(execution, surface.mesh, places, polylines, precision);
  using Point = typename std::decay_t<decltype(surface)>::Point;
  for(const auto& pair : found.pairs)
    *out++ = impl::measures_of_caller<Point>(pair, found.why);
  return out;
}

} // namespace CGAL

#endif // CGAL_HANDLE_MEASURES_H
