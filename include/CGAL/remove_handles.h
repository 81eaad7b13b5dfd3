// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_REMOVE_HANDLES_H
#define CGAL_REMOVE_HANDLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Removal_report.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Mesh_link.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/removal.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops_solver.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/iterator.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

Removes handles from a surface and leaves the rest of it unchanged, for example to remove the
topological noise of scans and segmentations.

Each handle is removed in the allowed way that changes the shape least:

- *Take out.* A handle that protrudes from a nearly flat region, where all faces around it have
  similar normals, is taken out as a whole: one disk replaces it and its surroundings. No stumps
  remain.
- *Close a bore.* A bore with a mouth in a plane is closed at its mouths, exactly in the plane. The
  same holds for a counterbore. Bores that meet are closed together if all of them are to be
  removed.
- *Cut or fill.* Along its handle loop, a handle is cut into two ends, which are closed inside the
  solid. Along its tunnel loop, its hole is filled. In both cases, the faces beside the loop are
  divided, which does not change the shape, a narrow strip is removed, and a membrane is inserted on
  either side. The function uses the loop along which the volume changes less. If both changes are
  about equal, it uses the loop with the smaller and rounder disk.
- *Remove rings.* If no membranes fit, rings of faces around one loop or around both loops are
  removed. The caps are refined to the density of the mesh around them and smoothed.

A removal that is not a valid repair is not done, even if its topology is right. The report
describes how the shape has changed at each handle (`Shape_change`). A way of removal is rejected if
one of these conditions holds:

- The bounding box would grow.
- The surface is closed, and a fill would remove solid, or a cut would add solid, of more than 1e-9
  of the volume of the solid.
- A cap would have more than 3 times the area of a circle whose circumference is the length of its
  rim.
- New faces would be folded by more than 120 degrees where there was no such fold, or a membrane
  would meet the surface at an angle below 30 degrees.
- A cap would be farther from the old surface than half the length of the loop (except for bores
  whose mouths are closed flush), or surface that is removed together with solid would be as far
  from the caps.
- More pairs of faces would intersect than before.

If no way remains, the handle is refused, and the reason includes the value that exceeded its limit.
Set `Removal_options::force` to skip these conditions. `Shape_change::crossings` is then how many
more pairs of faces intersect.

The removal of each handle reduces the genus by exactly one and splits off no component. This is a
theorem: the removed strips are annuli along loops that do not separate the surface, and both
properties are checked by counting. The genus of the result is counted again before anything is
written. The result is oriented and manifold, and it has the boundary of the input. *It does not
intersect itself where the input did not*: exact predicates test the caps against the whole surface
and against each other. Where the input does, caps may intersect what the faces that they replace
have intersected, but nothing else, and, unless forced, in no more pairs of faces. (The parts of
faces that are divided along a loop count as one.) Coordinates are taken as doubles for these tests
(coordinates of an exact kernel are rounded). If no way of removal fits, the handle is *refused*:
the report gives the reason, and the handle stays as it was. Before that, as long as some handles
are removed and others are not, the loops of the surface are computed anew and those that are left
are tried along them, as in a call for the result: a second call for all handles removes nothing
more. (On surfaces with boundary, new loops may avoid the boundary in another way, so this is not
guaranteed.) Refused handles are also tried before the others. Ways of removal that nearly always
fail on a surface, because it crosses itself everywhere, are not tried for all handles. No larger
handle is removed in place of a refused one. Vertices and faces outside the replaced parts keep
their descriptors and their values in property maps.

Handles are removed in order of their sizes. The size of a handle is the length of the loop that is
tried first. The parameters select the handles: a handle is removed if it satisfies all conditions,
and without conditions all handles are removed. If a handle was removed that lies across the loop of
another one, this loop is rerouted around the caps and remains a loop of its handle. If it would
become much longer, or if the handle cannot be removed along it, the function uses a nearby loop
that does not separate the surface and has at most twice the length. It does not do so if the
method is `Removal_method::CUT` or `Removal_method::FILL`, because it is not known in advance which
of the two the removal will be.

