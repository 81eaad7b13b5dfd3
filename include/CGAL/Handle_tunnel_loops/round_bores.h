// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_ROUND_BORES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_ROUND_BORES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Round_bore.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/round_bores_of.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <optional>
#include <type_traits>
#include <vector>

/// \file round_bores.h
/// Finds the bores that tunnel loops go around, with their diameters and axes.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Finds, for each pair of loops, the round bore that its tunnel loop goes around, if there is one. A
bore is round if the faces that can be reached from the loop without crossing a convex edge contain
a cylinder all around, and end at mouths of which at least one is planar. The diameter is that of
the circle through the vertices of the wall, so it is exact for any number of sides from six on. For
a bore with counterbores, it is the diameter of the narrowest part. The parts of a
bore that others part are on the cylinder of the longest, up to a hundredth of the diameter.

The running time is near linear in the size of the mesh and of the walls of the bores. It is that of
reading the mesh if no loop looks like that of a bore: most faces that a tight loop around a bore
crosses are parallel to the axis of the loop.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result does
  not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam OutputIterator a model of `OutputIterator` that accepts
  `std::optional<Handle_tunnel_loops::Round_bore<Point>>`, where `Point` is the point type of the
  mesh
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param pairs pairs of loops on `tm`, for example those that `handle_tunnel_loops()` writes
\param out the output iterator that receives one entry for each pair, in the order of the pairs; the
  entry is empty if there is no round bore
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
    \cgalParamExtra{Coordinates are taken as doubles.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a property map associating to each face of `tm` a unique index}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last entry written

\pre `tm` is an oriented 2-manifold triangle mesh, with or without boundary, with finite
  coordinates, and the loops lie on it.

\sa `remove_handles()`, which can select bores by diameter (`Handle_tunnel_loops::Removal_options`)
\sa `loop_shape()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename PairRange,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator round_bores(const TriangleMesh& tm,
                           const PairRange& pairs,
                           OutputIterator out,
                           const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  using Point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using Point = typename boost::property_traits<Point_map>::value_type;
  using Bore = Handle_tunnel_loops::Round_bore<Point>;
  constexpr impl::Execution execution = impl::execution_of<ConcurrencyTag>();
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto face_index = CGAL::get_initialized_face_index_map(tm, np);
  const auto point =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                   get_const_property_map(vertex_point, tm));
  std::vector<impl::Tunnel_to_search> tunnels;
  for(const auto& pair : pairs) {
    tunnels.push_back({impl::loop_choice(pair.tunnel(), tm, vertex_index).places, {}});
    for(const auto& p : pair.tunnel().points())
      tunnels.back().points.push_back(
          {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  if(tunnels.empty())
    return out;
  const impl::Triangle_reader<TriangleMesh, std::decay_t<decltype(face_index)>> reader(tm,
                                                                                       face_index);
  for(const auto& bore :
      impl::round_bores_of(execution, reader.read(execution, vertex_index, point), tunnels))
  {
    std::optional<Bore> converted;
    if(bore)
      converted = Bore{bore->diameter,
                       Point(bore->center[0], bore->center[1], bore->center[2]),
                       {bore->axis[0], bore->axis[1], bore->axis[2]},
                       bore->length,
                       bore->deviation,
                       bore->drilling};
    *out++ = converted;
  }
  return out;
}

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_ROUND_BORES_H
