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

The constants of the phase field. The defaults are those of section 3 of the paper. Times are in the
unit of the equation of the paper, and lengths in local edge lengths.

The front is a cosine profile of a width of about \f$ \pi\,a/\sqrt{2w} \f$ edges. It moves by
\f$ \mu e a / (2 \sqrt{2 w}) \f$ edges per unit of time. It moves only if `driving_force` is
positive, and it is smooth only if it is a few edges wide; the defaults give five edges. A smaller
time step increases the number of steps and the running time in proportion.
*/
struct Field_constants
{
  double mobility = 1. / 4.;              ///< the mobility \f$ \mu > 0 \f$
  double driving_force = 1. / 30.;        ///< the driving force \f$ e > 0 \f$
  double gradient_coefficient = 1. / 25.; ///< the coefficient \f$ a^2 > 0 \f$
  double penalty = 1. / 125.;             ///< the penalty \f$ w > 0 \f$, with \f$ e > w \f$
  double step = 1.0; ///< the time step in [1/1024, 1], as a fraction of the largest stable one
};

/*!
\ingroup PkgHandleTunnelLoopsRef

The rules of the paper that the reference solver replaces by default, because they do not work on
all meshes. It follows each rule literally that you set here, and throws
`Literal_failure_exception` if such a rule finds no result. By default, no rule is set.
*/
struct Literal_rules
{
  /// section 3, "the standard linear finite element approximation": the Laplacian uses cotangent
  /// weights and a diagonal mass matrix. Lengths are in mean edge lengths. By default, the
  /// Laplacian is the mean of the neighbors minus the value; its weights are positive on any mesh.
  bool finite_elements = false;

  /// section 3, "gradient energy coefficients are set to 1/25": \f$ a = 1/25 \f$, so
  /// \f$ a^2 = 1/625 \f$ and a front is one edge wide. By default, \f$ a^2 = 1/25 \f$ and a front
  /// is five edges wide. The other `Field_constants` keep their values.
  bool gradient_coefficient = false;

  /// sections 4.1 and 5: fronts are components of the triangles of a band. A front has split if
  /// there are several components, and fronts merge if they have values at the same vertex. By
  /// default, fronts are boundary curves of the covered region, and they split and merge at
  /// vertices.
  bool bands = false;

  /// section 4.2: the field that looks for a tunnel loop is restricted to the region that was
  /// covered when its handle was found. By default, the handle loops found later are barriers.
  bool covered_area = false;

  /// sections 4.2 and 4.3: the streamline from the first point reached is used, whatever it
  /// crosses. By default, the shortest of several streamlines with the required crossings is used.
  bool first_reached = false;

  /// section 4.3: a refined handle loop is always used. By default, it is used if it is shorter and
  /// the loops remain a basis.
  bool refined_always = false;

  /// section 4.5: handle and tunnel loops are distinguished by "slightly offsetting" them along the
  /// normals and "checking the changes" of their lengths. By default, linking numbers distinguish
  /// them, or, if these are not computed, the derivative of the length by the offset. Either takes
  /// precedence over this rule, so set `Solver_options::do_compute_linking` to `false` to use it.
  bool finite_offset = false;

  /// the mean edge length in the unit of the paper, which does not state it; used by
  /// `gradient_coefficient`. With 1/5 the front is as wide as by default; with 1 it stalls.
  double mean_edge_length = 1. / 5.;

  /// the value above which a vertex is in the band of a layer; the paper has "a given threshold".
  double band_threshold = 0.3;

  /// the value above which a layer is present at a vertex, where it can merge with others; it is 0
  /// in the paper.
  double contact_threshold = 0.;

  /// the offset of the loops in mean edge lengths; the paper has "slightly".
  double offset = 0.1;

  /// Returns the rules with all of them set.
  static Literal_rules all() { return {true, true, true, true, true, true, true}; }

  /// Returns whether a rule that changes the fields is set. If such fields stall, there is no
  /// result.
  bool are_of_fields() const { return finite_elements || gradient_coefficient || bands; }

  /// Returns whether any rule is set.
  bool any() const {
    return are_of_fields() || covered_area || first_reached || refined_always || finite_offset;
  }
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The number of vertices from which a device is used (200,000 faces). A device takes some tenths
/// of a second to start; the processor finishes smaller meshes in this time.
constexpr std::size_t least_vertices_for_device = 100000;

/*!
\ingroup PkgHandleTunnelLoopsRef

The device and the stream of a computation with `Cuda_tag` or `Cuda_if_available_tag`.
*/
struct Device_options
{
  /// the number of the device; negative for the current device of the calling thread.
  int device = -1;
  /// the `cudaStream_t`, which must belong to that device, for all work on the device; null to use
  /// a new stream.
  void* stream = nullptr;
  /// the minimal number of vertices from which `Cuda_if_available_tag` uses the device; `Cuda_tag`
  /// ignores it. The number is that of the mesh on which the fields are computed, which is the
  /// coarse mesh if there is one.
  std::size_t least_vertices = least_vertices_for_device;
};

/*!
\ingroup PkgHandleTunnelLoopsRef

The options of the computation of loops and of the fields of Reeb graphs: the value of the named
parameter `solver_options`. Each function documents which of the options it uses.
*/
struct Solver_options
{
  /// the constants of the phase field; the defaults are those of the paper.
  Field_constants field_constants;

  /// the rules of the paper that `Reference_tag` follows literally. Other tags ignore them, except
  /// `Literal_rules::finite_offset`.
  Literal_rules literal_rules;

  /// the device and the stream for `Cuda_tag` and `Cuda_if_available_tag`; by default the current
  /// device and a new stream.
  Device_options device;

  /// whether to run the refinement pass.
  bool do_refine_handles = true;

  /// whether to tighten the loops in their homotopy classes and to look for shorter loops.
  bool do_tighten = true;

  /// whether to find the loops on a coarse mesh of the same topology, if this gives results of the
  /// same quality, and to shorten them on the mesh itself. A coarse mesh is never used with
  /// `Reference_tag`, nor if `do_tighten` is `false`, except for the loops at which the diffusion
  /// of a Reeb graph starts.
  bool do_coarsen = true;

  /// the effort of the search for shorter loops in other classes, in [0, 1000], as a multiple of
  /// the default number of visited vertices. The effort affects the result. It does not depend on
  /// time, so results are reproducible.
  double search_effort = 1.;

  /// whether to compute linking numbers, which distinguish handle loops from tunnel loops. If
  /// `false`, the growth of the loops along the normals distinguishes them, the sides on which
  /// loops bound remain undecided, and no loop is replaced by one that bounds.
  bool do_compute_linking = true;

  /// whether to fill `Statistics::front_events`, which `Handle_tunnel_loops_solver::statistics()`
  /// returns. `Reference_tag` always fills it if there are handles.
  bool do_log_fronts = false;
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_SOLVER_OPTIONS_H
