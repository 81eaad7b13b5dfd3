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
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Skeleton_converter.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/find_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/put_into_own_frame.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops/stages.h>
#include <CGAL/certify_curve_skeleton.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file curve_skeleton.h
/// Computes a curve skeleton inside a surface, with as many cycles as the surface has handles.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Computes a curve skeleton of the solid that a surface encloses: curves along the middle of its
parts.

The solid is in pieces. Each lies between an outer component of the surface and the cavities in it:
the components next within that are oriented the other way, as the core of a casting or the lumen of
a vessel. In each piece, the skeleton is connected and lies strictly inside, two of its
edges meet at most in a common endpoint, and it has as many independent cycles as the genera of the
surfaces add up to, which are a basis of the first homology group of the piece. These properties are
certified in exact arithmetic for every result (`certify_curve_skeleton()`);
`Skeleton_statistics::certificate` reports which of them hold. They require that the surface neither
crosses nor touches itself, which is not checked. If it does, it has no inside, and the certificate
lists the edges that meet the surface.

A component that meets another one, or is oriented like the next one around it, is taken alone, on
its bounded side; `Skeleton_certificate::taken_alone` says so. The skeletons of different pieces
avoid each other. A boundary curve is closed by a cap, a fan of faces around its center. The apex of
the cap is an inlet: a leaf of the skeleton
(`Curve_skeleton_vertex::is_inlet`), and the only kind of vertex that does not lie inside. If the
fan would meet itself, the surface or another cap, as on winding curves, its apex is moved to a
position where it meets none of them. If no such position is found, the certificate reports it.

The method places samples on the surface, spaced in proportion to the local thickness of the solid,
and grows a ball along the normal of each until it reaches the opposite side. Balls of neighboring
samples are joined by a straight edge if it stays inside, and otherwise along the surface, slightly
inside of it, which is always possible. The cycles of this graph are chosen by their linking numbers
with the handle loops. Cycles through large balls come first; among balls of similar size, as in
plates and in the walls of tubes, those far from the rim come first. Paths to the ends of the limbs
are added next. A limb is a region of samples far from the cycles, or from the widest place, that is
long relative to the girth of its base, or that is reached through a narrow place, like a wheel on
an axle. A limb may have limbs of its own. Arcs that leave a joint side by side are merged up to the
point where they separate. Arcs are straight in the ball around a joint, smooth and centered
elsewhere, and straight in plates. All steps use a frame that depends on the shape only. The
position and orientation of the mesh and the numbering of its elements change the result by rounding
only, unless the mesh is symmetric or nearly symmetric.

The running time is that of `handle_tunnel_loops()` plus \f$ O(n + m \log n) \f$ for
\f$ n \f$ faces and \f$ m \f$ samples; \f$ m \f$ is at most some tens of thousands, for any
\f$ n \f$.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag`, `Parallel_if_available_tag`, `Cuda_tag` and
  `Cuda_if_available_tag`. The CUDA tags apply to the computation of the handle loops only. The
  result does not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam Graph `Curve_skeleton<TriangleMesh, Point>`, where `Point` is the value type of the vertex
  point map; or the graph type that `extract_mean_curvature_flow_skeleton()` fills, whose vertices
  have the properties `point` and `vertices`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param skeleton the graph that receives the result; its previous content is replaced
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{skeleton_options}
    \cgalParamDescription{the options of the skeleton}
    \cgalParamType{`Handle_tunnel_loops::Skeleton_options`}
    \cgalParamDefault{a default-constructed object}
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
    \cgalParamDescription{a property map associating to each face of `tm` a unique index; the
      certificate identifies faces by it}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a function that is called with the progress of the computation of the
      loops, from 0 to 1, then with 1 between further steps, and returns `false` to stop}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{an empty function}
    \cgalParamExtra{After a stop, the graph is unchanged.}
  \cgalParamNEnd
  \cgalParamNBegin{solver_options}
    \cgalParamDescription{the options of the computation of the handle loops. The loops are not
      shortened, because any basis suffices}
    \cgalParamType{`Handle_tunnel_loops::Solver_options`}
    \cgalParamDefault{a default-constructed object}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the statistics of the computation, including the certificate

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold triangle
  mesh with finite coordinates
\throws Handle_tunnel_loops::Interrupted_exception if the callback returned `false`
\throws std::invalid_argument if `Skeleton_options::shortest_limb` is negative or not a number

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
  const auto frame = impl::put_into_own_frame(execution, surface, places);
  impl::Loop_request request = impl::loop_request(
      choose_parameter(get_parameter(np, internal_np::solver_options), Solver_options()));
  request.passes.do_tighten = request.classes.do_shorten = false; // any basis will do
  request.classes.do_link = true;                                 // which of them are handle loops
  request.make_passes = &impl::make_passes<ConcurrencyTag>;
  const std::function<bool(double)> callback =
      choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>());
  const std::vector<impl::Flat_pair> pairs = impl::loops_on_arrays(
      execution, surface.mesh, surface.coordinates(execution), std::move(request), callback);
  statistics.seconds_of_loops = seconds_since(began);

  const auto has_loops = Clock::now();
  std::string taken_alone = impl::join_components_of_solids(execution, surface.mesh, places);
  impl::Found_skeleton found =
      impl::find_skeleton(execution, surface.mesh, *frame, places, pairs, options,
                          impl::face_numbers(surface, face_index), [&callback] {
                            if(callback && !callback(1.))
                              throw Interrupted_exception();
                          });
  statistics.number_of_balls = found.number_of_balls;
  statistics.certificate = std::move(found.certificate);
  statistics.certificate.taken_alone = std::move(taken_alone);
  impl::convert_skeleton(surface, found, skeleton);
  statistics.seconds_of_skeleton = seconds_since(has_loops);
  return statistics;
}

} // namespace CGAL

#endif // CGAL_CURVE_SKELETON_H
