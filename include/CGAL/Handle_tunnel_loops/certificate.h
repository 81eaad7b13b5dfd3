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
#include <CGAL/Handle_tunnel_loops/internal/certificate/certify.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <set>
#include <type_traits>
#include <utility>

namespace CGAL {

namespace Handle_tunnel_loops::internal {

/// Returns whether all steps of the loops that are anywhere are on halfedges of the mesh.
template <typename TriangleMesh, typename PairRange>
bool are_loops_of(const TriangleMesh& tm, const PairRange& pairs) {
  const auto range = halfedges(tm);
  const std::set<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> all(range.begin(),
                                                                                      range.end());
  const auto is_loop = [&](const auto& loop) {
    return std::all_of(loop.steps().begin(), loop.steps().end(), [&](const auto& step) {
      return step.halfedge == boost::graph_traits<TriangleMesh>::null_halfedge() ||
             all.count(step.halfedge) != 0;
    });
  };
  return std::all_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
    return is_loop(pair.handle()) && is_loop(pair.tunnel());
  });
}

} // namespace Handle_tunnel_loops::internal

/*!
\ingroup PkgHandleTunnelLoopsRef

Certifies pairs of loops. It checks whether the loops of `pairs` are closed curves on `tm`, whether
they form a basis of the first homology group with integer coefficients, whether the loops of each
pair cross once, and on which side of the surface each loop bounds.

The boundary curves of a surface are closed by caps, which no loop enters. Let a component have
genus g and b > 0 boundary curves. H1 of the component has rank 2g + b - 1. It maps onto H1 of the
capped component; the classes of the boundary curves generate the kernel, and all but one of them
are independent. The loops are therefore a basis of H1 of the capped surface if and only if they
form a basis of H1 of the surface together with all boundary curves except one per component. With
linking numbers, a loop bounds inside if, after being pushed behind the faces, it bounds a surface
that does not meet the given one. On a surface with boundary, the orientation of the faces defines
what is behind them.

To check the basis, the loops are moved onto the edges, and the mesh is cut along them. A tree-
cotree decomposition of the dual graph that crosses the loops as rarely as possible gives closed
curves, and their intersection numbers with the loops are integers. The loops are a basis if and
only if these vectors span all integer vectors, which integer elimination decides. The check uses no
floating-point numbers, and the surface may have several components. The complexity is almost linear
in the size of the mesh if the loops are short.

The parts of the certificate depend on the solver to different degrees:

- *Basis.* The check shares no algorithm with the code that finds loops, except the distribution of
  work to threads. It works on a list of triangles that it reads from the mesh itself, face by face,
  and not on the arrays of the solver.
- *Crossings and sides.* One computation of intersection numbers and linking numbers decides whether
  the loops of a pair cross once and on which sides loops bound. This computation does not find
  loops either. This function applies it to the given loops on its list of triangles; a solver
  applies it to the loops on its arrays before it converts them.
- *Names.* The names are not independent of the solver. It names the loops by the same linking
  numbers and with the same function that decides here whether handle loop and tunnel loop are
  swapped. This check is useful for loops of other origin.

Linking numbers are counted in a projection, with exact predicates on the coordinates, taken as
doubles (coordinates of an exact kernel are rounded; see `Handle_tunnel_loops::Loop_linking`). The
complexity is near linear in the total length of the loops and the number of crossings in the
projection. The difference between the matrix of linking numbers and its transpose is compared with
the intersection numbers. If these disagree, or if places coincide that should be separate, because
the surface crosses or touches itself, the loops concerned are reported as undecided. The function
does not check that the surface does not cross itself. If it crosses itself away from the loops, the
linking numbers remain valid, but there is no inside in which the loops could bound.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result does
  not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param pairs the pairs of loops
\param np an optional sequence of named parameters among those listed below

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
    \cgalParamDescription{the options, of which only `do_compute_linking` is used: whether to
      compute linking numbers}
    \cgalParamType{`Handle_tunnel_loops::Solver_options`}
    \cgalParamDefault{linking numbers are computed}
  \cgalParamNEnd
  \cgalParamNBegin{basis_kind}
    \cgalParamDescription{the intended kind of basis. For `SHORTEST`, crossings and names are
      reported and not required}
    \cgalParamType{`Handle_tunnel_loops::Basis_kind`}
    \cgalParamDefault{`Handle_tunnel_loops::Basis_kind::PURE`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the certificate

\pre `tm` is a 2-manifold triangle mesh.

\throws Handle_tunnel_loops::Invalid_mesh_exception if a face of `tm` is not a triangle, or if `tm`
  has a boundary and is not an oriented 2-manifold with finite coordinates
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
  const auto face_index = CGAL::get_initialized_face_index_map(tm, np);
  const impl::Triangle_reader<TriangleMesh, std::decay_t<decltype(face_index)>> reader(tm,
                                                                                       face_index);
  impl::Triangle_list list = reader.read(execution, vertex_index, point);
  if(!list.is_closed) // its vertices may have several fans
    impl::Prepared_surface(execution, tm, vertex_index, point);
  CGAL_expensive_precondition(impl::are_loops_of(tm, pairs));
  return impl::certify(execution, std::move(list), reader.loops_of(pairs), kind, do_link);
}

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_CERTIFICATE_H
