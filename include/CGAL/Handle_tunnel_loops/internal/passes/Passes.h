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

#include <CGAL/Handle_tunnel_loops/internal/field/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/First_cells.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/backend.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <memory>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_PASSES_H
