// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_FIELD_PASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_FIELD_PASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/field/handle_candidates.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_flat_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Basis_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Dual_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Voronoi_search.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Dual_loop_improvement.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Gauss_reduction.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What the passes have in common: where fields come from, and how loops are handled side by side.
template <typename Backend> struct Pass_context
{
  Execution execution; ///< watched by the progress
  const Flat_mesh& mesh;
  Backend& backend;
  Step_coefficients searching; ///< of the fields of the loop passes
  const Pass_options& options;
  Progress& progress;

  /// what is found for the loops of a query, while the stage comes from one part of it to another.
  std::vector<Dual_walks> dual_walks(Dual_loop_query query, double from, double to) const {
    std::vector<Dual_walks> found(query.numbers.size());
    std::vector<Index> numbers;
    for(std::size_t i = 0; i < found.size(); ++i) {
      found[i].has_given_up =
          first_updates(query.loops[query.numbers[i]]) > query.number_of_updates;
      if(!found[i].has_given_up)
        numbers.push_back(query.numbers[i]);
    }
    query.numbers = std::move(numbers);
    std::vector<Dual_walks> searched =
        backend.dual_walks(query, searching, [this, from, to](double part) {
          return progress.goes_on(from + part * (to - from));
        });
    CGAL_assertion(searched.size() == query.numbers.size());
    auto next = searched.begin();
    for(Dual_walks& walks : found)
      if(!walks.has_given_up)
        walks = std::move(*next++);
    return found;
  }

  /// how many updates each of so many loops may take, so that all together cost no more than so
  /// many fields over the mesh: one takes about 23 per vertex, with the largest steps.
  std::size_t share_of_updates(std::size_t number_of_loops, std::uint32_t number_of_fields) const {
    return steps_of(number_of_fields * 23, searching) * mesh.number_of_vertices() /
               (std::max)(number_of_loops, std::size_t(1)) +
           1;
  }

  /// At least so many are made in the first step from a loop, beside which there may be vertices of
  /// very many neighbours.
  std::uint64_t first_updates(const Crossing_loop& loop) const {
    std::uint64_t most = 0;
    for(const Crossing& c : loop)
      most = (std::max)({most, std::uint64_t(mesh.ring(c.left).size()),
                         std::uint64_t(mesh.ring(c.right).size())});
    return most;
  }

  /// calls `f(i)` for i in [0, n), each of which is much work, until somebody wants to stop.
  template <typename Function> void for_each(std::size_t n, const Function& f) const {
    for_each_index(execution, n, f, 1);
    progress.throw_if_interrupted();
  }

  /// tightens a loop, if that is wanted; in the given number of rounds, if there is one.
  template <typename... Rounds> void tighten(Crossing_loop& loop, Rounds... rounds) const {
    if(options.do_tighten)
      Loop_tightening(execution, mesh).tighten(loop, rounds...);
  }
};

/// For each of several disjoint contours the way from its left side around to its right side
/// (paper, 4.2): it crosses this contour once, and none that comes later.
template <typename Backend> class Tunnel_pass
{
public:
  Tunnel_pass(const Pass_context<Backend>& context,
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
  std::size_t share_of_updates(std::size_t number_of_loops) const {
    return context_.share_of_updates(number_of_loops, Pass_options::fields_of_tunnels);
  }

  // Two fronts for each loop. The loops share a number of updates; those for which that is not
  // enough share it once more. Returns the loops that are left when most would need more than their
  // share, as a sample tells before much is spent.
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
  // again: many loops around few edges, or some with no way at all along edges. Where it finds no
  // way, the sweep has one.
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
  }

  void set_tunnel(Index k, const std::vector<Index>& walk) {
    CGAL_assertion_msg(tunnels_[k].empty(), "a tunnel is looked for until it is found");
    tunnels_[k] = pushed_left(context_.mesh, walk);
    context_.tighten(tunnels_[k]);
    context_.progress.advance_one(tunnels_.size());
  }

  const Pass_context<Backend>& context_;
  const std::vector<Crossing_loop>& contours_;
  const Crossing_index& index_;
  std::vector<Crossing_loop> tunnels_;
};

