// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_PASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_PASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/First_cells.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <memory>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What the passes are to do, whoever does them.
struct Pass_options : Solver_options
{
  bool do_keep_layers = false; ///< of the vertices, in the initial pass
  bool do_keep_times = false;
  bool is_coarse = false; ///< the mesh, whose lengths are not those of the fine one

  /// All searches of the tunnel pass, or of the refinement, together may take as long as so many
  /// fields over the mesh.
  static constexpr std::uint32_t fields_of_tunnels = 16;
  std::uint32_t fields_of_refinement = 16;

  /// whether more is asked for than loops, so that the initial pass is run without handles, too.
  bool asks_for_fronts() const { return do_log_fronts || do_keep_layers || do_keep_times; }
};

/// The passes of a method (paper, section 4), which `run_passes()` calls in their order, each once,
/// and its diffusion: `Field_passes`, or those of the reference. This is the seam between the order
/// of a computation and whoever does it.
class Passes
{
public:
  virtual ~Passes() = default;

  /// finds the first cells of a coarse mesh, as `Coarse_mesh_builder` would, if whoever does the
  /// passes is the better one to do it; to be asked first.
  virtual bool find_first_cells(First_cells& /* cells */, Statistics& /* statistics */) {
    return false;
  }

  /// paper, 4.1: finds handle loops, as many as the genus.
  virtual void initial_pass(Progress& progress, Statistics& statistics) = 0;

  /// what the initial pass tells of the vertices, as far as the options ask for it.
  virtual Swept_vertices take_swept_vertices() = 0;

  /// paper, 4.2: finds a tunnel loop for each handle loop.
  virtual void tunnel_pass(Progress& progress, Statistics& statistics) = 0;

  /// paper, 4.3: looks for better handle loops.
  virtual void refinement_pass(Progress& progress, Statistics& statistics) = 0;

  /// makes all loops as short as it can.
  virtual void shorten(Progress& progress) = 0;

  /// the pairs; which loop of a pair is the handle remains to be seen.
  virtual std::vector<Flat_pair> take_pairs() = 0;

  /// paper, 6: the arrival times of a field that starts from vertices and their neighbours, `never`
  /// in components without one. May be called at any time, and more than once.
  virtual std::vector<Time>
  diffusion(const std::vector<Index>& vertices, Progress& progress, Statistics& statistics) = 0;

  /// a coarse mesh, where there is one that is good to search for shorter loops than those of the
  /// pairs; to be asked last.
  virtual std::shared_ptr<const Coarse_mesh>
  coarse_mesh_for_searches(const std::vector<Flat_pair>& /* pairs */) {
    return nullptr;
  }
};

/// makes passes on a mesh, from seeds, one in each component.
using Make_passes = std::unique_ptr<Passes> (*)(const Flat_mesh& mesh,
                                                std::vector<Index> seeds,
                                                const Pass_options& options);

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_PASSES_H
