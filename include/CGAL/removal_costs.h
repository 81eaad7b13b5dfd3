// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_REMOVAL_COSTS_H
#define CGAL_REMOVAL_COSTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Removal_costs.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/costs_of_removals.h>

#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <functional>
#include <type_traits>
#include <vector>

/// \file removal_costs.h
/// Computes the cost of removing each handle on its own.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Computes, for each pair of loops, the cost of removing its handle and no other: by a cut along the
handle loop, and by a fill along the tunnel loop. The cost consists of the volume that would be
removed from the solid or added to it, and of the area of the caps. The function tries the method
that `remove_handles()` would use with `Removal_method::CUT` or `Removal_method::FILL`, along these
loops, and reports the first way that is a valid repair. The mesh does not change.

Removing adjacent handles together may cost less than removing them one by one; intersecting bores
are an example. A handle that cannot be removed along its loops may be removable along other loops.
`remove_handles()` looks for such loops; this function does not.

The running time is near linear in the size of the mesh and of the caps. The memory is 120 bytes per
face plus the memory for the caps.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result does
  not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph`, a triangle mesh with or without boundary
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam OutputIterator a model of `OutputIterator` that accepts `Handle_tunnel_loops::Removal_costs`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param pairs pairs of loops of `tm`, all or some of those that `handle_tunnel_loops()` writes
\param out the output iterator that receives the costs, in the order of the pairs
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{removal_options}
    \cgalParamDescription{`Removal_options::force` allows removals that are not valid repairs; all
      other members are ignored}
    \cgalParamType{`Handle_tunnel_loops::Removal_options`}
    \cgalParamDefault{only valid repairs are considered}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a function that is called with the progress, from 0 to 1, and returns
      `false` to stop the computation}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{an empty function}
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
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a property map associating to each face of `tm` a unique index}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last costs written

\throws Handle_tunnel_loops::Interrupted_exception if the callback returned `false`

\sa `remove_handles()`
\sa `handle_measures()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename PairRange,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator removal_costs(const TriangleMesh& tm,
                             const PairRange& pairs,
                             OutputIterator out,
                             const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  constexpr impl::Execution execution = impl::execution_of<ConcurrencyTag>();
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  std::vector<impl::Choice_of_handle> handles;
  for(const auto& pair : pairs)
    handles.push_back(impl::choice_of_handle(pair, tm, vertex_index));
  if(handles.empty())
    return out;
  const Point_map point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                           get_const_property_map(vertex_point, tm));
  const auto face_index = CGAL::get_initialized_face_index_map(tm, np);
  const impl::Triangle_reader<TriangleMesh, std::decay_t<decltype(face_index)>> reader(tm,
                                                                                       face_index);
  const auto costs = impl::costs_of_removals(
      execution, reader.read(execution, vertex_index, point), handles,
      choose_parameter(get_parameter(np, internal_np::removal_options),
                       Handle_tunnel_loops::Removal_options())
          .force,
      choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>()));
  return std::copy(costs.begin(), costs.end(), out);
}

} // namespace CGAL

#endif // CGAL_REMOVAL_COSTS_H
