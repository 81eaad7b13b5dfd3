// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_CERTIFY_CURVE_SKELETON_H
#define CGAL_CERTIFY_CURVE_SKELETON_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Curve_skeleton.h>
#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/Skeleton_certificate.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/certify_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/places_of_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

namespace Handle_tunnel_loops::internal {

/// Returns the numbers of the caller's faces. Both arguments must outlive the result.
template <typename Prepared, typename FaceIndexMap>
Face_number face_numbers(const Prepared& surface, FaceIndexMap face_index) {
  return [&surface, face_index](Index u, Index v, Index w) -> std::size_t {
    const auto& tm = surface.tm;
    const auto h = halfedge(surface.vertices[u], surface.vertices[v], tm).first;
    const bool is_left = target(next(h, tm), tm) == surface.vertices[w];
    return get(face_index, face(is_left ? h : opposite(h, tm), tm));
  };
}

/// Returns a `Curve_skeleton`, or another graph with the same properties, as arrays.
template <typename Graph> Flat_skeleton flat_skeleton(const Graph& graph) {
  Flat_skeleton flat;
  const auto index = get(boost::vertex_index, graph);
  for(const auto v : CGAL::make_range(vertices(graph))) {
    const auto& p = graph[v].point;
    flat.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    flat.radii.push_back(graph[v].radius);
    flat.component_of.push_back(component_number(graph[v].component));
    flat.is_inlet.push_back(graph[v].is_inlet);
  }
  for(const auto e : CGAL::make_range(edges(graph)))
    flat.edges.push_back({static_cast<Index>(get(index, source(e, graph))),
                          static_cast<Index>(get(index, target(e, graph)))});
  return flat;
}

/// Returns a loop moved to one end of each edge that it crosses.
template <typename Loop, typename TriangleMesh, typename IndexOfVertex>
std::vector<Index> walk_of(const Loop& loop, const TriangleMesh& tm, const IndexOfVertex& index) {
  std::vector<Index> walk;
  for(const auto& step : loop.steps())
    if(const Index v =
           index(step.ratio == 1. ? target(step.halfedge, tm) : source(step.halfedge, tm));
       walk.empty() || walk.back() != v)
      walk.push_back(v);
  while(walk.size() > 1 && walk.back() == walk.front())
    walk.pop_back();
  if(walk.size() == 1)
    walk.clear();
  return walk;
}

/// Certifies a skeleton on the arrays of a surface, given the pairs of loops.
template <typename Prepared, typename VertexIndexMap, typename FaceIndexMap, typename PairRange>
Skeleton_certificate certify_skeleton(Execution execution,
                                      const Prepared& surface,
                                      const std::vector<Vector>& places,
                                      VertexIndexMap vertex_index,
                                      FaceIndexMap face_index,
                                      const Flat_skeleton& skeleton,
                                      const PairRange& pairs,
                                      const Point_name& point_name = {}) {
  const std::vector<Index> flat = indices_in_arrays(surface, vertex_index);
  const auto index = [&](const auto v) { return flat[get(vertex_index, v)]; };
  std::vector<std::vector<Index>> walks;
  const auto certify = [&] {
    return certify_skeleton(execution, surface.mesh, places, skeleton, walks,
                            face_numbers(surface, face_index), point_name);
  };
  for(const auto& pair : pairs)
    walks.push_back(walk_of(pair.handle(), surface.tm, index));
  const Skeleton_certificate certificate = certify();
  if(!certificate.connected || !certificate.inside || certificate.basis)
    return certificate;
  // The handle loops of a component that is taken alone may bound beyond it; the loops of a basis
  // determine both sides.
  for(const auto& pair : pairs)
    walks.push_back(walk_of(pair.tunnel(), surface.tm, index));
  return certify();
}

} // namespace Handle_tunnel_loops::internal

/*!
\ingroup PkgHandleTunnelLoopsRef

Certifies a curve skeleton that `curve_skeleton()` or any other program has computed. It checks
these properties:

- Each edge lies strictly inside its piece of the solid, and meets no face of the surface. A piece
  lies between an outer component and its cavities, as `curve_skeleton()` describes; its number is
  that of the outer component. The exception is an inlet: the apex of the
  cap that closes a boundary curve, which is a leaf of the skeleton. Its edge meets the cap there.
- Two edges meet at most in a common endpoint.
- In each piece, the skeleton is connected, and its cycles are a basis of H1 of the piece. The
number of independent cycles is the sum of the genera of the surfaces that bound it, and the matrix
of their linking numbers with the handle loops of these surfaces has determinant 1 or -1. By
Alexander duality, such a determinant proves that the cycles are a basis, even if the loops are
arbitrary closed curves on the surface. Conversely, if the loops are a basis in the sense of
`handle_tunnel_loops()` and the cycles are a basis, the determinant is 1 or -1.

All properties are decided by exact predicates on the coordinates of the mesh and the skeleton,
taken as doubles (coordinates of an exact kernel are rounded), and by integer arithmetic. The
complexity is near linear in the size of the mesh and the skeleton.

Like `certify_handle_tunnel_loops()`, the function does not check that the surface neither crosses
nor touches itself. If it does, it has no inside, and the certificate is meaningless. The function
does check that the caps meet neither the surface nor each other.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result does
  not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph`, a triangle mesh with or without boundary
\tparam Graph `Curve_skeleton<TriangleMesh>`, or another graph with indexed vertices that have the
  properties `point`, `radius`, `component` and `is_inlet`
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param skeleton the skeleton
\param pairs the pairs of loops of `tm`: a certified basis
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
    \cgalParamDescription{a property map associating to each face of `tm` a unique index; the
      certificate identifies faces by it}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the certificate

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
  mesh with finite coordinates

\sa `curve_skeleton()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename Graph,
          typename PairRange,
          typename NamedParameters = parameters::Default_named_parameters>
Handle_tunnel_loops::Skeleton_certificate
certify_curve_skeleton(const TriangleMesh& tm,
                       const Graph& skeleton,
                       const PairRange& pairs,
                       const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const impl::Execution execution = impl::execution_of<ConcurrencyTag>();
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto face_index = CGAL::get_initialized_face_index_map(tm, np);
  const auto point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(vertex_point, tm));
  impl::Prepared_surface surface(execution, tm, vertex_index, point);
  const std::vector<impl::Vector> places = impl::places_of_vertices(execution, surface);
  std::string taken_alone = impl::join_components_of_solids(execution, surface.mesh, places);
  Handle_tunnel_loops::Skeleton_certificate certificate = impl::certify_skeleton(
      execution, surface, places, vertex_index, face_index, impl::flat_skeleton(skeleton), pairs);
  certificate.taken_alone = std::move(taken_alone);
  return certificate;
}

} // namespace CGAL

#endif // CGAL_CERTIFY_CURVE_SKELETON_H
