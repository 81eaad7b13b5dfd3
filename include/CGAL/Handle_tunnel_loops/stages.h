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
/// The stages of a computation, in order. What is left out by the parameters has none.
enum class Stage {
  ADAPTOR,     ///< checks the mesh, and turns it into arrays
  INITIAL,     ///< the initial pass (paper, 4.1)
  TUNNEL,      ///< the tunnel pass (paper, 4.2)
  REFINE,      ///< the handle refinement pass (paper, 4.3)
  SHORTEN,     ///< tightens all loops, and looks for shorter ones by length
  CLASSES,     ///< makes the loops bound on their sides, and looks for shorter ones that do
  CONVERT,     ///< turns the loops into loops on the caller's mesh
  CERTIFICATE, ///< cuts the mesh along the loops, and checks that they are a basis
  CLASSIFY,    ///< counts linking numbers, and tells handles from tunnels (paper, 4.5)
  DIFFUSION    ///< the field of a Reeb graph
};

/// the number of stages.
constexpr std::size_t number_of_stages = 10;

/// the name of a stage, as it stands in reports.
inline const char* stage_name(Stage stage) {
  constexpr std::array<const char*, number_of_stages> names = {
      "adaptor", "initial", "tunnel",      "refine",   "shorten",
      "classes", "convert", "certificate", "classify", "diffusion"};
  return names[static_cast<std::size_t>(stage)];
}

/*!
\ingroup PkgHandleTunnelLoopsRef
\cgalModels `HandleTunnelLoopsVisitor`

The default visitor, which does nothing. Derive from it to be told of the stages.
*/
struct Default_visitor
{
  /// is called when a stage begins, in the calling thread.
  void start_stage(Stage) const {}
  /// is called when a stage has ended, in the calling thread.
  void end_stage(Stage) const {}
};

/// \ingroup PkgHandleTunnelLoopsRef
/// What a computation did: sizes, wall times in seconds and how often a fallback was needed.
struct Statistics
{
  std::size_t number_of_vertices = 0;
  std::size_t number_of_faces = 0;
  std::size_t number_of_components = 0;
  std::size_t number_of_boundaries = 0;           ///< boundary curves
  std::size_t genus = 0;                          ///< summed over the components
  std::array<double, number_of_stages> seconds{}; ///< by stage
  std::size_t kept_sweep_tunnels = 0; ///< tunnels for which the loop of the initial pass was kept
  std::size_t kept_sweep_handles = 0; ///< handles for which the loop of the initial pass was
  ///< kept although shorter ones were found (by `Reference_tag`: all that were kept)
  /// handles that the initial pass found: as many as the genus, unless it was to follow
  /// `Literal_rules`, by which it may end before it has found all, or find too many.
  std::size_t swept_handles = 0;
  std::size_t traced_tunnels = 0;  ///< tunnels that the tunnel pass found
  std::size_t refined_handles = 0; ///< handles that the refinement pass replaced
  /// whether the parameter `maximum_running_time` has ended the search for shorter loops.
  bool was_ended_by_time = false;
  /// of the initial pass, if `Solver_options::do_log_fronts` asks for them; always by
  /// `Reference_tag`, where there are handles.
  std::vector<Front_event> front_events;
  Field_resolution resolution; ///< of the initial pass; by `Reference_tag` only
  /// what computed the fields, if any: "host", "cuda" or "reference"; "cuda, then host" where a
  /// device failed in the middle.
  std::string backend;
  std::string fallback;           ///< why not on the device, or no longer, if that was asked for
  bool has_device_failed = false; ///< whether `fallback` is about a device that is there
  std::size_t device_bytes = 0;   ///< of the device's memory, at most at one time, for one mesh

  /// the wall time of a stage, in seconds.
  double seconds_of(Stage stage) const { return seconds[static_cast<std::size_t>(stage)]; }

  /// the wall time of all stages, in seconds.
  double total_seconds() const {
    double sum = 0.;
    for(double s : seconds)
      sum += s;
    return sum;
  }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_STAGES_H
