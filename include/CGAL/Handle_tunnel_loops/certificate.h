// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Certificate_record.h>
#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Certification.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/mesh_checks.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

computes whether the loops of `pairs` are closed curves on `tm` that form a basis of the first
homology group with integer coefficients, whether the loops of each pair cross once, and which
of them bound inside and outside the solid that the surface encloses.

The boundary curves of a surface with boundary are closed by caps, which no loop enters. If g is the
genus and b > 0 the number of boundary curves of a component, H1 of the surface has the rank 2g + b
- 1, and is mapped onto H1 of the capped surface with the classes of the boundary curves as kernel,
of which all but one are independent. So the loops are a basis of H1 of the capped surface if and
only if they are one of H1 of the surface together with all boundary curves but one of each
component. With linking numbers, a loop bounds inside if, pushed behind the faces, it bounds a
surface that meets none of the given one. Behind the faces is, where there is a boundary, as they
are oriented.

The loops are moved onto the edges, and the mesh is cut along them. The intersection numbers of the
loops with the closed curves of a tree-cotree decomposition of the dual graph that crosses them as
rarely as possible are integers; the loops are a basis if and only if these vectors span all integer
vectors, which integer elimination decides. No floating-point number plays a part in this, and the
surface need not be connected. Almost linear in the size of the mesh where the loops are short.

What is independent of what: whether the loops are a basis is decided by code that shares no
algorithm with what finds loops, only how work is dealt out to threads; where there is a boundary,
also the arrays of the mesh, which have its caps. That the loops of a pair
cross once, and what is said of inside and outside, rest on one computation of intersection and
linking numbers, which finds no loops either: here, of these loops on this mesh; in a solver, of the
loops that became these, on the arrays. The names are not checked independently of the solver:
it names the loops by the same linking numbers and the same function that decides here whether they
have each other's names. So this part of the check is one for loops that come from elsewhere.

Linking numbers are counted in a projection by exact predicates on the coordinates, taken as doubles
(those of an exact kernel are rounded; see `Handle_tunnel_loops::Loop_linking`): near linear in the
total length of the loops and the number of places where one is seen to pass over another. Their
difference with the transpose is compared with the intersection numbers; where these disagree or
places coincide that should be apart, because the surface crosses or touches itself, the loops
concerned are reported as undecided. That the surface nowhere crosses itself is not checked; where
it does, away from the loops, linking numbers remain what they are, but there is no inside for the
loops to bound in.

\tparam ConcurrencyTag enables sequential versus parallel computation; possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result is the
  same.
\tparam TriangleMesh a model of `FaceListGraph`, a triangle mesh with or without boundary
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param pairs the loops
\param np named parameters

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a property map associating to each face of `tm` a unique index}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{solver_options}
    \cgalParamDescription{of which `do_compute_linking` is looked at: whether to compute linking
      numbers}
    \cgalParamType{`Handle_tunnel_loops::Solver_options`}
    \cgalParamDefault{they are computed}
  \cgalParamNEnd
  \cgalParamNBegin{basis_kind}
    \cgalParamDescription{what the loops are meant to be: of the shortest basis it is reported, and
      not required, that pairs cross once and that names are right}
    \cgalParamType{`Handle_tunnel_loops::Basis_kind`}
    \cgalParamDefault{`Handle_tunnel_loops::Basis_kind::PURE`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre `tm` is a 2-manifold triangle mesh.

\throws Handle_tunnel_loops::Invalid_mesh_exception if a face of `tm` is no triangle, or if `tm` has
  a boundary and is no oriented 2-manifold with finite coordinates
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename PairRange,
          typename NamedParameters = parameters::Default_named_parameters>
Handle_tunnel_loops::Certificate
certify_handle_tunnel_loops(const TriangleMesh& tm,
                            const PairRange& pairs,
                            const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const impl::Execution execution = impl::execution_of<ConcurrencyTag>();
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(vertex_point, tm));
  const Handle_tunnel_loops::Basis_kind kind = choose_parameter(
      get_parameter(np, internal_np::basis_kind), Handle_tunnel_loops::Basis_kind::PURE);
  const bool do_link = choose_parameter(get_parameter(np, internal_np::solver_options),
                                        Handle_tunnel_loops::Solver_options())
                           .do_compute_linking;
  const bool is_closed = impl::is_closed_after_check(execution, tm, vertex_index);
  CGAL_expensive_precondition(impl::are_loops_of(tm, pairs));
  if(is_closed) {
    const auto face_index = CGAL::get_initialized_face_index_map(tm, np);
    const impl::Closed_surface surface(tm, point, vertex_index, face_index);
    return impl::certify(execution, surface, kind, pairs, do_link);
  }
  const impl::Prepared_surface prepared(execution, tm, vertex_index, point);
  const impl::Flat_surface surface(prepared.mesh, prepared.coordinates(execution));
  return impl::certify_flat(execution, surface, kind, surface.pairs(tm, vertex_index, pairs),
                            do_link);
}

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_H
