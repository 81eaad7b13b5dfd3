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
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/waists.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <vector>

/// \file boundary_loops.h
/// The boundary curves of a surface.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

writes the boundary curves of a surface as loops, the surface to their left; or, if
`basis_kind` says so, for each its waist: a short loop that is homologous to it. The only curve of a
component bounds all of it, and so has none.

All but one of the curves of each component, whichever that is, are a basis of its first homology
group together with the loops of `handle_tunnel_loops()`. A waist may take the place of its curve.
It crosses no boundary, but may run along it.

A chain is homologous to a boundary curve if it separates that from all others. So the shortest is a
minimum cut, wherever on the surface it lies: of a graph on the mesh, which makes its length a few
percent too large. Then it is tightened to a closed geodesic. The shortest chain may be several
loops (the two legs of trousers may be narrower than the waist); so the curve itself is tightened,
too, which does not change its homotopy class, and the shortest closed walk along edges is searched
for that is homologous to the curve and shorter than the loops so far. It is tightened as well.

A waist is no longer than its curve, and no longer than any closed walk along edges that is
homologous to that, unless the search for walks is given up: it looks at 2<sup>18</sup> ways for
each curve, or at an equal share of 2<sup>22</sup> where there are more than 16 curves. A way is a
vertex and a class in which it can be reached. Then the waist is the shortest loop that has been
found so far. That it is homologous to its curve is decided exactly in either case.

The curves take linear time. For each waist, the minimum cut takes mostly near linear time; the
search for walks takes time near linear in the number of ways, and so is bounded by the budget.
Ways are looked at up to half of the length of the loops so far; how many there are is up to
exponential in this length over that of the shortest loops that are not null-homologous. What is
searched takes memory linear in the size of the mesh for each thread.

\tparam ConcurrencyTag enables sequential versus parallel computation; possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result is the
  same.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam OutputIterator a model of `OutputIterator` that accepts `Loop_on_surface<TriangleMesh>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param out the iterator that the loops are written to: of type `Loop_type::BOUNDARY`, and
  numbered by `pair_index()`, a waist as its curve
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{basis_kind}
    \cgalParamDescription{`SHORTEST` asks for waists; `PURE` for the curves as they are}
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
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal kernel deduced from the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last loop written

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
  mesh, with or without boundary, with finite coordinates

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
  std::vector<impl::Crossing_loop> flat_loops;
  const auto kind = choose_parameter(get_parameter(np, internal_np::basis_kind),
                                     Handle_tunnel_loops::Basis_kind::PURE);
  if(kind == Handle_tunnel_loops::Basis_kind::SHORTEST)
    flat_loops = impl::waists(execution, mesh);
  else
    for(impl::Index hub = mesh.first_hub; hub < mesh.first_hub + mesh.number_of_hubs; ++hub)
      flat_loops.push_back(impl::boundary_curve(mesh, hub));
  std::vector<
      Loop_on_surface<TriangleMesh, typename boost::property_traits<Vertex_point_map>::value_type>>
      loops(flat_loops.size());
  impl::for_each_index(
      execution, loops.size(),
      [&](std::size_t i) { loops[i] = convert(flat_loops[i], Loop_type::BOUNDARY, i); }, 1);
  return std::copy_if(loops.begin(), loops.end(), out,
                      [](const auto& loop) { return loop.size() != 0; });
}

} // namespace CGAL

#endif // CGAL_BOUNDARY_LOOPS_H
