// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_SEARCH_GROUND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_SEARCH_GROUND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Class_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Search_levels.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Search_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Edge_crossings.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Where loops are searched for: the mesh, or a coarse one, on which stands for each loop one of
/// its class.
class Search_ground
{
public:
  explicit Search_ground(const Flat_mesh& mesh)
      : fine_(mesh)
      , mesh_(mesh)
      , levels_(mesh) {}

  explicit Search_ground(const Coarse_mesh& coarse)
      : fine_(*coarse.fine)
      , mesh_(coarse.mesh)
      , coarse_(&coarse)
      , levels_(coarse.mesh) {}

  Search_levels& levels() { return levels_; }

  /// makes searches ready on some levels, which last until this is called again. \p crossings are
  /// those of the loops, and \p weights.
  void prepare(Execution execution,
               const std::set<int>& levels,
               const std::vector<Crossing_loop>& loops,
               const std::shared_ptr<const Edge_crossings>& crossings,
               std::vector<Class_sums> weights) {
    loops_ = &loops;
    if(coarse_ != nullptr) {
      projected_.resize(loops.size());
      for_each_index(
          execution, loops.size(),
          [&](std::size_t i) { projected_[i] = coarse_->projected(loops[i]); }, 16);
      loops_ = &projected_;
      edge_classes_.emplace(std::make_shared<const Edge_crossings>(
                                execution, mesh_, Crossing_index(mesh_, projected_)),
                            std::move(weights));
    } else
      edge_classes_.emplace(crossings, std::move(weights));
    levels_.count(execution, levels, *edge_classes_);
    for(int k : levels)
      searches_.try_emplace(
          k, [this, k] { return std::make_unique<Partner_search>(mesh_, levels_[k]); });
  }

  /// the mesh, or the coarse one, and a loop there.
  const Flat_mesh& mesh() const { return mesh_; }
  const Crossing_loop& loop(Index i) const { return (*loops_)[i]; }

  /// gives away what is made again by `prepare()`.
  void forget() {
    searches_.clear();
    levels_.forget_coarser();
  }

  /// see `Search_levels::vertices_around()`; the loop is of the fine mesh.
  double vertices_around(int level, double length, const Crossing_loop& loop) const {
    return levels_.vertices_around(level, length, coarse_ == nullptr ? double(loop.size()) : 0.);
  }

  /// see `Partner_search::run()`.
  void search(int level,
              Index partner,
              const Search_manner& manner,
              Search_targets& targets,
              std::size_t& visits) {
    searches_.at(level).borrow()->run((*loops_)[partner], partner, manner, targets, visits);
  }

  /// the loop on the ground along a walk that was found, tightened; empty if it is a point.
  Crossing_loop tightened(Execution execution, const std::vector<Index>& walk) const {
    Crossing_loop loop = levels_[0].loop_along(walk);
    if(!loop.empty())
      Loop_tightening(execution, mesh_).tighten(loop);
    return loop;
  }

  /// a loop on the ground as one on the mesh: straight, if the ground is a coarse one.
  Crossing_loop on_mesh(Execution execution, Crossing_loop loop) const {
    if(coarse_ == nullptr)
      return loop;
    loop = coarse_->lifted(loop);
    Loop_tightening(execution, fine_).straighten(loop);
    return loop;
  }

  /// how short, at least, a geodesic of this length on the ground is on the mesh, about.
  double least_on_mesh(double length_on_ground) const {
    return coarse_ == nullptr ? length_on_ground : length_on_ground / coarse_lengths;
  }

  /// both; nothing if it would not be shorter than \p limit.
  std::optional<Crossing_loop>
  tightened(Execution execution, const std::vector<Index>& walk, double limit) const {
    Crossing_loop loop = tightened(execution, walk);
    if(loop.empty() || (coarse_ != nullptr && least_on_mesh(length(mesh_, loop)) > limit))
      return std::nullopt;
    return on_mesh(execution, std::move(loop));
  }

  /// which loops cross the edges of the ground.
  const Edge_crossings& crossings() const { return edge_classes_->crossings(); }

private:
  // A geodesic of the coarse mesh may be as much longer than that of the fine one.
  static constexpr double coarse_lengths = 1.02;

  const Flat_mesh &fine_, &mesh_;
  const Coarse_mesh* coarse_ = nullptr;
  Search_levels levels_;
  const std::vector<Crossing_loop>* loops_ = nullptr;
  std::vector<Crossing_loop> projected_;
  std::optional<Edge_classes> edge_classes_;
  std::map<int, Workspace_pool<Partner_search>> searches_; // by level
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_SEARCH_GROUND_H
