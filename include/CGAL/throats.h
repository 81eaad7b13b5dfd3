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
/// All narrow places of a surface, not only those of a basis.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

finds throats of a surface: closed geodesics that are shorter than all loops next to them. A basis
has one loop for each handle; a necklace of ten beads has one handle and ten throats, and a
dumb-bell, of genus 0, has one.

Candidates are short contours of distances on the surface, the loops of a basis, and loops through
given vertices. They are tightened, and told apart by class and place. The most prominent come
first, of equally prominent ones the shortest.

The *prominence* is an estimate of how much longer a loop must become before it slips away. A front
runs from the loop over the surface, on either side. Where it comes back to the loop, or to a
boundary curve, it stays; so it is homologous to the loop all the time, in one curve or in several.
How long it is at most, before it is shorter than the loop, on the side where that is less: that,
less the loop, is the prominence. It is infinite if the front does not become shorter before it is
four times as long; where there are very many throats, one that runs over much of the surface is not
waited for. The front need not be the best way off, and so the estimate tends to be too
large; where a surface has folds, it may be too small.

What slips off before it is longer by a part (`least_prominence`) is no throat. Of loops of one
class between which nothing is longer by that part one is a throat: of those around a cylinder, the
shortest. Of those of one class that cross each other, the most prominent for its length is one. A
loop in the class of two shorter ones, which together are not longer by that part, is none.

On a mesh of ten thousand vertices or more the search is on a coarse mesh of the same topology,
where that is much smaller; what is found there is tightened on the mesh itself.

That a throat is a closed curve on the surface that tightening does not make shorter, and to which
classes it belongs, is certain. That all throats are found is not; neither is it that tightening
finds the shortest of all loops close by on a rough surface. Boundary curves are closed by caps, as
ever, over which no loop slips.

Time is linear in the size of the mesh, but for sorting, for the tightening of candidates, and for
fronts that run far: at worst each throat costs as much as distances on the (coarse) surface. Which
throats are found does not depend on the numbers of the vertices, but for ties and, where a coarse
mesh is looked at, for small and slight ones.

\tparam ConcurrencyTag enables sequential versus parallel computation; possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result is the
  same.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam OutputIterator a model of `OutputIterator` that accepts
  `Handle_tunnel_loops::Throat<TriangleMesh>`, with the value type of the vertex point map as second
  argument if that is not the mesh's own
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param pairs its pairs of loops, as `handle_tunnel_loops()` writes them; none if its genus is 0
\param out the iterator that the throats are written to
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{through_vertices}
    \cgalParamDescription{vertices. Of the loops through each of them, from short ones to long ones, the
      first that becomes a throat when it is let go and tightened is among the throats, even if
      another one is as good. There may be none}
    \cgalParamType{a range of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{no vertices}
  \cgalParamNEnd
  \cgalParamNBegin{least_prominence}
    \cgalParamDescription{how prominent throats are at least, as a part of their lengths}
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
\throws std::invalid_argument if there are not as many pairs as the genus says, if a vertex has no
  faces, or if the least prominence is not positive

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
