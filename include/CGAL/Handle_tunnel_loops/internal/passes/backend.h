// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_BACKEND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_BACKEND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <string>
#include <utility>
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

class Passes;

/// makes passes on a mesh, from seeds, one in each component.
using Make_passes = std::shared_ptr<Passes> (*)(const Flat_mesh& mesh,
                                                std::vector<Index> seeds,
                                                const Pass_options& options);

/// the passes on the processor. \p seeds are the vertices to start from, one in each component;
/// \p fallback says why it is not a device, if one was asked for.
std::shared_ptr<Passes> host_passes(Execution execution,
                                    const Flat_mesh& mesh,
                                    std::vector<Index> seeds,
                                    const Pass_options& options,
                                    std::string fallback = {});

/// the passes on a coarse mesh, those on the fine one where that does not pay; see `Coarse_passes`.
std::shared_ptr<Passes> coarse_passes(Execution execution,
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
  static std::future<void>
  head_start(const Device_options&, std::size_t /* number_of_vertices */, bool /* is_coarse */) {
    return {};
  }

  /// \p seeds are the vertices to start from, one in each component.
  static std::shared_ptr<Passes>
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
  return Tag::head_start(options.device, number_of_vertices, is_coarse);
}

/// the passes of a tag, on a coarse mesh if that is allowed.
template <typename ConcurrencyTag>
std::shared_ptr<Passes>
make_passes(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
  using Tag = Passes_of_tag<ConcurrencyTag>;
  if(Tag::may_coarsen && options.do_coarsen)
    return coarse_passes(execution_of<ConcurrencyTag>(), mesh, std::move(seeds), options,
                         &Tag::make);
  return Tag::make(mesh, std::move(seeds), options);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_BACKEND_H
