// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_THROATS_H
#define CGAL_THROATS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Throat.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/Throats_of_caller.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <vector>

/// \file throats.h
/// Finds the narrow places of a surface, beyond those of a basis.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Finds the throats of a surface: closed geodesics that are shorter than all neighboring loops. While
a basis has two loops per handle, a surface may have more throats: a necklace of ten beads has one
handle and ten throats, and a dumbbell, of genus 0, has one throat.

The candidates are short contours of distance functions on the surface, the loops of a basis, and
loops through given vertices. They are tightened, and distinguished by homology class and position.
The output is sorted by decreasing prominence, and by increasing length for equal prominence.

The *prominence* of a loop is an estimate of the amount by which it must become longer before it can
slide away. A front moves from the loop over the surface, on either side. It stops where it reaches
the loop again or a boundary curve, so it stays homologous to the loop and may consist of several
curves. The prominence is the maximal length of the front before it becomes shorter than the loop,
minus the length of the loop, on the side where this is less. It is infinite if the front does not
become shorter before it is four times as long as the loop or, if there are very many throats,
before it covers much of the surface. The front does not necessarily take the best path,
so the estimate tends to be too large. On surfaces with folds, it may be too small.

A loop is not a throat if it can slide away after growing by less than the fraction
`least_prominence` of its length. The following rules use the same fraction:
- Among loops of one class with nothing longer by this fraction between them, only one is a throat.
  For example, only the shortest loop around a cylinder is.
- Among loops of one class that cross each other, only the one with the largest ratio of prominence
  to length is a throat.
- A loop in the class of two shorter loops together is not a throat if it is not longer than both
  together by this fraction.

On a mesh of 10,000 or more vertices, the search uses a coarse mesh of the same topology if that is
much smaller. Its results are tightened on the mesh itself.

Each throat is guaranteed to be a closed curve on the surface that tightening does not shorten, and
its homology class is exact. It is not guaranteed that all throats are found, nor that tightening
finds the shortest of all nearby loops on a rough surface. Boundary curves are closed by caps, and
no loop slides across a cap.

The running time is linear in the size of the mesh, except for sorting, for tightening the
candidates, and for fronts that move far. In the worst case, each throat costs as much as computing
distances on the (coarse) surface. The set of throats does not depend on the numbering of the
vertices or on the unit of length, except for ties and, if a coarse mesh is used, for small throats
of low prominence.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result does
  not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam OutputIterator a model of `OutputIterator` that accepts
  `Handle_tunnel_loops::Throat<TriangleMesh>`, or `Handle_tunnel_loops::Throat<TriangleMesh, Point>`
  if the value type `Point` of the vertex point map differs from the point type of the mesh
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param pairs all pairs of loops of `tm`, as `handle_tunnel_loops()` writes them; an empty range if
  the genus is 0
\param out the output iterator that receives the throats
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{through_vertices}
    \cgalParamDescription{vertices through which throats are requested. For each vertex, the loops
      through it are tried from short to long. The first loop that becomes a throat when it is
      tightened without this constraint is among the throats, even if an equivalent one exists.
      There may be no such loop}
    \cgalParamType{a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{an empty range}
  \cgalParamNEnd
  \cgalParamNBegin{least_prominence}
    \cgalParamDescription{the minimal prominence of a throat, relative to its length; positive}
    \cgalParamType{`double`}
    \cgalParamDefault{0.25}
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

\return `out`, past the last throat written

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
  mesh with finite coordinates
\throws std::invalid_argument if the number of pairs differs from the genus, if a vertex has no
  face, or if the least prominence is not positive

\sa `handle_tunnel_loops()`
\sa `boundary_loops()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename PairRange,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator throats(const TriangleMesh& tm,
                       const PairRange& pairs,
                       OutputIterator out,
                       const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using Geom_traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  const Vertex_point_map point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                                  get_const_property_map(vertex_point, tm));
  std::vector<Vertex> through;
  if constexpr(!parameters::is_default_parameter<NamedParameters,
                                                 internal_np::through_vertices_t>::value)
    for(const Vertex v : get_parameter(np, internal_np::through_vertices))
      through.push_back(v);
  const impl::Throats_of_caller finder(impl::execution_of<ConcurrencyTag>(), tm, point,
                                       CGAL::get_initialized_vertex_index_map(tm, np));
  return finder.find(
      pairs, through, choose_parameter(get_parameter(np, internal_np::least_prominence), 0.25),
      choose_parameter<Geom_traits>(get_parameter(np, internal_np::geom_traits)), out);
}

} // namespace CGAL

#endif // CGAL_THROATS_H