If you set `Removal_options::maximal_neck_length`, *necks* are removed. A neck is a loop that
separates the surface: it goes around the last of the bridges that join two shells, or through the
last of the holes that join an outer and an inner wall, after the shorter handles have been removed.
The shells become separate components. All necks that are found are simple, disjoint and separate
the surface, which is checked by counting. The function usually finds all necks, but this is not
guaranteed. With `Removal_options::only_channels`, handles and necks are removed only where this
separates an inner wall from an outer wall. The function finds out by trying, and leaves all other
handles and necks as they are.

The running time is that of finding the loops, unless you pass them, and near linear in the size of
the mesh and of the caps. Each further computation of the loops adds its time. Besides the mesh, the
memory is 120 bytes per face, and 300 bytes per face if the loops are computed again.

Caps are smoothed only if the library is compiled with \eigen. Otherwise they are refined and
planar.

\tparam ConcurrencyTag enables sequential versus parallel computation. Possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result does
  not depend on the tag.
\tparam TriangleMesh a model of `FaceListGraph` and `MutableFaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm a triangle mesh with or without boundary; the function modifies it
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{removal_options}
    \cgalParamDescription{the options that select the handles and necks to remove, and the method}
    \cgalParamType{`Handle_tunnel_loops::Removal_options`}
    \cgalParamDefault{all handles are removed, and no necks}
  \cgalParamNEnd
  \cgalParamNBegin{filter}
    \cgalParamDescription{a predicate; only handles for which it returns `true` are removed}
    \cgalParamType{a function that takes a `Handle_tunnel_pair` and returns a `bool`}
    \cgalParamDefault{no further condition}
  \cgalParamNEnd
  \cgalParamNBegin{known_loops}
    \cgalParamDescription{pairs of loops that have been computed already, for all or some of the
      handles. The handles to remove are selected among these}
    \cgalParamType{a range of `Handle_tunnel_pair`}
    \cgalParamDefault{all pairs are computed}
  \cgalParamNEnd
  \cgalParamNBegin{dry_run}
    \cgalParamDescription{whether to compute the report without changing the mesh}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{face_output_iterator}
    \cgalParamDescription{an output iterator that receives the new faces of the mesh}
    \cgalParamType{a model of `OutputIterator` that accepts face descriptors}
    \cgalParamDefault{`Emptyset_iterator`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_output_iterator}
    \cgalParamDescription{an output iterator that receives the new vertices of the mesh}
    \cgalParamType{a model of `OutputIterator` that accepts vertex descriptors}
    \cgalParamDefault{`Emptyset_iterator`}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{receives, for each new face (of a cap, or a part of a face at the rim of a
      cap), the number of the removal that it belongs to. This number is the position in
      `Removal_report::removed` or, for a neck, the position in `Removal_report::removed_necks` plus
      the size of `Removal_report::removed`. For handles that were removed together, it is the
      position of the first one, which is `Removed_handle::patch`}
    \cgalParamType{a class model of `WritablePropertyMap` with face descriptors as keys and a number
      type as value type. It must accept new faces}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{face_to_face_map}
    \cgalParamDescription{receives, for each new face that is a part of an old face, this old face.
      Such parts lie at the rims of caps. Use the map to transfer attributes such as colors. The
      old face may no longer be in the mesh; its index is valid until garbage is collected}
    \cgalParamType{a class model of `WritablePropertyMap` with the faces of `tm` as keys and as
      values}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \cgalParamNBegin{output_iterator}
    \cgalParamDescription{an output iterator that receives the pairs of loops of the remaining
      handles. `handle_tunnel_loops()` computes them on the resulting mesh, which adds its running
      time and does not call the callback. With `dry_run`, nothing is written}
    \cgalParamType{a model of `OutputIterator` that accepts `Handle_tunnel_pair`}
    \cgalParamDefault{the remaining pairs are not computed}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a function that is called with the progress, from 0 to 1, and returns
      `false` to stop the computation}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{an empty function}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadWritePropertyMap`}
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
\cgalNamedParamsEnd

\return a report of what was removed and what was refused

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold
  triangle mesh with finite coordinates; the message names an element
\throws Handle_tunnel_loops::Interrupted_exception if the callback returned `false`
\throws std::invalid_argument if the target genus exceeds the genus, no loop lies in
  `Removal_options::box`, the given pairs do not belong to this mesh, or a length, an area share or
  a range of diameters is not valid
\throws std::logic_error if the result fails its check, which indicates a defect of the package

