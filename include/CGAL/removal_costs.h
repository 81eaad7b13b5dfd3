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
#include <CGAL/Handle_tunnel_loops/internal/surgery/Single_removals.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>

/// \file removal_costs.h
/// What it would take to remove handles, of each by itself.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

tells for each pair of loops what it would take to remove its handle, and no other one: by a cut
along the handle loop, and by a fill along the tunnel loop. That is how much of the solid would be
taken away or put in, and how large the caps would be, as `remove_handles()` would do it with the
same method (`Removal_method::CUT`, `Removal_method::FILL`), along these loops and in the first way
that is a repair. The mesh stays as it is.

Handles beside each other may be removed together at less cost than one by one, as bores that meet;
and a handle that cannot be removed along its loops may be along others, which `remove_handles()`
looks for and this function does not.

Time is near linear in the size of the mesh and of the caps; memory is 120 bytes per face, and what
the caps take.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result is the
  same.
\tparam TriangleMesh a model of `FaceListGraph`, a triangle mesh with or without boundary
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam OutputIterator a model of `OutputIterator` that accepts `Handle_tunnel_loops::Removal_costs`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param pairs some of its pairs, as `handle_tunnel_loops()` writes them
\param out the iterator that the costs are written to, in the order of the pairs
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{removal_options}
    \cgalParamDescription{`Removal_options::force` says whether also what is no repair counts as a
      way; all else has no effect}
    \cgalParamType{`Handle_tunnel_loops::Removal_options`}
    \cgalParamDefault{what is no repair does not count}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{is told the progress, from 0 to 1, and asks to stop by returning `false`}
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

\throws Handle_tunnel_loops::Interrupted_exception if the callback asked to stop

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
  const auto costs =
      Handle_tunnel_loops::internal::Single_removals<ConcurrencyTag, TriangleMesh, NamedParameters>(
          tm, np)
          .costs(pairs);
  return std::copy(costs.begin(), costs.end(), out);
}

} // namespace CGAL

#endif // CGAL_REMOVAL_COSTS_H
