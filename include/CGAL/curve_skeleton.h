// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_CURVE_SKELETON_H
#define CGAL_CURVE_SKELETON_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Curve_skeleton.h>
#include <CGAL/Handle_tunnel_loops/Skeleton_certificate.h>
#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Loops_on_arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Skeleton_converter.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/find_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Own_numbering.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops/stages.h>
#include <CGAL/certify_curve_skeleton.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <chrono>
#include <functional>
#include <stdexcept>
#include <utility>

/// \file curve_skeleton.h
/// A curve skeleton inside a surface, with as many cycles as the surface has handles.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

computes a curve skeleton of the solid that a surface encloses: lines in the middle of its parts.

For each component of the surface, the skeleton is connected and lies strictly inside; no two of its
edges meet but in a common end; and it has as many independent cycles as the genus, which are a
basis of the first homology group of the solid. This is proved of every answer in exact arithmetic
(`certify_curve_skeleton()`; `Skeleton_statistics::certificate` says what has been proved), provided
that the surface neither crosses nor touches itself, which is not checked. Where it does there is no
inside, and the certificate tells which edges meet the surface.

Each component is looked at by itself, on its bounded side; lines of one avoid the others all the
same. A boundary curve is closed by a cap, a fan of faces around its middle, and is an inlet: it has
a leaf there (`Curve_skeleton_vertex::is_inlet`), which alone does not lie inside. Where that fan
would meet itself, the surface or another cap, as on curves that wind, its apex is moved to where it
meets nothing; if no such place is found, the certificate says so.

From places on the surface, evenly spread against the thickness of the solid there, balls are grown
along the normals until they reach the opposite side. Balls of neighbouring places are joined where
the way between them is free, or else along the surface a little inside, which always is. Cycles of
this graph are chosen by how they link with the handle loops, the ones through large balls first,
and where balls are alike, as in plates and in the walls of tubes, the ones far from the rim; then
ways to the ends of limbs. A limb is a region of places far from the cycles, or from the widest
place, that is long against the girth of its base, or that narrow places lead to, as to a wheel on
its axle; and what is left may be a limb of a limb. Arcs that leave a joint side by side are one
until they part. In the ball around a joint, ways are straight; arcs are smooth and in the middle,
and straight in plates. All of this is done in a frame that is told by the shape of the mesh: how
the mesh lies, and how its elements are numbered, makes no difference but by rounding, unless the
mesh looks the same, or nearly, from several sides.

The time is that of `handle_tunnel_loops()`, plus \f$ O(n + m \log n) \f$ for \f$ m \f$ places, of
which there are at most tens of thousands, whatever the number \f$ n \f$ of faces.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag`, `Parallel_if_available_tag`, `Cuda_tag` and
  `Cuda_if_available_tag`, of which the latter two are about the handle loops. The result does not
  depend on it.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Graph `Curve_skeleton<TriangleMesh, Point>`, where `Point` is the value type of the vertex point
  map; or the graph that `extract_mean_curvature_flow_skeleton()` fills, with vertices that have the
  properties `point` and `vertices`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param skeleton the graph that the result is assigned to
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{skeleton_options}
    \cgalParamDescription{what the skeleton is to be like}
    \cgalParamType{`Handle_tunnel_loops::Skeleton_options`}
    \cgalParamDefault{as that says}
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
    \cgalParamDescription{a property map associating to each face of `tm` a unique index, by which the
      certificate names faces}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{is told the progress of the computation of loops, from 0 to 1, and asks to
      stop by returning `false`}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{an empty function}
    \cgalParamExtra{After a stop the graph is as it was.}
  \cgalParamNEnd
  \cgalParamNBegin{solver_options}
    \cgalParamDescription{how the handle loops are computed; they are not made short, as any basis will do}
    \cgalParamType{`Handle_tunnel_loops::Solver_options`}
    \cgalParamDefault{as that says}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what the computation did, and what has been proved

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle mesh
  with finite coordinates
\throws Handle_tunnel_loops::Interrupted_exception if the callback asked to stop
\throws std::invalid_argument if the length of the shortest limb is negative or no number

\sa `certify_curve_skeleton()`
\sa `CGAL::reeb_graph()`
\sa `CGAL::split_graph_into_polylines()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename Graph,
          typename NamedParameters = parameters::Default_named_parameters>
Handle_tunnel_loops::Skeleton_statistics
curve_skeleton(const TriangleMesh& tm,
               Graph& skeleton,
               const NamedParameters& np = parameters::default_values()) {
  using namespace Handle_tunnel_loops;
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point began) {
    return std::chrono::duration<double>(Clock::now() - began).count();
  };
  const auto options =
      choose_parameter(get_parameter(np, internal_np::skeleton_options), Skeleton_options());
  if(!(options.shortest_limb >= 0.))
    throw std::invalid_argument("the length of the shortest limb must not be negative");
  const impl::Execution execution = impl::execution_of<ConcurrencyTag>();
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto face_index = CGAL::get_initialized_face_index_map(tm, np);
  const auto point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                      get_const_property_map(vertex_point, tm));
  const auto began = Clock::now();
  impl::Prepared_surface surface(execution, tm, vertex_index, point);
  Skeleton_statistics statistics;
  surface.describe(statistics);

  auto places = impl::places_of_vertices(execution, surface);
  const impl::Own_frame frame = impl::put_into_own_frame(execution, surface, places);
  impl::Loop_request request = impl::loop_request(
      choose_parameter(get_parameter(np, internal_np::solver_options), Solver_options()));
  request.passes.do_tighten = request.classes.do_shorten = false; // any basis will do
  request.classes.do_link = true;                                 // which of them are handle loops
  request.make_passes = &impl::make_passes<ConcurrencyTag>;
  impl::Loops_on_arrays loops(surface.coordinates(execution));
  loops.find(
      execution, surface.mesh, std::move(request),
      choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>()));
  statistics.seconds_of_loops = seconds_since(began);

  const auto has_loops = Clock::now();
  impl::Found_skeleton found =
      impl::find_skeleton(execution, surface.mesh, frame, places, loops.pairs(), options,
                          impl::face_numbers(surface, face_index));
  statistics.number_of_balls = found.number_of_balls;
  statistics.certificate = std::move(found.certificate);
  impl::convert_skeleton(surface, found, skeleton);
  statistics.seconds_of_skeleton = seconds_since(has_loops);
  return statistics;
}

} // namespace CGAL

#endif // CGAL_CURVE_SKELETON_H
