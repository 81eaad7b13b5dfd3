// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>
#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/certificate.h>
#include <CGAL/Handle_tunnel_loops/compare_lengths.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops/stages.h>
#include <CGAL/Handle_tunnel_loops_solver.h>

/// \file handle_tunnel_loops.h
/// Includes all that finds, describes and certifies handle and tunnel loops. It does not include
/// `CGAL/reeb_graph.h`, nor `CGAL/Handle_tunnel_loops/Reference_tag.h`, which needs Eigen.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

computes, for a surface of genus g, g handle loops and g tunnel loops: short closed curves
that form a basis of the first homology group over the integers, in pairs that cross once. This is
proved for every answer, by a method of its own, before it is returned
(`certify_handle_tunnel_loops()`, which says what is independent of what).

On components that neither touch nor cross themselves or others, each handle loop bounds a surface
inside its component, and each tunnel loop one outside of it, as if there were no other component
(`Handle_tunnel_loops::Loop_linking::bounds_inside_component`). With the others there, a loop bounds
exactly if it is linked with none of them. The parameter `basis_kind` asks for the shortest basis
instead, whatever sides its loops bound on, if on any.

The method follows \cgalCite{weinrauch2023variational}: a phase field grows from one vertex over the
surface; where two of its fronts meet there is a handle (section 4.1). A field from one side of that
front to the other finds the tunnel (4.2), a field from one side of the tunnel to the other a better
handle (4.3). The loops are then tightened in their homotopy classes, and looked for once more by
lengths of edges, since the fields only count these. By their linking numbers, and in integers,
those that bound on neither side are replaced by others that do; then shorter loops are looked for
in all classes that bound, from places along the loops that they have to cross, with a bounded
effort. Loops are short in the end, not shortest. Which loop of a pair is the handle is decided by
linking numbers: it bounds in the solid, or the other one bounds outside of it
(`Handle_tunnel_loops::Loop_linking`). Where these do not tell, it is the loop that grows more when
both are moved along the normals (4.5). Several connected components are treated at once; a
component of genus 0 contributes nothing.

Time is proportional to the size of the mesh, plus the regions that the fields of the handles cover,
plus about a second at most for the search in classes; memory is 69 to 122 bytes per
face (measured with two threads on meshes of a million to ten million faces and genus 1 to 1500; the
more the longer the loops are against the mesh), and 5 to 8 more for each further thread.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag`, `Parallel_if_available_tag`, `Cuda_tag`, and
  `Cuda_if_available_tag`. The result does not depend on it, nor on the number of threads.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam OutputIterator a model of `OutputIterator` that accepts
  `Handle_tunnel_pair<TriangleMesh>`, with the value type of the vertex point map as second argument
  if that is not the mesh's own
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param out the iterator that the pairs are written to
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
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
    \cgalParamDescription{a property map associating to each face of `tm` a unique index}
    \cgalParamType{a class model of `ReadablePropertyMap`}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `Kernel`}
    \cgalParamDefault{a \cgal Kernel deduced from the point type}
  \cgalParamNEnd
  \cgalParamNBegin{seed_vertex}
    \cgalParamDescription{the vertex from which the first field grows, in its component}
    \cgalParamType{`boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{the vertex of smallest index, in each component}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{is told the progress, from 0 to 1, and asks to stop by returning `false`;
      it is called by one thread at a time, not always the same}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{an empty function}
    \cgalParamExtra{After a stop, nothing has been written to `out`.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{the time after which no more shorter loops are looked for in other
      classes, nor loops tightened that come from a coarse mesh or were put together of others, in
      seconds of the wall clock, at least 0. What else there is to do is done, so that the answer is
      certified, and bounds on its sides, as ever: neither the passes nor what makes loops bound is
      cut short, and a basis is ready at any time of the search after them}
    \cgalParamType{`double`}
    \cgalParamDefault{infinity}
    \cgalParamExtra{The time is that of `Handle_tunnel_loops::Statistics::total_seconds()`, with the
      preparation of the mesh. Once it has ended a search, as
      `Handle_tunnel_loops::Statistics::was_ended_by_time` says, the answer may differ from run to
      run, and with the number of threads.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told when a stage begins and ends; copied, unless passed by
      `std::ref()`}
    \cgalParamType{a class model of `HandleTunnelLoopsVisitor`}
    \cgalParamDefault{`Handle_tunnel_loops::Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{solver_options}
    \cgalParamDescription{what is done to find the loops, and how}
    \cgalParamType{`Handle_tunnel_loops::Solver_options`}
    \cgalParamDefault{as that says}
  \cgalParamNEnd
  \cgalParamNBegin{basis_kind}
    \cgalParamDescription{which basis is looked for: `PURE`, of handle loops that bound inside and
      tunnel loops that bound outside of their component; or `SHORTEST`, the shortest loops that are
      a basis, for cutting and parametrization, where sides do not matter. The latter are never
      longer in total than the former. They are paired so that each pair crosses once if that can
      be, or else an odd number of times, counted with sign; that is stated in the certificate, as
      are names and sides, and not required}
    \cgalParamType{`Handle_tunnel_loops::Basis_kind`}
    \cgalParamDefault{`Handle_tunnel_loops::Basis_kind::PURE`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_layer_map}
    \cgalParamDescription{is given, for each vertex that is not isolated, the layer of the front
      that came to it in the initial pass (paper, section 4.1). Layers are numbered from 1 as in
      `Handle_tunnel_loops::Front_event`; a vertex at which fronts part, meet or close is in a
      layer that ends there}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertices of `tm` as keys and
      `std::size_t` as value type}
    \cgalParamDefault{unused}
    \cgalParamExtra{It takes as long as `Handle_tunnel_loops::Solver_options::do_log_fronts`, no
      longer with both, and four bytes per vertex until the loops are found. It is written before
      these are.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_value_map}
    \cgalParamDescription{is given, for each vertex that is not isolated, the time at which the
      front of the initial pass came to it, in steps of the field and parts of them: 0 at the seed,
      and by `Reference_tag` around it}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertices of `tm` as keys and
      `double` as value type}
    \cgalParamDefault{unused}
    \cgalParamExtra{It takes eight bytes per vertex until the loops are found. It is written before
      these are.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last pair written

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold
  triangle mesh with finite coordinates; the message names an element
\throws Handle_tunnel_loops::Interrupted_exception if the callback asked to stop
\throws Handle_tunnel_loops::Uncertified_loops_exception if the answer fails its certificate; that
  is a defect of the package, and nothing has been written
\throws Handle_tunnel_loops::Literal_failure_exception if a literal rule leads nowhere
\throws Handle_tunnel_loops::Device_exception if a CUDA device was asked for, see `Cuda_tag`
\throws std::invalid_argument if the seed vertex, the constants of the field, those of literal
  rules, the effort of the search or its time are not valid

\sa `Handle_tunnel_loops_solver`
\sa `certify_handle_tunnel_loops()`
\sa `compare_lengths()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator handle_tunnel_loops(const TriangleMesh& tm,
                                   OutputIterator out,
                                   const NamedParameters& np = parameters::default_values()) {
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using Geom_traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
  Handle_tunnel_loops_solver<TriangleMesh, Vertex_point_map, Geom_traits> solver(ConcurrencyTag(),
                                                                                 tm, np);
  return solver.template find_loops<ConcurrencyTag>(out, np);
}

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_H
