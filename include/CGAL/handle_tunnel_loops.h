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
/// Includes everything that finds, describes and certifies handle and tunnel loops. It includes
/// neither `CGAL/reeb_graph.h` nor `CGAL/Handle_tunnel_loops/Reference_tag.h`, which needs Eigen.

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Computes g handle loops and g tunnel loops on a surface of genus g. The loops are short closed
curves. They form a basis of the first homology group with integer coefficients, in pairs of one
handle loop and one tunnel loop that cross once. The function certifies this for every result before
it returns, with an independent method (`certify_handle_tunnel_loops()`, which states what is
independent of what).

If the components neither touch nor cross themselves or each other, then each handle loop bounds a
surface inside its component, and each tunnel loop bounds one outside its component, where each
component is considered without the others
(`Handle_tunnel_loops::Loop_linking::bounds_inside_component`). In the presence of the other
components, such a loop bounds if and only if it is linked with none of them. Set the parameter
`basis_kind` to get the shortest basis instead; its loops may bound on either side or on none.

The method follows \cgalCite{weinrauch2023variational}. A phase field grows over the surface from
one vertex, and a handle is found wherever two of its fronts merge (section 4.1). A field that grows
from one side of that front to the other finds the tunnel loop (4.2). A field that grows from one
side of the tunnel loop to the other finds a shorter handle loop (4.3). The loops are then tightened
in their homotopy classes. A search by edge length follows, because the fields count edges only.
Integer linking numbers identify the loops that bound on neither side, and these loops are replaced
by loops that do bound. Finally, a search of bounded effort looks for shorter loops in all classes
that bound, starting from places on the loops that such a loop has to cross. The resulting loops are
short, but not necessarily shortest.

Linking numbers decide which loop of a pair is the handle loop: either it bounds in the solid, or
the other one bounds outside the solid (`Handle_tunnel_loops::Loop_linking`). If linking numbers do
not decide it, the handle loop is the one whose length grows more when both loops are offset along
the normals (4.5). All connected components are processed in one call. A component of genus 0
contributes no loops.

The running time is proportional to the size of the mesh plus the size of the regions that the
fields of the handles cover, plus at most about a second for the search in other classes. The memory
is 80 to 122 bytes per face, and 5 to 8 bytes per face more for each further thread. These figures
were measured with two threads on meshes of one to ten million faces and genus 1 to 1500; longer
loops relative to the mesh need more.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag`, `Parallel_if_available_tag`, `Cuda_tag`, and
  `Cuda_if_available_tag`. The result depends neither on the tag nor on the number of threads.
\tparam TriangleMesh a model of `FaceListGraph`
\tparam OutputIterator a model of `OutputIterator` that accepts
  `Handle_tunnel_pair<TriangleMesh>`, or `Handle_tunnel_pair<TriangleMesh, Point>` if the value type
  `Point` of the vertex point map differs from the point type of the mesh
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary
\param out the output iterator that receives the pairs
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
    \cgalParamDescription{the vertex at which the first field starts, in the component of that
      vertex}
    \cgalParamType{`boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{the vertex of smallest index, in each component}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a function that is called with the progress, from 0 to 1, and returns
      `false` to stop the computation. One thread at a time calls it, but not always the same one}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{an empty function}
    \cgalParamExtra{After a stop, nothing has been written to `out`.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{the wall time in seconds, at least 0, after which the function stops
      looking for shorter loops in other classes, and stops tightening loops that come from a coarse
      mesh or that were combined from others. All other work is completed: the passes, the search
      for short loops that bound where there are many handles, and the replacement of loops that
      do not bound are never cut short. The result is therefore certified and bounds on its sides
      as usual}
    \cgalParamType{`double`}
    \cgalParamDefault{infinity}
    \cgalParamExtra{The time is measured as in `Handle_tunnel_loops::Statistics::total_seconds()`
      and includes the preparation of the mesh. If the limit ended a search
      (`Handle_tunnel_loops::Statistics::was_ended_by_time`), the result may differ between runs
      and with the number of threads.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{a visitor that is called when a stage begins and when it ends. It is
      copied unless you pass it with `std::ref()`}
    \cgalParamType{a class model of `HandleTunnelLoopsVisitor`}
    \cgalParamDefault{`Handle_tunnel_loops::Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{solver_options}
    \cgalParamDescription{the options that select the steps of the computation and the backend}
    \cgalParamType{`Handle_tunnel_loops::Solver_options`}
    \cgalParamDefault{a default-constructed object}
  \cgalParamNEnd
  \cgalParamNBegin{basis_kind}
    \cgalParamDescription{the kind of basis. `PURE` requests handle loops that bound inside their
      component and tunnel loops that bound outside of it. `SHORTEST` requests the shortest loops
      that are a basis, for cutting and parametrization, where sides do not matter; their total
      length never exceeds that of `PURE`. The loops of a shortest basis are paired so that the
      loops of each pair cross once if possible, and otherwise an odd number of times, counted with
      sign. For `SHORTEST`, the certificate reports crossings, names and sides without requiring
      them}
    \cgalParamType{`Handle_tunnel_loops::Basis_kind`}
    \cgalParamDefault{`Handle_tunnel_loops::Basis_kind::PURE`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_layer_map}
    \cgalParamDescription{receives, for each vertex that is not isolated, the layer of the front
      that reached it in the initial pass (paper, section 4.1). Layers are numbered from 1 as in
      `Handle_tunnel_loops::Front_event`. A vertex at which fronts split, merge or close belongs to
      a layer that ends there}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertices of `tm` as keys and
      `std::size_t` as value type}
    \cgalParamDefault{unused}
    \cgalParamExtra{The map costs as much time as
      `Handle_tunnel_loops::Solver_options::do_log_fronts`; both together cost no more than one. It
      needs four bytes per vertex until the loops are found. The function writes the map before it
      writes the loops.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_value_map}
    \cgalParamDescription{receives, for each vertex that is not isolated, the time at which the
      front of the initial pass reached it, in (fractional) steps of the field. The time is 0 at the
      seed; with `Reference_tag`, it is 0 around the seed as well}
    \cgalParamType{a class model of `WritablePropertyMap` with the vertices of `tm` as keys and
      `double` as value type}
    \cgalParamDefault{unused}
    \cgalParamExtra{The map needs eight bytes per vertex until the loops are found. The function
      writes the map before it writes the loops.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `out`, past the last pair written

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold
  triangle mesh with finite coordinates; the message names an element
\throws Handle_tunnel_loops::Interrupted_exception if the callback returned `false`
\throws Handle_tunnel_loops::Uncertified_loops_exception if the result fails its certificate. This
  indicates a defect of the package; nothing has been written
\throws Handle_tunnel_loops::Literal_failure_exception if a rule of literal mode finds no result
\throws Handle_tunnel_loops::Device_exception if `Cuda_tag` was used and the CUDA device failed or
  is missing
\throws std::invalid_argument if the seed vertex, the constants of the field or of the literal
  rules, the search effort, or the maximum running time is not valid

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