/// For each tunnel the way from its left side around to its right side (paper, 4.3), which becomes
/// the handle if it is shorter and the loops remain a basis. Where they would not, because the
/// tunnels of several pairs led to one handle, the next best way is tried.
template <typename Backend> class Refinement_pass
{
public:
  /// \p contours is the index of the contours that cross each tunnel as `Tunnel_pass` says.
  Refinement_pass(const Pass_context<Backend>& context,
                  std::vector<Crossing_loop>& handles,
                  const std::vector<Crossing_loop>& tunnels,
                  const Crossing_index& contours)
      : context_(context)
      , handles_(handles)
      , tunnels_(tunnels)
      , index_(context.mesh, tunnels)
      , exchange_(tunnels, contours, index_)
      , candidates_(tunnels.size())
      , is_refined_(tunnels.size(), 0) {
    CGAL_precondition(handles.size() == tunnels.size());
  }

  /// refines the handles. Returns how many had to be kept although shorter ones were found.
  std::size_t run() {
    find_candidates();
    std::vector<Index> open = all_loops();
    for(std::size_t i = 0, ready = 0; i < number_of_candidates && !open.empty(); ++i) {
      if(i == ready)
        ready = tighten_candidates(open, i);
      open = replace_handles(open, i);
    }
    return open.size();
  }

  /// by handle, whether it was replaced.
  const std::vector<char>& is_refined() const { return is_refined_; }

private:
  // How many refinements of a handle are tried.
  static constexpr Index number_of_candidates = 6;

  std::vector<Index> all_loops() const {
    std::vector<Index> numbers(tunnels_.size());
    std::iota(numbers.begin(), numbers.end(), Index(0));
    return numbers;
  }

  void find_candidates() {
    Dual_loop_query query = {tunnels_, index_, true, all_loops(), number_of_candidates};
    query.number_of_updates =
        context_.share_of_updates(tunnels_.size(), context_.options.fields_of_refinement);
    for(const Crossing_loop& handle : handles_)
      query.numbers_of_steps.push_back(steps_along(handle));
    std::vector<Dual_walks> found = context_.dual_walks(query, 0., 0.6);
    CGAL_assertion(found.size() == handles_.size());
    context_.for_each(found.size(), [&](std::size_t k) {
      const std::vector<std::vector<Index>> walks = std::move(found[k].walks);
      for(const std::vector<Index>& walk : walks)
        candidates_[k].push_back(pushed_left(context_.mesh, walk));
    });
  }

  // A number of steps in which two fronts together go farther than the loop is long: each passes an
  // edge length in four of the largest steps, and a geodesic crosses two edges on it.
  Time steps_along(const Crossing_loop& loop) const {
    return steps_of(static_cast<Time>(16 + loop.size() * 3 / 4), context_.searching);
  }

  // Tightens candidate i of the given handles: after the first ones, which mostly do, as many of
  // the next ones as well as there are threads that have nothing else to do. Returns the first that
  // it leaves.
  std::size_t tighten_candidates(const std::vector<Index>& numbers, std::size_t i) {
    const std::size_t spare = i == 0 ? 1 : context_.execution.number_of_threads() / numbers.size();
    const std::size_t end =
        (std::min)(i + (std::max)(spare, std::size_t(1)), std::size_t(number_of_candidates));
    context_.for_each(numbers.size() * (end - i), [&](std::size_t j) {
      std::vector<Crossing_loop>& loops = candidates_[numbers[j % numbers.size()]];
      if(i + j / numbers.size() < loops.size())
        context_.tighten(loops[i + j / numbers.size()]);
    });
    return end;
  }

  // Tries candidate i of the given handles, the largest gains first. Returns the handles that had
  // to be kept although the candidate is shorter.
  std::vector<Index> replace_handles(const std::vector<Index>& numbers, std::size_t i) {
    std::vector<double> gain(candidates_.size(), 0.);
    std::vector<char> is_gain(candidates_.size(), 0);
    std::vector<std::optional<Basis_exchange::Row>> rows(candidates_.size());
    context_.for_each(numbers.size(), [&](std::size_t j) {
      const Index k = numbers[j];
      if(i >= candidates_[k].size() || !is_shorter(context_.mesh, candidates_[k][i], handles_[k]))
        return;
      is_gain[k] = 1;
      gain[k] = length(context_.mesh, handles_[k]) - length(context_.mesh, candidates_[k][i]);
      rows[k] = exchange_.handle_part(candidates_[k][i]);
    });
    std::vector<Index> order = numbers;
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return gain[a] > gain[b]; });
    std::vector<Index> kept;
    for(Index k : order) {
      if(!is_gain[k])
        continue;
      is_refined_[k] = rows[k] && exchange_.accept(k, *rows[k]);
      if(is_refined_[k])
        handles_[k] = std::move(candidates_[k][i]);
      else
        kept.push_back(k);
    }
    return kept;
  }

  const Pass_context<Backend>& context_;
  std::vector<Crossing_loop>& handles_;
  const std::vector<Crossing_loop>& tunnels_;
  Crossing_index index_; // of the tunnels
  Basis_exchange exchange_;
  std::vector<std::vector<Crossing_loop>> candidates_; // by tunnel
  std::vector<char> is_refined_;
};