If an exception is thrown, the mesh is unchanged. This does not apply to exceptions of the property
maps and output iterators that you pass, and to exceptions during the computation of the remaining
pairs.

\sa `handle_tunnel_loops()`
\sa `cut_to_disk()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters>
Handle_tunnel_loops::Removal_report
remove_handles(TriangleMesh& tm, const NamedParameters& np = parameters::default_values()) {
  using namespace Handle_tunnel_loops;
  namespace impl = Handle_tunnel_loops::internal;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  using Const_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using Geom_traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
  using Solver = Handle_tunnel_loops_solver<TriangleMesh, Const_point_map, Geom_traits>;
  using Pair = typename Solver::Pair;
  constexpr impl::Execution execution = impl::execution_of<ConcurrencyTag>();
  const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm, np);
  const auto face_index = CGAL::get_initialized_face_index_map(tm, np);
  const auto point = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                      get_property_map(vertex_point, tm));
  const auto callback =
      choose_parameter(get_parameter(np, internal_np::callback), std::function<bool(double)>());
  impl::Removal_request request;
  request.options =
      choose_parameter(get_parameter(np, internal_np::removal_options), Removal_options());
  request.callback = callback;

  std::vector<Pair> pairs;
  { // the solver checks the mesh, whoever finds the loops
    Solver solver(ConcurrencyTag(), tm, np);
    request.genus = solver.genus();
    request.components = solver.number_of_components();
    if constexpr(!is_default_parameter<NamedParameters, internal_np::known_loops_t>::value) {
      const auto& known = get_parameter(np, internal_np::known_loops);
      pairs.assign(known.begin(), known.end());
      request.are_loops_of_caller = true;
    } else
      solver.template find_loops<ConcurrencyTag>(
          std::back_inserter(pairs),
          parameters::callback(std::function<bool(double)>(
              [&](double done) { return !callback || callback(0.7 * done); })));
  }
  for(const Pair& pair : pairs)
    request.handles.push_back(impl::choice_of_handle(pair, tm, vertex_index, request.options.box));
  if constexpr(!is_default_parameter<NamedParameters, internal_np::filter_t>::value)
    request.filter = [&](std::size_t i) {
      return get_parameter(np, internal_np::filter)(pairs[i]);
    };
  const impl::Triangle_reader<TriangleMesh, std::decay_t<decltype(face_index)>> reader(tm,
                                                                                       face_index);
  impl::Mesh_link<TriangleMesh, std::decay_t<decltype(point)>> link(tm, point, vertex_index,
                                                                    reader);
  const impl::Removal_result result =
      impl::removal_of_handles(execution, reader.read(execution, vertex_index, point), request);
  if(choose_parameter(get_parameter(np, internal_np::dry_run), false))
    return result.report;

  auto vertices =
      choose_parameter(get_parameter(np, internal_np::vertex_output_iterator), Emptyset_iterator());
  auto faces =
      choose_parameter(get_parameter(np, internal_np::face_output_iterator), Emptyset_iterator());
  link.write_back(
      result.change, [&](auto v) { *vertices++ = v; },
      [&]([[maybe_unused]] const impl::Mesh_change::New_face& face, auto f) {
        *faces++ = f;
        if constexpr(!is_default_parameter<NamedParameters, internal_np::face_patch_t>::value)
          put(get_parameter(np, internal_np::face_patch), f, face.patch);
        if constexpr(!is_default_parameter<NamedParameters, internal_np::face_to_face_map_t>::value)
          if(face.origin != impl::no_index)
            put(get_parameter(np, internal_np::face_to_face_map), f, link.face_read(face.origin));
      });
  // With no index maps of the caller, which know the mesh as it was.
  if constexpr(!is_default_parameter<NamedParameters, internal_np::output_iterator_t>::value) {
    const auto traits = choose_parameter<Geom_traits>(get_parameter(np, internal_np::geom_traits));
    const Const_point_map point_now = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                                       get_const_property_map(vertex_point, tm));
    Solver solver(ConcurrencyTag(), tm,
                  parameters::vertex_point_map(point_now).geom_traits(traits));
    solver.template find_loops<ConcurrencyTag>(get_parameter(np, internal_np::output_iterator));
  }
  return result.report;
}

} // namespace CGAL

#endif // CGAL_REMOVE_HANDLES_H
