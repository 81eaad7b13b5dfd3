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
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Dual_loop_improvement.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Passes on a coarse mesh, whose loops are lifted to the fine one and made short there. Where fields
on the coarse mesh are no good, and of what is asked about fronts, they are those of the fine mesh.

The fields go over a sixteenth of the vertices, and a loop that has a long way to go is tightened in
steps four times as long. Coarse lengths are not fine ones: so what is shorter among the neighbors
of what was found is asked on the fine mesh alone; not for large meshes, where searches through more
classes find the same.
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
    builder_ = std::make_unique<Coarse_mesh_builder>(
        execution_, mesh_, vertices_of_cell, seeds_,
        [&](First_cells& cells) { return fine_passes().find_first_cells(cells, statistics); });
    if(has_coarse_mesh(most_divided * double(mesh_.number_of_vertices() / vertices_of_cell)) &&
       coarse_->stretch <= most_stretch)
    {
      Pass_options options = options_;
      options.is_coarse = true;
      options.do_log_fronts = options.do_keep_layers = options.do_keep_times = false;
      passes_ = do_levels_pay()
                    ? coarse_passes(execution_, coarse_->mesh, coarse_->mesh.seeds, options, make_)
                    : make_(coarse_->mesh, coarse_->mesh.seeds, options);
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
    if(!options_.is_coarse && mesh_.number_of_vertices() < least_vertices_for_searches)
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

  std::shared_ptr<const Coarse_mesh>
  coarse_mesh_for_searches(const std::vector<Flat_pair>& pairs) override {
    const std::size_t n = mesh_.number_of_vertices();
    if(!passes_ && (n < least_vertices_for_searches || !is_any_long(pairs) ||
                    !has_coarse_mesh(largest_part_for_searches * double(n))))
      return nullptr;
    return coarse_;
  }

private:
  // On meshes of fewer vertices the passes take less time than what comes after them.
  static constexpr std::size_t least_vertices = 10000;

  // A coarse mesh of more has a coarse mesh of its own, where that leaves each handle so many that
  // loops are found in the classes that are looked for.
  static constexpr std::size_t least_vertices_for_levels = 100000, least_vertices_of_handle = 100;

  // A mesh of fewer is searched through itself, if its fields are; and so is one of which more are
  // left.
  static constexpr std::size_t least_vertices_for_searches = 40000;
  static constexpr double largest_part_for_searches = 0.25;

  // Where triangles are of very different sizes, cells are, too, and a field that counts them sees
  // little of the lengths; so it does where the ways between them are crooked, or where many cells
  // had to be divided beside whole ones, as at the noise of a scan.
  static constexpr double most_uneven = 3., most_stretch = 1.45, most_divided = 1.2;
  static constexpr std::size_t most_work = 4; // times the edges of the mesh, each looked at twice

  // Makes the coarse mesh, if it has no more vertices.
  bool has_coarse_mesh(double most_vertices) {
    if(!coarse_ && double(builder_->expected_number_of_vertices()) <= most_vertices)
      if(std::optional<Coarse_mesh> coarse = builder_->build(
             static_cast<std::size_t>(most_vertices), most_work * mesh_.neighbor.size()))
        coarse_ = std::make_shared<Coarse_mesh>(*std::move(coarse));
    if(coarse_)
      builder_.reset();
    return coarse_ && double(coarse_->mesh.number_of_vertices()) <= most_vertices;
  }

  bool do_levels_pay() const {
    const std::size_t n = coarse_->mesh.number_of_vertices();
    return n >= least_vertices_for_levels &&
           n / vertices_of_cell >= least_vertices_of_handle * mesh_.genus;
  }

  bool is_any_long(const std::vector<Flat_pair>& pairs) const {
    const double least = least_length_on_coarse_mesh(mesh_);
    return std::any_of(pairs.begin(), pairs.end(), [&](const Flat_pair& pair) {
      return length(mesh_, pair.handle) >= least || length(mesh_, pair.tunnel) >= least;
    });
  }

  Passes& passes() { return passes_ ? *passes_ : fine_passes(); }

  Passes& fine_passes() {
    if(fine_passes_ == nullptr)
      fine_passes_ = make_(mesh_, seeds_, options_);
    return *fine_passes_;
  }

  // Loops on the way from centre to centre have no direction to speak of: they are straightened,
  // whatever is asked for. On a mesh that is coarse itself they go all of their way, which on the
  // mesh would be four times as many steps, each four times as long.
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
          Loop_tightening tightening(execution_, mesh_);
          if(options_.is_coarse)
            tightening.tighten(loop);
          else
            tightening.straighten(loop);
        },
        1);
  }

  Execution execution_; // watched by the progress of the initial pass
  const Flat_mesh& mesh_;
  std::vector<Index> seeds_;
  Pass_options options_;
  Make_passes make_;
  std::unique_ptr<Coarse_mesh_builder> builder_; // after the initial pass
  std::shared_ptr<Coarse_mesh> coarse_;          // if there is one
  std::shared_ptr<Passes> passes_,
      fine_passes_; // on the coarse mesh, if it is good, and on the mesh
  std::vector<Crossing_loop> handles_, tunnels_; // lifted
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_COARSE_PASSES_H