/*!
The passes on arrival times: handles are read off them exactly, and loops are tightened.

\tparam Backend computes the fields of the passes on one mesh, and what is read off them where they
  are: in the memory of the processor or of a device. All that leaves it are arrays of times, and
  loops. `Host_backend`, `device::Solver`, or `Fallback_backend` for whichever is there: they give
  the same answers to the last bit. `device::Solver` says what the functions do; each throws
  `Interrupted_exception` when its callback says so.
*/
template <typename Backend> class Field_passes : public Passes
{
public:
  /// makes the backend, which may take a while, when it is needed first.
  using Make_backend = std::function<std::unique_ptr<Backend>()>;

  /// \p seeds are the vertices to start from, one in each component; the backend finds first cells
  /// where there are \p least_vertices_for_cells vertices.
  Field_passes(Execution execution,
               const Flat_mesh& mesh,
               std::vector<Index> seeds,
               const Pass_options& options,
               Make_backend make_backend,
               std::size_t least_vertices_for_cells = (std::numeric_limits<std::size_t>::max)())
      : execution_(execution)
      , mesh_(mesh)
      , seeds_(std::move(seeds))
      , options_(options)
      , coefficients_(step_coefficients(options.field_constants))
      , make_backend_(std::move(make_backend))
      , least_vertices_for_cells_(least_vertices_for_cells) {}

  bool find_first_cells(First_cells& cells, Statistics& statistics) override {
    if(mesh_.number_of_vertices() < least_vertices_for_cells_)
      return false;
    try {
      make_backend();
      const bool have_found = backend_->find_first_cells(cells);
      if(have_found)
        backend_->report(statistics);
      return have_found;
    } catch(const Device_exception&) { // there may be room for a coarse mesh
      backend_.reset();
      return false;
    }
  }

  void initial_pass(Progress& progress, Statistics& statistics) override {
    make_backend();
    candidates_ = backend_->initial_field(seeds_, coefficients_, [&](double part) {
      progress.advance(part);
      return true;
    });
    CGAL_postcondition_msg(candidates_.size() == mesh_.genus, "as many handles as the genus");
    statistics.swept_handles = candidates_.size();
    keep_what_is_asked_for(statistics);
    backend_->report(statistics);
    for(Handle_candidate& candidate : candidates_)
      contours_.push_back(std::move(candidate.loop));
    handles_ = contours_;
    is_refined_.assign(handles_.size(), 0);
    const auto context = context_with(progress);
    context.for_each(handles_.size(),
                     [&](std::size_t k) { context.tighten(handles_[k], few_rounds); });
  }

  Swept_vertices take_swept_vertices() override { return std::move(swept_); }

  void tunnel_pass(Progress& progress, Statistics& statistics) override {
    const auto context = context_with(progress);
    contour_index_ = std::make_unique<Crossing_index>(mesh_, contours_);
    tunnels_ = Tunnel_pass<Backend>(context, contours_, *contour_index_).run();
    CGAL_assertion(tunnels_.size() == handles_.size());
    std::vector<Time> times;
    for(std::size_t k = 0; k < tunnels_.size(); ++k)
      if(tunnels_[k].empty()) {
        ++statistics.kept_sweep_tunnels;
        if(times.empty())
          times = backend_->arrival_times();
        tunnels_[k] = descending_tunnel(mesh_, Arrival_order(times), candidates_[k]);
        context.tighten(tunnels_[k]);
      }
    statistics.traced_tunnels = tunnels_.size() - statistics.kept_sweep_tunnels;
    CGAL_expensive_postcondition(are_tunnels_of_contours());
    contours_ = {};
    backend_->report(statistics);
  }

  void refinement_pass(Progress& progress, Statistics& statistics) override {
    const auto context = context_with(progress);
    Refinement_pass<Backend> pass(context, handles_, tunnels_, *contour_index_);
    statistics.kept_sweep_handles = pass.run();
    is_refined_ = pass.is_refined();
    statistics.refined_handles = static_cast<std::size_t>(
        std::count_if(is_refined_.begin(), is_refined_.end(), [](char c) { return c != 0; }));
    backend_->report(statistics);
  }

  void shorten(Progress& progress) override {
    const auto context = context_with(progress);
    context.for_each(handles_.size(), [&](std::size_t k) {
      if(!is_refined_[k])
        context.tighten(handles_[k]);
      Gauss_reduction(context.execution, mesh_).reduce(handles_[k], tunnels_[k]);
      progress.advance_one(handles_.size());
    });
    if(!options_.is_coarse)
      Dual_loop_improvement(context.execution, mesh_, progress).improve(handles_, tunnels_);
  }

  std::vector<Flat_pair> take_pairs() override {
    CGAL_assertion(handles_.size() == tunnels_.size());
    std::vector<Flat_pair> pairs(handles_.size());
    for(std::size_t k = 0; k < pairs.size(); ++k)
      pairs[k] = {std::move(handles_[k]), std::move(tunnels_[k])};
    return pairs;
  }

  std::vector<Time> diffusion(const std::vector<Index>& vertices,
                              Progress& progress,
                              Statistics& statistics) override {
    make_backend();
    std::vector<Time> times =
        backend_->times_from_vertices(vertices, coefficients_, [&](double part) {
          progress.advance(part);
          return true;
        });
    backend_->report(statistics);
    return times;
  }

private:
  // Most contours are replaced in the refinement pass; until then it is enough to know about how
  // long they will be.
  static constexpr std::size_t few_rounds = 3;

  void keep_what_is_asked_for(Statistics& statistics) {
    if(options_.do_log_fronts || options_.do_keep_layers) {
      Front_log log = backend_->front_log();
      if(options_.do_log_fronts)
        statistics.front_events = std::move(log.events);
      if(options_.do_keep_layers)
        swept_.layers = std::move(log.layer);
    }
    if(options_.do_keep_times)
      swept_.times = times_in_steps(backend_->arrival_times());
  }

  void make_backend() {
    if(backend_ == nullptr)
      backend_ = make_backend_();
  }

  // Whether each tunnel crosses its contour once and none that was found later.
  bool are_tunnels_of_contours() const {
    for(Index k = 0; k < tunnels_.size(); ++k)
      if(!is_dual(contour_index_->intersections(tunnels_[k]), k, Loops_from{k}))
        return false;
    return true;
  }

  Pass_context<Backend> context_with(Progress& progress) const {
    return {execution_.watched_by(progress),           mesh_,    *backend_,
            coefficients_for_searching(coefficients_), options_, progress};
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  std::vector<Index> seeds_;
  Pass_options options_;
  Step_coefficients coefficients_;
  Make_backend make_backend_;
  std::size_t least_vertices_for_cells_;
  std::unique_ptr<Backend> backend_;
  Swept_vertices swept_;
  std::vector<Handle_candidate> candidates_; // their loops are the contours
  std::vector<Crossing_loop> contours_, handles_, tunnels_;
  std::vector<char> is_refined_; // by handle
  std::unique_ptr<Crossing_index> contour_index_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_FIELD_PASSES_H
