// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_STAGES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_STAGES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Front_event.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// The stages of a computation, in order. The parameters may exclude some of them.
enum class Stage {
  ADAPTOR,     ///< checks the mesh and converts it to arrays
  INITIAL,     ///< the initial pass (paper, section 4.1)
  TUNNEL,      ///< the tunnel pass (paper, section 4.2)
  REFINE,      ///< the handle refinement pass (paper, section 4.3)
  SHORTEN,     ///< tightens all loops and searches for shorter ones by edge length
  CLASSES,     ///< makes the loops bound on their sides and searches for shorter ones that do
  CONVERT,     ///< converts the loops to loops on the caller's mesh
  CERTIFICATE, ///< cuts the mesh along the loops and certifies that they are a basis
  CLASSIFY,    ///< computes linking numbers and names the loops (paper, section 4.5)
  DIFFUSION    ///< the field of a Reeb graph
};

/// The number of stages.
constexpr std::size_t number_of_stages = 10;

/// Returns the name of a stage, as it appears in reports.
inline const char* stage_name(Stage stage) {
  constexpr std::array<const char*, number_of_stages> names = {
      "adaptor", "initial", "tunnel",      "refine",   "shorten",
      "classes", "convert", "certificate", "classify", "diffusion"};
  return names[static_cast<std::size_t>(stage)];
}

/*!
\ingroup PkgHandleTunnelLoopsRef
\cgalModels `HandleTunnelLoopsVisitor`

The default visitor, which does nothing. Derive from it to observe the stages.
*/
struct Default_visitor
{
  /// Called when a stage begins, by the calling thread.
  void start_stage(Stage) const {}
  /// Called when a stage ends, by the calling thread.
  void end_stage(Stage) const {}
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The statistics of a computation: sizes, wall times in seconds, and the use of fallbacks.
struct Statistics
{
  std::size_t number_of_vertices = 0;             ///< mesh vertices that have a face
  std::size_t number_of_faces = 0;                ///< mesh faces
  std::size_t number_of_components = 0;           ///< connected components of the mesh
  std::size_t number_of_boundaries = 0;           ///< boundary curves
  std::size_t genus = 0;                          ///< summed over the components
  std::array<double, number_of_stages> seconds{}; ///< wall time by stage
  std::size_t kept_sweep_tunnels = 0;             ///< tunnel loops kept from the initial pass
  std::size_t kept_sweep_handles = 0; ///< handle loops kept from the initial pass although shorter
  ///< ones were found (with `Reference_tag`: all that were kept)
  /// the number of handles that the initial pass found. It equals the genus, unless the pass
  /// follows `Literal_rules`: then it may find too few or too many.
  std::size_t swept_handles = 0;
  std::size_t traced_tunnels = 0;  ///< tunnel loops that the tunnel pass found
  std::size_t refined_handles = 0; ///< handle loops that the refinement pass replaced
  /// whether `maximum_running_time` ended the search for shorter loops.
  bool was_ended_by_time = false;
  /// the events of the initial pass, if `Solver_options::do_log_fronts` is set. `Reference_tag`
  /// always records them if there are handles.
  std::vector<Front_event> front_events;
  Field_resolution resolution; ///< of the initial pass; set by `Reference_tag` only
  /// the backend that computed the fields: "host", "cuda", "reference", or "cuda, then host" if a
  /// device failed during the computation; empty if no fields were computed.
  std::string backend;
  std::string fallback;           ///< why a requested device was not used, or failed
  bool has_device_failed = false; ///< whether `fallback` reports a failure of an existing device
  std::size_t device_bytes = 0;   ///< the peak device memory in bytes, for one mesh

  /// Returns the wall time of a stage in seconds.
  double seconds_of(Stage stage) const { return seconds[static_cast<std::size_t>(stage)]; }

  /// Returns the wall time of all stages in seconds.
  double total_seconds() const {
    double sum = 0.;
    for(double s : seconds)
      sum += s;
    return sum;
  }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_STAGES_H
