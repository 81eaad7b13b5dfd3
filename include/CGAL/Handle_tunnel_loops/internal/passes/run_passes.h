// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_RUN_PASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_RUN_PASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the passes on the processor. \p seeds are the vertices to start from, one in each component;
/// \p fallback says why it is not a device, if one was asked for.
CGAL_HTL_CORE std::unique_ptr<Passes> host_passes(Execution execution,
                                                  const Flat_mesh& mesh,
                                                  std::vector<Index> seeds,
                                                  const Pass_options& options,
                                                  std::string fallback = {});

/// the passes on a coarse mesh, those on the fine one where that does not pay; see `Coarse_passes`.
CGAL_HTL_CORE std::unique_ptr<Passes> coarse_passes(Execution execution,
                                                    const Flat_mesh& mesh,
                                                    std::vector<Index> seeds,
                                                    const Pass_options& options,
                                                    Make_passes make);

/// What a concurrency tag stands for: who does the passes. Specialised for the tags of other
/// solvers, which take part in the tests of agreement.
template <typename ConcurrencyTag> struct Passes_of_tag
{
  /// whether these may be passes on a coarse mesh in place of the one that is given.
  static constexpr bool may_coarsen = true;

  /// makes ready what can be while the mesh is prepared, after which it is waited for.
  static std::future<void> head_start(const Device_options&, std::size_t /* number_of_vertices */) {
    return {};
  }

  /// \p seeds are the vertices to start from, one in each component.
  static std::unique_ptr<Passes>
  make(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
    return host_passes(execution_of<ConcurrencyTag>(), mesh, std::move(seeds), options);
  }
};

/// makes ready what the passes of a tag need, for a mesh of so many vertices: what counts is the
/// mesh that the fields are on. That it may be a coarse mesh of a coarse mesh is not known yet:
/// then what has been made ready may not be used.
template <typename ConcurrencyTag>
std::future<void> head_start(const Solver_options& options, std::size_t number_of_vertices) {
  using Tag = Passes_of_tag<ConcurrencyTag>;
  const bool is_coarse = Tag::may_coarsen && options.do_coarsen;
  return Tag::head_start(options.device, number_of_vertices / (is_coarse ? vertices_of_cell : 1));
}

/// the passes of a tag, on a coarse mesh if that is allowed.
template <typename ConcurrencyTag>
std::unique_ptr<Passes>
make_passes(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
  using Tag = Passes_of_tag<ConcurrencyTag>;
  if(Tag::may_coarsen && options.do_coarsen)
    return coarse_passes(execution_of<ConcurrencyTag>(), mesh, std::move(seeds), options,
                         &Tag::make);
  return Tag::make(mesh, std::move(seeds), options);
}

/// the passes one after the other, from a mesh with handles to pairs of loops.
CGAL_HTL_CORE std::vector<Flat_pair>
run_passes(Passes& passes, const Pass_options& options, Progress& progress, Statistics& statistics);

/// the first of them alone, which is all there is to do where there are no handles.
CGAL_HTL_CORE void run_initial_pass(Passes& passes, Progress& progress, Statistics& statistics);

/// The arrival times of a diffusion that starts from the sources, if there are any; else from both
/// sides of the handle loops; and in components without any, from one vertex. All fields are those
/// of the passes.
CGAL_HTL_CORE std::vector<Time> diffusion_times(Passes& passes,
                                                const Pass_options& options,
                                                const Flat_mesh& mesh,
                                                const std::vector<Index>& sources,
                                                Progress& progress,
                                                Statistics& statistics);

} // namespace CGAL::Handle_tunnel_loops::internal

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_RUN_PASSES_H
