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
/// Computes the Reeb graph of a function on the vertices. Includes no code for diffusion.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Computes the Reeb graph of a function on the vertices of a surface. The graph has the properties
that `CGAL::reeb_graph()` describes. This header compiles faster than `CGAL/reeb_graph.h`, because
it includes no code that finds loops.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag`, and `Parallel_if_available_tag`. The result does
  not depend on the tag. Other tags do not compile, because there is no field that a device or the
  reference solver could compute.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexFunctionMap a class model of `ReadablePropertyMap` with the vertices of `tm` as keys
  and numbers as values, of a type that `CGAL::to_double()` accepts. Integers are compared exactly;
  other values are compared as `double`.
\tparam Graph `Reeb_graph<TriangleMesh, Point>`, where `Point` is the value type of the vertex point
  map
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param function the function; equal values are ordered by the indices of their vertices
\param graph the graph that receives the result; its previous content is replaced
\param np an optional sequence of named parameters: `reeb_options`, `vertex_arc_map`,
  `vertex_value_map`, `vertex_point_map`, `vertex_index_map` and `geom_traits`, as in
  `CGAL::reeb_graph()`

\return the statistics of the computation

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold
  triangle mesh with finite coordinates
\throws Handle_tunnel_loops::Invalid_function_exception if a value of the function is infinite or
  not a number
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
