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
#include <CGAL/Handle_tunnel_loops/internal/surgery/Handle_remover.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

removes handles from a surface, and leaves the rest of it as it is: the topological noise of
scans and segmentations, say.

Each handle is removed in the way that changes the shape least, of those that the method allows:

- A handle that sits on the surface like a knob on a lid, with faces around it that all look the
same way, is *taken out whole*: one disc takes the place of its surroundings, and no stumps are
left.
- A *bore* with a mouth in a plane is closed at its mouths, there exactly in the plane, and so is a
  counterbore. Bores that meet are closed together, if all of them are to be removed.
- Along its handle loop a handle is *cut* into two ends that are closed in the solid, along its
tunnel loop its hole is *filled*: faces are divided beside the loop, which leaves the shape as it
is, a narrow strip is taken out, and a membrane put in on either side. The loop along which the
volume changes less is the one; if it is about the same, that with the smaller and rounder disc.
- If no membranes fit, rings of faces around a loop are taken out, or around both loops; their caps
are refined to the density of the mesh around them and made smooth with it.

What is no repair is not done, whether the topology is right or not: the report says how the shape
has changed where each handle was, see `Shape_change`. A way is left for another one if the bounding
box would grow; if a fill would take solid away, or a cut add some, of more than 1e-9 of the volume;
if a cap would have more than 3 times the area of a circle as long as its rim; if new faces would be
folded by more than 120 degrees where there was no such fold, or a membrane meet the surface at less
than 30; if a cap would be further from the old surface than half the length of the loop (but for
bores whose mouths are closed flush), or surface be taken away with solid that is as far from the
caps. If there is no other way, the handle is refused, with the number in the reason;
`Removal_options::force` allows all this.

It is a theorem that the genus is one less for each handle that is removed, and that no piece comes
off: strips are annuli along loops that do not separate the surface, both found by counting. The
result is counted once more before it is written. It is oriented and manifold, with the boundary
that it had, and it has
*no intersection that was not there before*: caps are checked by exact predicates against the whole
surface and each other (coordinates are taken as doubles for that; those of an exact kernel are
rounded). If nothing fits, the handle is *refused*: the report says why, and it stays as it was.
What was refused is tried again after others were removed, and before them. No larger handle takes
its place. Vertices and faces outside of what is replaced are not touched: they are the same
descriptors, with all that property maps say of them.

Handles are removed in order of their sizes: the size of a handle is the length of the loop that is
tried first. Which ones is said by the parameters; those that fulfil all conditions are removed, all
of them if there is none. A loop across which another handle has been removed is led around it, so
that it is the loop of a handle still. Where that makes it much longer, or where the handle cannot
be removed along it, another loop near it is taken, at most half as long again, that does not
separate the surface (unless handles are only to be cut, or only filled: which of these it will be
is not known before); else the loops are found anew on the surface as it is, and those that lie
where the loops of the handle did are taken.

*Necks* are removed if a maximal length of theirs is given: loops that separate the surface, around
the last one of the bridges that join two shells, or through the last one of the holes that join an
outer and an inner wall, once the handles shorter than that are gone. The shells come apart. All
necks that are found are simple, disjoint and separate the surface, which is counted; that all are
found is likely, and not certain. With `Removal_options::only_channels`, handles and necks are
removed only where an inner wall comes off an outer one by that: what was removed elsewhere stays,
which is found by trying.

Time is that of finding the loops, if they are not given, and near linear in the size of the mesh
and of the caps; for each round in which loops are to be found anew, that is added. Beyond the mesh,
memory is 120 bytes per face, and 300 where loops are found anew.

Caps are made smooth only where the program is compiled with \eigen (`CGAL_EIGEN3_ENABLED`); they
are refined and plane otherwise.

\tparam ConcurrencyTag enables sequential versus parallel computation; possible values are
  `Sequential_tag` (the default), `Parallel_tag` and `Parallel_if_available_tag`. The result is the
  same.
\tparam TriangleMesh a model of `FaceListGraph` and `MutableFaceGraph`, a triangle mesh with or
  without boundary
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{removal_options}
    \cgalParamDescription{which handles and necks are removed, and how}
    \cgalParamType{`Handle_tunnel_loops::Removal_options`}
    \cgalParamDefault{all handles, and no necks}
  \cgalParamNEnd
  \cgalParamNBegin{filter}
    \cgalParamDescription{only handles are removed of which this is true}
    \cgalParamType{a function that takes a `Handle_tunnel_pair` and returns a `bool`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{known_loops}
    \cgalParamDescription{the loops of all handles, or of some, if they have been found already:
      these are the handles there are to choose from}
    \cgalParamType{a range of `Handle_tunnel_pair`}
    \cgalParamDefault{they are found}
  \cgalParamNEnd
  \cgalParamNBegin{dry_run}
    \cgalParamDescription{whether all is computed and nothing is written to the mesh}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{face_output_iterator}
    \cgalParamDescription{is told the faces that the mesh did not have before}
    \cgalParamType{a model of `OutputIterator` that accepts face descriptors}
    \cgalParamDefault{`Emptyset_iterator`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_output_iterator}
    \cgalParamDescription{is told the vertices that the mesh did not have before}
    \cgalParamType{a model of `OutputIterator` that accepts vertex descriptors}
    \cgalParamDefault{`Emptyset_iterator`}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{is told for each face that the mesh did not have before for which handle
      it was made, a cap or a part of a face at its rim: the place in `Removal_report::removed`, or,
      for necks, that in `Removal_report::removed_necks` plus the size of the former. For handles
      that were removed together it is the first of them: `Removed_handle::patch` tells it}
    \cgalParamType{a class model of `WritablePropertyMap` with face descriptors as key type and a
      number as value type, that takes faces that are new}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{face_to_face_map}
    \cgalParamDescription{is told for each face that is a part of one that the mesh had before, as
      there are at the rims of caps, which one that was. The mesh may not have that any more: it
      says where colours, say, come from, and its number is right as long as garbage is not
      collected}
    \cgalParamType{a class model of `WritablePropertyMap` with the faces of `tm` as keys and as
      values}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \cgalParamNBegin{output_iterator}
    \cgalParamDescription{is told the loops of the handles that are left, as `handle_tunnel_loops()`
      finds them on the mesh once handles are removed, in the time that this takes and without
      asking the callback. That is not done in a dry run}
    \cgalParamType{a model of `OutputIterator` that accepts `Handle_tunnel_pair`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{is told the progress, from 0 to 1, and asks to stop by returning `false`}
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

\return what was removed, and what was refused

\throws Handle_tunnel_loops::Invalid_mesh_exception if `tm` is not an oriented 2-manifold
  triangle mesh with finite coordinates; the message names an element
\throws Handle_tunnel_loops::Interrupted_exception if the callback asked to stop
\throws std::invalid_argument if the target is above the genus, no loop lies in the box, the pairs
  are not of this mesh, or a length, a share or a range of diameters is not valid
\throws std::logic_error if the result is not what it should be, which is a defect of the package

Whatever is thrown, the mesh is as it was; but for what is thrown by the maps and output iterators
of the caller, and when the remaining pairs are found.

\sa `handle_tunnel_loops()`
\sa `cut_to_disk()`
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters>
Handle_tunnel_loops::Removal_report
remove_handles(TriangleMesh& tm, const NamedParameters& np = parameters::default_values()) {
  return Handle_tunnel_loops::internal::Handle_remover<ConcurrencyTag, TriangleMesh,
                                                       NamedParameters>(tm, np)();
}

} // namespace CGAL

#endif // CGAL_REMOVE_HANDLES_H
