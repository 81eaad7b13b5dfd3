// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_REEB_GRAPH_OF_FUNCTION_H
#define CGAL_REEB_GRAPH_OF_FUNCTION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_computation.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <type_traits>

/// \file reeb_graph_of_function.h
/// The Reeb graph of a function on the vertices, without what a diffusion needs.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

computes the Reeb graph of a function on the vertices of a surface, as `CGAL::reeb_graph()` does
with a diffusion. This header compiles in less time, as it includes nothing that finds loops.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag`, and `Parallel_if_available_tag`. The result does
  not depend on it. Other tags do not compile: there is no field that a device or the reference
  solver could compute.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexFunctionMap a class model of `ReadablePropertyMap` with the vertices of `tm` as keys
  and numbers that `CGAL::to_double()` takes as values; they are compared as `double`, integers as
  they are
\tparam Graph a `Reeb_graph<TriangleMesh, Point>`, where `Point` is the value type of the vertex
  point map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param function the function; equal values are ordered by the indices of their vertices
\param graph the graph that the result is assigned to
\param np named parameters: `reeb_options`, `vertex_arc_map`, `vertex_value_map`,
  `vertex_point_map`, `vertex_index_map` and `geom_traits` of `CGAL::reeb_graph()`

\return what the computation did

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold
  triangle mesh with finite coordinates
\throws Handle_tunnel_loops::Invalid_function_exception if the function is infinite or not a number
  at a vertex
\throws std::invalid_argument if the threshold is not in [0, 1]

\sa `CGAL::reeb_graph()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename VertexFunctionMap,
          typename Graph,
          typename NamedParameters = parameters::Default_named_parameters>
Handle_tunnel_loops::Reeb_statistics
reeb_graph_of_function(const TriangleMesh& tm,
                       const VertexFunctionMap& function,
                       Graph& graph,
                       const NamedParameters& np = parameters::default_values()) {
  namespace impl = Handle_tunnel_loops::internal;
  static_assert(std::is_same<ConcurrencyTag, Sequential_tag>::value ||
                    std::is_same<ConcurrencyTag, Parallel_tag>::value ||
                    std::is_same<ConcurrencyTag, Parallel_if_available_tag>::value,
                "the graph of a given function is computed on the processor, with Sequential_tag, "
                "Parallel_tag or Parallel_if_available_tag");
  return impl::Reeb_computation<TriangleMesh, NamedParameters>(impl::execution_of<ConcurrencyTag>(),
                                                               tm, np)
      .run_on_function(function, graph);
}

} // namespace CGAL

#endif // CGAL_REEB_GRAPH_OF_FUNCTION_H
