// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_TUNNEL_PASS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_TUNNEL_PASS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/passes/Voronoi_graph_search.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Pass_context.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Workspace_pool.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// For each of several disjoint contours the way from its left side around to its right side
/// (paper, 4.2): it crosses this contour once, and none that comes later.
class Tunnel_pass
{
public:
  Tunnel_pass(const Pass_context& context,
              const std::vector<Crossing_loop>& contours,
              const Crossing_index& index)
      : context_(context)
      , contours_(contours)
      , index_(index)
      , tunnels_(contours.size()) {}

  /// returns the tunnels; empty where none was found.
  std::vector<Crossing_loop> run() {
    find_distant_tunnels(find_near_tunnels());
    return std::move(tunnels_);
  }

private:
  // Two fronts for each loop. The loops share a number of updates, so that all of them together
  // cost no more than some fields over the mesh; those for which that is not enough share it once
  // more. Returns the loops that are left when most would need more than their share, as a sample
  // tells before much is spent.
  std::vector<Index> find_near_tunnels() {
    std::size_t sharing = contours_.size();
    std::vector<Index> sample, others;
    for(Index k = 0; k < contours_.size(); ++k)
      (sharing <= 16 || k % 16 == 0 ? sample : others).push_back(k); // all of a few, at a time
    std::vector<Index> open = search(sample, share_of_updates(sharing));
    if(!others.empty() && 2 * open.size() <= sample.size())
      others = search(others, share_of_updates(sharing));
    open.insert(open.end(), others.begin(), others.end());
    for(; !open.empty() && 2 * open.size() <= sharing;) {
      sharing = open.size();
      open = search(open, share_of_updates(sharing));
    }
    return open;
  }

  // A field that covers the mesh once takes about 23 updates per vertex, with the largest steps.
  std::size_t share_of_updates(std::size_t number_of_loops) const {
    return steps_of(16 * 23, context_.searching) * context_.mesh.number_of_vertices() /
               (std::max)(number_of_loops, std::size_t(1)) +
           1;
  }

  // Looks for the tunnels of the given loops. Returns those that need more updates.
  std::vector<Index> search(const std::vector<Index>& numbers, std::size_t number_of_updates) {
    Dual_loop_query query = {contours_, index_, false, numbers};
    query.number_of_updates = number_of_updates;
    const double done = part_done(), share = double(numbers.size()) / double(tunnels_.size());
    std::vector<Dual_walks> found = context_.dual_walks(query, done, done + share / 2.);
    CGAL_assertion(found.size() == numbers.size());
    std::vector<Index> open;
    for(std::size_t i = 0; i < numbers.size(); ++i)
      if(found[i].walks.empty() && found[i].has_given_up)
        open.push_back(numbers[i]);
    context_.for_each(numbers.size(), [&](std::size_t i) {
      const std::vector<std::vector<Index>> walks = std::move(found[i].walks);
      if(!walks.empty())
        set_tunnel(numbers[i], walks.front());
    });
    return open;
  }

  double part_done() const {
    const auto is_found = [](const Crossing_loop& tunnel) { return !tunnel.empty(); };
    return double(std::count_if(tunnels_.begin(), tunnels_.end(), is_found)) /
           double(tunnels_.size());
  }

  // One field for all loops together, where fronts of their own would cover the mesh again and
  // again.
  void find_distant_tunnels(const std::vector<Index>& numbers) {
    if(numbers.empty())
      return;
    const Voronoi_regions regions(
        context_.execution, context_.mesh,
        context_.backend.times_from_loops(contours_, index_, context_.searching), contours_,
        index_);
    Workspace_pool<Voronoi_graph_search> pool([&] {
      return std::make_unique<Voronoi_graph_search>(context_.mesh, contours_, index_, regions);
    });
    context_.for_each(numbers.size(), [&](std::size_t i) {
      const std::vector<Index> walk = pool.borrow()->dual_walk(numbers[i]);
      if(!walk.empty())
        set_tunnel(numbers[i], walk);
    });
    std::vector<Index> open;
    std::copy_if(numbers.begin(), numbers.end(), std::back_inserter(open),
                 [this](Index k) { return tunnels_[k].empty(); });
    search(open, (std::numeric_limits<std::size_t>::max)());
  }

  void set_tunnel(Index k, const std::vector<Index>& walk) {
    CGAL_assertion_msg(tunnels_[k].empty(), "a tunnel is looked for until it is found");
    tunnels_[k] = pushed_left(context_.mesh, walk);
    context_.tighten(tunnels_[k]);
    context_.progress.advance_one(tunnels_.size());
  }

  const Pass_context& context_;
  const std::vector<Crossing_loop>& contours_;
  const Crossing_index& index_;
  std::vector<Crossing_loop> tunnels_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PIPELINE_TUNNEL_PASS_H
