// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_DUAL_CUTS_H
#define CGAL_DUAL_CUTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Dual_cut_check.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_request.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/cut_open.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/for_each_loop_of.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/waists.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// \file dual_cuts.h
/// Computes cuts that are dual to a basis of loops.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Computes a cut along edges for each loop of a basis of the first homology group. Each cut crosses
its loop once and no other loop, counted with sign. Such cuts make a potential single-valued on a
multiply connected surface, with one jump per cut. On a surface with boundary, a cut may consist of
closed curves and of arcs from boundary to boundary.

The basis consists of the loops of the pairs and, for each component with boundary, of all boundary
curves except the last, as `boundary_loops()` writes them, with the surface to their left.

A cut is a chain: a sequence of halfedges, each with a positive multiplicity. At every vertex that
is not on the boundary, the incoming and outgoing multiplicities are equal. A loop crosses its cut
once from right to left. Where a path crosses an edge of the cut, the potential changes by the jump
of the cut times the multiplicity of the edge.

The cuts are combinations of the edges of the cut that `cut_to_disk()` finds for the loops of the
pairs, so they follow these loops if possible. The inverse of an integer matrix of intersection
numbers makes them dual. They are short, but not necessarily shortest. Before they are written,
other code certifies in integer arithmetic that each cut is closed except at the boundary and
crosses its loop once and no other, counted with sign.

\tparam ConcurrencyTag enables sequential versus parallel computation, with the possible values of
  `cut_to_disk()`; the default is `Sequential_tag`. The result does not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam PairRange a range of `Handle_tunnel_pair<TriangleMesh>`
\tparam OutputIterator a model of `OutputIterator` that accepts
  `std::vector<std::pair<boost::graph_traits<TriangleMesh>::%halfedge_descriptor, std::int64_t>>`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param pairs all pairs of loops of `tm`, for example those that `handle_tunnel_loops()` writes
\param out the output iterator that receives the cuts: for each pair, the cut of its handle loop and
  the cut of its tunnel loop, followed by the cuts of the boundary curves
\param np an optional sequence of named parameters: `vertex_point_map` and `vertex_index_map`, as in
  `cut_to_disk()`

\return `out`, past the last cut written

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
  mesh, with or without boundary, with finite coordinates
\throws std::invalid_argument if the loops of the pairs are not a basis
\throws Handle_tunnel_loops::Uncertified_cut_exception if a cut fails its certificate. This indicates
  a defect of the package. Nothing has been written

\sa `cut_to_disk()`
\sa `boundary_loops()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename PairRange,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator dual_cuts(const TriangleMesh& tm,
                         const PairRange& pairs,
                         OutputIterator out,
                         const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  const impl::Execution execution = impl::execution_of<ConcurrencyTag>();
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto point =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                   get_const_property_map(vertex_point, tm));
  const impl::Prepared_surface surface(execution, tm, vertex_index, point);
  const impl::Flat_mesh& mesh = surface.mesh;
  impl::Cut_request request(execution, vertex_index, surface);
  request.use_lengths();
  request.open_at_boundaries();
  for(const auto& pair : pairs)
    impl::for_each_loop_of(pair, [&](const auto& loop) { request.add_loop(loop); });
  const std::vector<impl::Index> hubs = impl::hubs_of_basis(mesh);
  const impl::Cut_problem& problem = request.problem();
  std::vector<std::vector<std::pair<Halfedge, std::int64_t>>> cuts;
  for(const impl::Chain_of_halfedges& chain : impl::dual_chains(problem)) {
    cuts.emplace_back();
    for(const auto& [h, times] : chain) {
      const impl::Index forward = times > 0 ? h : problem.halfedges.twin(h);
      cuts.back().emplace_back(request.halfedge_of_caller(forward), times > 0 ? times : -times);
    }
  }
  const impl::Dual_cut_check check(tm, vertex_index, cuts);
  std::vector<std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>> loops;
  for(const auto& pair : pairs)
    impl::for_each_loop_of(pair,
                           [&](const auto& loop) { loops.push_back(check.walk_beside(loop)); });
  for(const impl::Index hub : hubs) {
    loops.emplace_back();
    for(const impl::Index v : impl::boundary_walk(mesh, hub))
      loops.back().push_back(surface.vertices[v]);
  }
  if(const std::string failure = check.failure(loops); !failure.empty())
    throw Handle_tunnel_loops::Uncertified_cut_exception("the dual cuts found are not certified: " +
                                                         failure);
  return std::move(cuts.begin(), cuts.end(), out);
}

} // namespace CGAL

#endif // CGAL_DUAL_CUTS_H
