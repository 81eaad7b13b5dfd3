// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_HOST_BACKEND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_HOST_BACKEND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Front_layers.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Narrow_band.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Processor_executor.h>
#include <CGAL/Handle_tunnel_loops/internal/field/handle_candidates.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/First_cells.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Parallel_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Dual_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The operation behind the tunnel pass and the refinement pass (paper, 4.2 and 4.3): find the way from
the left side of a loop around to its right side that crosses no wall, and close it across the loop.

The paper lets a field grow from one side until it reaches the other. Here it grows from both sides
until the two fronts meet: the way is as short, and the fronts cover a fraction of the region where
surfaces branch. From where they meet the way goes back to either side, each vertex followed by the
neighbour that was reached first, then across the loop, and along its left side, the short way, to
where it began.

The result crosses the loop once and no other wall, counted with sign. This is checked in integers
for every candidate; on meshes so coarse that an edge is crossed by several walls, the first meeting
may fail, and the next one is waited for.
*/
template <typename Loop_set> class Bidirectional_front
{
public:
  /// `index` tells where the loops are that can be barred: in each search a set of type `Loop_set`.
  Bidirectional_front(const Flat_mesh& mesh,
                      const Stencils& stencils,
                      const Step_coefficients& k,
                      const Crossing_index& index)
      : mesh_(mesh)
      , index_(index)
      , band_(mesh, stencils, k) {
    if(!Loop_set::is_one)
      for(Index v : index.vertices().vertices())
        band_.expect_walls(v);
  }

  /// finds closed walks on the edges, the shortest first as far as the fronts can tell, for one of
  /// the loops of the query, which is a wall itself. Where the fronts meet in several places, as
  /// behind each of several branches of the surface, there is a walk for each; the search ends a
  /// third later than the first was found.
  Dual_walks dual_walks(const Dual_loop_query& query, Index number) {
    CGAL_precondition(number < query.loops.size());
    const Crossing_loop& loop = query.loops[number];
    const Loop_set barred = {number};
    const Walls walls(index_, barred);
    parallel_paths_.measure(mesh_, loop);
    start(loop, walls);
    Dual_walks found;
    Time last_step = query.numbers_of_steps.empty() ? never : query.numbers_of_steps[number];
    const std::size_t updates_before = band_.number_of_updates();
    const auto has_given_up = [&] {
      return band_.number_of_updates() - updates_before >= query.number_of_updates;
    };
    const auto may_go_on = [&] {
      return found.walks.size() < query.number_of_walks && band_.number_of_steps() < last_step &&
             !has_given_up();
    };
    do {
      std::sort(meetings_.begin(), meetings_.end());
      for(const Meeting& meeting : meetings_) {
        if(found.walks.size() == query.number_of_walks || continues_a_meeting(meeting))
          continue;
        std::vector<Index> walk = parallel_paths_.closed_walk(path_back(meeting.right, walls),
                                                              path_back(meeting.left, walls));
        if(!is_dual(index_.intersections(walk), number, barred))
          continue;
        mark(meeting);
        if(found.walks.empty())
          last_step = (std::min)(last_step, band_.number_of_steps() * 4 / 3 + 1);
        found.walks.push_back(std::move(walk));
      }
      meetings_.clear();
    } while(may_go_on() && band_.step(walls, [&](Index v) { note_meetings(v, walls); }));
    found.has_given_up = has_given_up();
    band_.reset();
    return found;
  }

  std::size_t number_of_updates() const { return band_.number_of_updates(); }

private:
  using Walls = Loop_walls<Loop_set>;

  // An edge, or one vertex, at which what was reached from the left meets what was reached from the
  // right.
  struct Meeting
  {
    std::uint64_t time; // on both ways together
    Index left, right;

    bool operator<(const Meeting& other) const {
      return std::tie(time, left, right) < std::tie(other.time, other.left, other.right);
    }
  };

  void start(const Crossing_loop& loop, const Walls& walls) {
    meetings_.clear();
    for(const Crossing& c : loop)
      if(Loop_set::is_one) {
        band_.expect_walls_now(c.left);
        band_.expect_walls_now(c.right);
      }
    for(const Crossing& c : loop)
      band_.add_source(c.left, 0, Side::LEFT);
    for(const Crossing& c : loop)
      if(band_.is_reached(c.right) && band_.side(c.right) == Side::LEFT)
        meetings_.push_back({0, c.right, c.right});
      else
        band_.add_source(c.right, 0, Side::RIGHT);
    // A vertex with many edges may be beside as many crossings, one after the other.
    Index last = no_index;
    for(const Crossing& c : loop)
      if(std::exchange(last, c.right) != c.right && band_.side(c.right) == Side::RIGHT)
        note_meetings(c.right, walls);
    band_.start(walls);
  }

  void note_meetings(Index v, const Walls& walls) {
    CGAL_precondition(band_.is_reached(v));
    const Side side = band_.side(v);
    band_.for_each_reached_neighbor(v, [&](Index u) {
      if(band_.side(u) == side || band_.is_wall(v, u, walls))
        return;
      const std::uint64_t time = std::uint64_t(band_.time(u)) + band_.time(v);
      meetings_.push_back(side == Side::RIGHT ? Meeting{time, u, v} : Meeting{time, v, u});
    });
  }

  // Once the fronts have met in one place, they go on meeting beside it.
  bool continues_a_meeting(const Meeting& meeting) {
    for(Index v : {meeting.left, meeting.right}) {
      bool is_marked = band_.is_marked(v);
      if(mesh_.ring(v).size() <= very_many_neighbors)
        for(Index u : mesh_.ring(v))
          is_marked = is_marked || band_.is_marked(u);
      if(is_marked) {
        mark(meeting);
        return true;
      }
    }
    return false;
  }

  // The neighbours of a vertex that has many are not asked: it is marked with them.
  void mark(const Meeting& meeting) {
    for(Index v : {meeting.left, meeting.right}) {
      band_.mark(v);
      if(mesh_.ring(v).size() <= very_many_neighbors)
        for(Index u : mesh_.ring(v))
          if(mesh_.ring(u).size() > very_many_neighbors && band_.is_reached(u))
            band_.mark(u);
    }
  }

  // From `v` to a source.
  std::vector<Index> path_back(Index v, const Walls& walls) const {
    std::vector<Index> walk(1, v);
    while(band_.time(v) != 0) {
      const Index from = v;
      v = steepest_descent(
          mesh_, from, [&](Index u) { return band_.time(u); },
          [&](Index u) {
            return band_.side(u) == band_.side(from) && !band_.is_wall(from, u, walls);
          });
      CGAL_assertion_msg(band_.time(v) < band_.time(from), "the way back goes down in time");
      walk.push_back(v);
    }
    return walk;
  }

  const Flat_mesh& mesh_;
  const Crossing_index& index_;
  Narrow_band band_;
  std::vector<Meeting> meetings_;
  Parallel_paths parallel_paths_;
};

