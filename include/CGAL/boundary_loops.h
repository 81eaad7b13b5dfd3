// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_BOUNDARY_LOOPS_H
#define CGAL_BOUNDARY_LOOPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Basis_kind.h>
#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/certify.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/waists.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file boundary_loops.h
/// The boundary curves of a surface.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Writes the boundary curves of a surface as loops, with the surface to their left. With `basis_kind`
set to `SHORTEST`, it writes for each curve its *waist*: a short loop that is homologous to the
curve. If a component has only one boundary curve, this curve bounds the whole component and is
null-homologous, so it has no waist. Before the waists are written, the function certifies each of
them: independent code checks in integer arithmetic that it is a closed curve on the surface and
homologous to its curve.

All boundary curves of each component except an arbitrary one, together with the loops of
`handle_tunnel_loops()`, are a basis of the first homology group of the surface. A waist may replace
its curve in this basis. A waist crosses no boundary curve, but may run along one.

A chain is homologous to a boundary curve if it separates this curve from all others. The shortest
such chain, anywhere on the surface, is therefore a minimum cut. The cut is computed on a graph on
the mesh, which overestimates its length by a few percent, and is then tightened to a closed
geodesic. The shortest chain may consist of several loops; for example, the two legs of a pair of
trousers may be narrower than the waist. The function therefore tightens the curve itself, which
does not change its homotopy class, and also searches for the shortest closed walk along edges that
is homologous to the curve and shorter than the loops found so far. The walk is tightened as well.

A waist is not longer than its curve. It is not longer than any closed walk along edges that is
homologous to its curve, unless the search for walks reaches its limit: 2<sup>18</sup> states per
curve, or an equal share of 2<sup>22</sup> if there are more than 16 curves. A state is a vertex
together with a class in which it can be reached. If the search reaches the limit, the waist is the
shortest loop found so far.

The curves take linear time, and the certificate of all waists takes almost linear time if they are
short. For each waist, the minimum cut usually takes near-linear time. The
search for walks takes near-linear time in the number of states, which the limit bounds. The search
visits states up to half the length of the shortest loop so far; the number of states may be
exponential in the ratio of this length to the length of the shortest loops that are not
null-homologous. The search needs memory linear in the size of the mesh for each thread.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result does
  not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam OutputIterator a model of `OutputIterator` that accepts `Loop_on_surface<TriangleMesh>`, or
  `Loop_on_surface<TriangleMesh, Point>` if the value type `Point` of the vertex point map differs
  from the point type of the mesh
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param out the output iterator that receives the loops. Their type is `Loop_type::BOUNDARY`, and
  `pair_index()` is the number of the curve; a waist has the number of its curve
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{basis_kind}
    \cgalParamDescription{`PURE` to write the boundary curves, `SHORTEST` to write their waists}
    \cgalParamType{`Handle_tunnel_loops::Basis_kind`}
    \cgalParamDefault{`Handle_tunnel_loops::Basis_kind::PURE`}
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
    \cgalParamDescription{a property map associating to each face of `tm` a unique index; used for
      waists}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last loop written

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
  mesh, with or without boundary, with finite coordinates
\throws Handle_tunnel_loops::Uncertified_loops_exception if a waist fails its certificate. This
  indicates a defect of the package. Nothing has been written

\sa `handle_tunnel_loops()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator boundary_loops(const TriangleMesh& tm,
                              OutputIterator out,
                              const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using Geom_traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
  const impl::Execution execution = impl::execution_of<ConcurrencyTag>();
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  const Vertex_point_map point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                                  get_const_property_map(vertex_point, tm));
  const impl::Prepared_surface surface(execution, tm, vertex_index, point);
  const impl::Flat_mesh& mesh = surface.mesh;
  const auto traits = choose_parameter<Geom_traits>(get_parameter(np, internal_np::geom_traits));
  const auto convert = surface.converter(traits);
  using Loop = typename decltype(convert)::Loop;
  const auto converted = [&](const std::vector<impl::Crossing_loop>& found) {
    std::vector<Loop> loops(found.size());
    impl::for_each_index(
        execution, loops.size(),
        [&](std::size_t i) { loops[i] = convert(found[i], Loop_type::BOUNDARY, i); }, 1);
    return loops;
  };
  std::vector<impl::Crossing_loop> flat_curves;
  for(impl::Index hub = mesh.first_hub; hub < mesh.first_hub + mesh.number_of_hubs; ++hub)
    flat_curves.push_back(impl::boundary_curve(mesh, hub));
  const std::vector<Loop> curves = converted(flat_curves);
  const auto kind = choose_parameter(get_parameter(np, internal_np::basis_kind),
                                     Handle_tunnel_loops::Basis_kind::PURE);
  if(kind != Handle_tunnel_loops::Basis_kind::SHORTEST)
    return std::copy(curves.begin(), curves.end(), out);
  std::vector<Loop> waists = converted(impl::waists(execution, mesh));
  waists.erase(std::remove_if(waists.begin(), waists.end(),
                              [](const Loop& waist) { return waist.size() == 0; }),
               waists.end());
  const auto face_index = CGAL::get_initialized_face_index_map(tm, np);
  const impl::Triangle_reader<TriangleMesh, std::decay_t<decltype(face_index)>> reader(tm,
                                                                                       face_index);
  std::vector<impl::Listed_loop> listed_curves;
  for(const Loop& curve : curves)
    listed_curves.push_back(reader.listed(curve));
  std::vector<impl::Listed_waist> listed_waists;
  for(const Loop& waist : waists)
    listed_waists.push_back({reader.listed(waist), waist.pair_index()});
  const std::vector<std::string> problems = impl::problems_of_waists(
      execution, reader.read(execution, vertex_index, point), listed_curves, listed_waists);
  if(!problems.empty())
    throw Handle_tunnel_loops::Uncertified_loops_exception("the waists found are not certified: " +
                                                           problems.front());
  return std::move(waists.begin(), waists.end(), out);
}

} // namespace CGAL

#endif // CGAL_BOUNDARY_LOOPS_H
