// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_SOLVER_OPTIONS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_SOLVER_OPTIONS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstddef>

namespace CGAL::Handle_tunnel_loops {

/*!
\ingroup PkgHandleTunnelLoopsRef

The constants of the phase field; the defaults are those of the paper, section 3. Times are in the
unit of the paper's equation, lengths in local edge lengths.

The front is a cosine about \f$ \pi\,a/\sqrt{2w} \f$ edges wide and moves
\f$ \mu e a / (2 \sqrt{2 w}) \f$ edges per unit of time. It needs `driving_force > 0` to move and a
width of a few edges to be smooth: the defaults give five. A smaller step takes as many more of
them, and as much more time.
*/
struct Field_constants
{
  double mobility = 1. / 4.;              ///< \f$ \mu > 0 \f$
  double driving_force = 1. / 30.;        ///< \f$ e > 0 \f$
  double gradient_coefficient = 1. / 25.; ///< \f$ a^2 > 0 \f$
  double penalty = 1. / 125.;             ///< \f$ w > 0 \f$, with \f$ e > w \f$
  double step = 1.0; ///< time step, in [1/1024, 1], as a fraction of the largest stable one
};

/*!
\ingroup PkgHandleTunnelLoopsRef

Rules of the paper in whose place the reference solver has others, which hold on any mesh. It
follows those to the letter that are set here, and throws `Literal_failure_exception` where a rule
leads nowhere. None is set by default.
*/
struct Literal_rules
{
  /// section 3, "the standard linear finite element approximation": the Laplacian has cotangents as
  /// weights, with a diagonal matrix of masses. Lengths are in mean edge lengths. By default it is
  /// the mean of the neighbors less the value, whose weights are positive on any mesh.
  bool finite_elements = false;

  /// section 3, "gradient energy coefficients are set to 1/25": \f$ a = 1/25 \f$, so that
  /// \f$ a^2 = 1/625 \f$, and a front is one edge wide. By default \f$ a^2 = 1/25 \f$, and it is
  /// five edges wide. `Field_constants` are as they are given otherwise.
  bool gradient_coefficient = false;

  /// sections 4.1 and 5: fronts are components of the triangles of a band, a front has split where
  /// there are several, and fronts meet that have values at the same vertex. By default fronts are
  /// boundary curves of what is covered, and split and meet at vertices.
  bool bands = false;

  /// section 4.2: the field that looks for a tunnel is restricted to what was covered when its
  /// handle was found. By default the handles that were found later are walls.
  bool covered_area = false;

  /// sections 4.2 and 4.3: the streamline from the first point reached is taken, whatever it
  /// crosses. By default the shortest of several is, that crosses what it should.
  bool first_reached = false;

  /// section 4.3: a refined handle is always taken. By default it is if it is shorter and the loops
  /// remain a basis.
  bool refined_always = false;

  /// section 4.5: loops are told apart by "slightly offsetting" them along the normals and
  /// "checking the changes" of their lengths. By default linking numbers name them, or, without
  /// these, the derivative of the length by the offset, which name them before this rule does: it
  /// is for use without `Solver_options::do_compute_linking`.
  bool finite_offset = false;

  /// the mean edge length in the unit of the paper, which it does not tell, for
  /// `gradient_coefficient`: with 1/5 the front is as wide as by default, with 1 it comes to rest.
  double mean_edge_length = 1. / 5.;

  /// the value above which a vertex is in the band of a layer; the paper has "a given threshold".
  double band_threshold = 0.3;

  /// the value above which a layer is at a vertex, so that it meets others there; that of the paper
  /// is 0.
  double contact_threshold = 0.;

  /// by how many mean edge lengths loops are moved; the paper has "slightly".
  double offset = 0.1;

  /// all of them.
  static Literal_rules all() { return {true, true, true, true, true, true, true}; }

  /// whether the fields are others than by default; where they come to rest there is no answer.
  bool are_of_fields() const { return finite_elements || gradient_coefficient || bands; }

  /// whether one is set.
  bool any() const {
    return are_of_fields() || covered_area || first_reached || refined_always || finite_offset;
  }
};

/// \ingroup PkgHandleTunnelLoopsRef
/// From so many vertices on (200,000 faces) a device pays: to start one takes some tenths of a
/// second, in which the processor is done with a smaller mesh.
constexpr std::size_t least_vertices_for_device = 100000;

/*!
\ingroup PkgHandleTunnelLoopsRef

Where on which CUDA device a computation with `Cuda_tag` or `Cuda_if_available_tag` runs.
*/
struct Device_options
{
  /// the number of the device; negative for the current one of the calling thread.
  int device = -1;
  /// the `cudaStream_t` on which all work of the device is done, and which belongs to that device;
  /// null for a stream of its own.
  void* stream = nullptr;
  /// a mesh with fewer vertices is left to the processor by `Cuda_if_available_tag`; `Cuda_tag`
  /// does not look at it. What counts is the mesh that the fields are on: a coarse one, if there
  /// is.
  std::size_t least_vertices = least_vertices_for_device;
};

/*!
\ingroup PkgHandleTunnelLoopsRef

How loops are found, and the fields of Reeb graphs: the value of the named parameter
`solver_options`. Each function says which of the options it looks at.
*/
struct Solver_options
{
  /// the constants of the phase field; by default those of the paper.
  Field_constants field_constants;

  /// which rules of the paper `Reference_tag` is to follow to the letter; other tags do not look at
  /// them, but for `Literal_rules::finite_offset`.
  Literal_rules literal_rules;

  /// the device and the stream to use with `Cuda_tag` and `Cuda_if_available_tag`; by default the
  /// current device, and a stream of its own.
  Device_options device;

  /// whether to run the refinement pass.
  bool do_refine_handles = true;

  /// whether to tighten the loops in their homotopy classes, and to look for shorter ones.
  bool do_tighten = true;

  /// whether loops are found on a coarse mesh of the same topology where that is as good, and made
  /// short on the mesh itself. Without `do_tighten` loops are found on the mesh itself, but for
  /// those that a Reeb graph starts from; with `Reference_tag` always.
  bool do_coarsen = true;

  /// how long to look for shorter loops in other classes, in [0, 1000]: as a multiple of the number
  /// of vertices that are visited by default. The answer depends on it, but on no clock.
  double search_effort = 1.;

  /// whether linking numbers tell handles from tunnels; otherwise the growth along the normals
  /// does, it is not known which loops bound inside and outside, and none are replaced by others
  /// that do.
  bool do_compute_linking = true;

  /// whether `Statistics::front_events` is filled, which `Handle_tunnel_loops_solver::statistics()`
  /// returns; `Reference_tag` always does, where there are handles.
  bool do_log_fronts = false;
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_SOLVER_OPTIONS_H
