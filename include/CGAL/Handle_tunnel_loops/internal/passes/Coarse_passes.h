// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_COARSE_PASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_COARSE_PASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Dual_loop_improvement.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Passes on a coarse mesh, whose loops are lifted to the fine one and made short there. Where fields
on the coarse mesh are no good, and of what is asked about fronts, they are those of the fine mesh.

The fields go over a sixteenth of the vertices, and a loop that has a long way to go is tightened in
steps four times as long. What is lost is that coarse lengths are not fine ones: so it is asked once
more on the fine mesh, among the neighbours of what was found, which is shorter.
*/
class Coarse_passes final : public Passes
{
public:
  /// \p seeds are the vertices to start from, one in each component; \p make makes passes on a mesh.
  Coarse_passes(Execution execution,
                const Flat_mesh& mesh,
                std::vector<Index> seeds,
                const Pass_options& options,
                Make_passes make)
      : execution_(execution)
      , mesh_(mesh)
      , seeds_(std::move(seeds))
      , options_(options)
      , make_(make) {}

  /// whether a mesh is so large, and so even, that it pays.
  static bool do_pay(const Flat_mesh& mesh) {
    return mesh.genus > 0 && mesh.number_of_vertices() >= least_vertices &&
           unevenness(mesh) <= most_uneven;
  }

  void initial_pass(Progress& progress, Statistics& statistics) override {
    execution_ = execution_.watched_by(progress);
    coarse_ = std::make_shared<Coarse_mesh>(
        Coarse_mesh_builder(execution_, mesh_).build(spacing, seeds_));
    if(!is_good_for_fields(*coarse_)) {
      if(!is_good_for_searches(*coarse_))
        coarse_.reset();
    } else {
      Pass_options options = options_;
      options.do_log_fronts = options.do_keep_layers = options.do_keep_times = false;
      passes_ = make_(coarse_->mesh, coarse_->mesh.seeds, options);
    }
    passes().initial_pass(progress, statistics);
    if(passes_ && options_.asks_for_fronts())
      fine_passes().initial_pass(progress, statistics);
  }

  Swept_vertices take_swept_vertices() override {
    return options_.asks_for_fronts() ? fine_passes().take_swept_vertices() : Swept_vertices();
  }

  void tunnel_pass(Progress& progress, Statistics& statistics) override {
    passes().tunnel_pass(progress, statistics);
  }

  void refinement_pass(Progress& progress, Statistics& statistics) override {
    passes().refinement_pass(progress, statistics);
  }

  void shorten(Progress& progress) override {
    passes().shorten(progress);
    if(!passes_)
      return;
    lift();
    Dual_loop_improvement(execution_, mesh_, progress).improve(handles_, tunnels_);
  }

  std::vector<Flat_pair> take_pairs() override {
    if(!passes_)
      return passes().take_pairs();
    if(handles_.empty())
      lift();
    std::vector<Flat_pair> pairs(handles_.size());
    for(std::size_t k = 0; k < pairs.size(); ++k)
      pairs[k] = {std::move(handles_[k]), std::move(tunnels_[k])};
    return pairs;
  }

  std::vector<Time> diffusion(const std::vector<Index>& vertices,
                              Progress& progress,
                              Statistics& statistics) override {
    return fine_passes().diffusion(vertices, progress, statistics);
  }

  std::shared_ptr<const Coarse_mesh> coarse_mesh() const override { return coarse_; }

private:
  // On meshes of fewer vertices the passes take less time than what comes after them.
  static constexpr std::size_t least_vertices = 10000;
  static constexpr Index spacing = 16;

  // A mesh of fewer is searched through itself, if its fields are; and so is one of which more are
  // left.
  static constexpr std::size_t least_vertices_for_searches = 40000;
  static constexpr double largest_part_for_searches = 0.25;

  // Where triangles are of very different sizes, cells are, too, and a field that counts them sees
  // little of the lengths; so it does where the ways between them are crooked, or where many cells
  // had to be divided beside whole ones, as at the noise of a scan.
  static constexpr double most_uneven = 3., most_stretch = 1.45, most_divided = 1.2;

  bool is_good_for_fields(const Coarse_mesh& coarse) const {
    return coarse.stretch <= most_stretch &&
           double(spacing) * double(coarse.mesh.number_of_vertices()) <=
               most_divided * double(mesh_.number_of_vertices());
  }

  bool is_good_for_searches(const Coarse_mesh& coarse) const {
    const double n = double(mesh_.number_of_vertices());
    return n >= double(least_vertices_for_searches) &&
           double(coarse.mesh.number_of_vertices()) <= largest_part_for_searches * n;
  }

  Passes& passes() { return passes_ ? *passes_ : fine_passes(); }

  Passes& fine_passes() {
    if(fine_passes_ == nullptr)
      fine_passes_ = make_(mesh_, seeds_, options_);
    return *fine_passes_;
  }

  // Loops on the way from centre to centre have no direction to speak of: they are tightened,
  // whatever is asked for.
  void lift() {
    const std::vector<Flat_pair> pairs = passes_->take_pairs();
    handles_.resize(pairs.size());
    tunnels_.resize(pairs.size());
    for_each_index(
        execution_, 2 * pairs.size(),
        [&](std::size_t i) {
          const Flat_pair& pair = pairs[i / 2];
          Crossing_loop& loop = i % 2 == 0 ? handles_[i / 2] : tunnels_[i / 2];
          loop = coarse_->lifted(i % 2 == 0 ? pair.handle : pair.tunnel);
          Loop_tightening(execution_, mesh_).tighten(loop);
        },
        1);
  }

  Execution execution_; // watched by the progress of the initial pass
  const Flat_mesh& mesh_;
  std::vector<Index> seeds_;
  Pass_options options_;
  Make_passes make_;
  std::shared_ptr<Coarse_mesh> coarse_;
  std::unique_ptr<Passes> passes_,
      fine_passes_; // on the coarse mesh, if it is good, and on the mesh
  std::vector<Crossing_loop> handles_, tunnels_; // lifted
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_COARSE_PASSES_H