/// On the processor, in a narrow band; the loop passes side by side.
class Host_backend
{
public:
  /// \p fallback says why it is not a device, if one was asked for.
  Host_backend(Execution execution, const Flat_mesh& mesh, std::string fallback = {})
      : execution_(execution)
      , mesh_(mesh)
      , fallback_(std::move(fallback))
      , stencils_(execution, mesh) {}

  /// as a device does; here it is left to `Coarse_mesh_builder`.
  static bool find_first_cells(First_cells&) { return false; }

  std::vector<Handle_candidate> initial_field(const std::vector<Index>& seeds,
                                              const Step_coefficients& k,
                                              const Callback& callback) {
    times_ = times_from_vertices(seeds, k, callback);
    CGAL_assertion_msg(std::find(times_.begin(), times_.end(), never) == times_.end(),
                       "there is a seed in each component");
    return find_handle_candidates(execution_, mesh_, times_);
  }

  std::vector<Time> arrival_times() { return times_; }

  bool has_arrival_times() const { return !times_.empty(); }

  /// takes those of an initial field elsewhere for its own.
  void set_arrival_times(std::vector<Time> times) { times_ = std::move(times); }

  Front_log front_log() {
    Processor_executor executor(execution_);
    const Span<const Time> times(times_.data(), times_.size());
    return Front_layers<Processor_executor>(executor, mesh_, view_of(mesh_), times).run();
  }

  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index,
                                     const Step_coefficients& k) {
    Narrow_band band(mesh_, stencils_, k);
    for(Index v : index.vertices().vertices())
      band.expect_walls(v);
    for(const Crossing_loop& loop : loops)
      for(const Crossing& c : loop)
        for(Index v : {c.left, c.right})
          band.add_source(v, 0);
    const Loops_from all_loops = {0};
    const Loop_walls<Loops_from> walls(index, all_loops);
    band.start(walls);
    while(band.step(walls, [](Index) {}))
      ;
    return band.take_times();
  }

  std::vector<Time> times_from_vertices(const std::vector<Index>& vertices,
                                        const Step_coefficients& k,
                                        const Callback& callback) {
    Narrow_band band(mesh_, stencils_, k);
    add_sources_with_rings(band, mesh_, vertices);
    grow(band, mesh_.number_of_vertices(), [&](double part) {
      if(!callback(part))
        throw Interrupted_exception();
    });
    return band.take_times();
  }

  std::vector<Dual_walks>
  dual_walks(const Dual_loop_query& query, const Step_coefficients& k, const Callback& callback) {
    return query.bars_only_own ? dual_walks_with<Only_loop>(query, k, callback)
                               : dual_walks_with<Loops_from>(query, k, callback);
  }

  void report(Statistics& statistics) const {
    statistics.backend = "host";
    statistics.fallback = fallback_;
  }

private:
  template <typename Loop_set>
  std::vector<Dual_walks> dual_walks_with(const Dual_loop_query& query,
                                          const Step_coefficients& k,
                                          const Callback& callback) const {
    using Fronts = Bidirectional_front<Loop_set>;
    Workspace_pool<Fronts> pool(
        [&] { return std::make_unique<Fronts>(mesh_, stencils_, k, query.index); });
    std::vector<Dual_walks> found(query.numbers.size());
    std::atomic<std::size_t> number_of_done{0};
    std::atomic<bool> is_stopped{false};
    for_each_index(
        execution_, found.size(),
        [&](std::size_t i) {
          if(is_stopped)
            return;
          auto fronts = pool.borrow();
          found[i] = fronts->dual_walks(query, query.numbers[i]);
          if(!callback(double(++number_of_done) / double(found.size())))
            is_stopped = true;
        },
        1);
    if(is_stopped)
      throw Interrupted_exception();
    return found;
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  std::string fallback_;
  Stencils stencils_;
  std::vector<Time> times_; // of the last initial field
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_HOST_BACKEND_H
