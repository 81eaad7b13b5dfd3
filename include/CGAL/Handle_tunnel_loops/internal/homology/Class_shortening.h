// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_SHORTENING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_SHORTENING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Bounding_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Class_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_sides.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Neighbor_sums.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Search_ground.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Looks for shorter bases of L_in and of L_out, and of H1 where these are not known.

Candidates for each loop are the shortest that cross its partner once and, if its pair is pure, no
loop of its own kind but for a net number of zero: so they are of the same subgroup. All of them are
tightened; then, the shortest first, each takes the place of the longest loop that can be replaced
by it. That is the greedy algorithm for the lightest basis, but for what is not found, and for
coordinates other than 1 and -1.

The loops are a basis after each exchange, so that it can end at any time.
*/
class Class_shortening
{
public:
  /// Long loops are searched for on a coarse mesh, if there is one. \p effort multiplies the visits
  /// of vertices that are allowed.
  Class_shortening(Execution execution,
                   const Flat_mesh& mesh,
                   const Coarse_mesh* coarse,
                   double effort,
                   Progress& progress)
      : execution_(execution)
      , mesh_(mesh)
      , effort_(effort)
      , vertices_of_coarse_mesh_(coarse == nullptr ? 0. : double(coarse->mesh.number_of_vertices()))
      , fine_ground_(mesh)
      , progress_(progress) {
    if(coarse != nullptr)
      coarse_ground_.emplace(*coarse);
  }

  /// from now on the loops of pairs need not cross once.
  void forget_pairs() { are_pairs_kept_ = is_the_rest_short_ = false; }

  /// puts short loops that bound in the place of others, where there are so many that not each can
  /// be searched for; see `Bounding_loops`. That is done even if no time is left: else loops may be
  /// a hundred times as long, and what follows takes as much time. The loops of pairs need not
  /// cross once after that. Returns the sides of all loops then, or nothing if none has been
  /// replaced.
  std::optional<Loop_sides> take_bounding_loops(std::vector<Crossing_loop>& loops,
                                                const Loop_sides& sides) {
    take(loops);
    if(loops.size() < many_loops || visits() <= 0.)
      return std::nullopt;
    prepare(std::vector<char>(loops.size(), 0));
    Bounding_loops bounding(execution_, mesh_, coarse_ground_ ? *coarse_ground_ : fine_ground_,
                            progress_);
    std::optional<Loop_sides> changed = bounding.take(loops, sides, sources_);
    forget_searches();
    is_the_rest_short_ = changed && bounding.are_there_all();
    return changed;
  }

  /// by loop the number that it had before what was last done, or `no_index` if it is new.
  const std::vector<Index>& sources() const { return sources_; }

  /// \p loops are handles and tunnels in turn, of which \p is_pure says by pair whether they bound
  /// on their sides, and \p is_new by loop which have not been made short at all. Returns by loop
  /// the number that it had before, or `no_index` if it is new.
  std::vector<Index> run(std::vector<Crossing_loop>& loops,
                         const std::vector<char>& is_pure,
                         const std::vector<char>& is_new) {
    is_pure_ = &is_pure;
    take(loops);
    if(!progress_.time().is_any_left())
      return std::move(sources_);
    prepare(is_new);
    if(is_the_rest_short_)
      is_fresh_ = is_new;
    // Loops that have just been put together have been seen by nothing, the others by a field, or
    // among the shortest that bound. On a small mesh there is enough for all of them at once.
    const double number_of_new = double(std::count(is_new.begin(), is_new.end(), 1));
    if(!is_small() || is_the_rest_short_) {
      open([&](Index i) { return is_new[i] != 0; });
      repeat((std::max)(visits(), visits_for_new() * number_of_new / (number_of_new + 8.)),
             part_while_it_pays * visits_for_new());
    }
    if(visits() > least_visits * double(loops.size())) {
      double left = visits();
      if(!is_the_rest_short_) {
        open([](Index) { return true; });
        overestimate_ = 1.;
        left = repeat(visits());
      }
      search_long_ones((std::max)(part_for_long_ones * left, least_for_long_ones * visits()));
      take_sums();
    }
    return std::move(sources_);
  }

private:
  void take(std::vector<Crossing_loop>& loops) {
    loops_ = &loops;
    sources_.resize(loops.size());
    std::iota(sources_.begin(), sources_.end(), Index(0));
  }

  void prepare(const std::vector<char>& is_new) {
    measure();
    prepare_search(is_new);
    patience_.assign(is_new.size(), 1.);
    is_known_.assign(is_new.size(), 0);
    is_open_.assign(is_new.size(), 0);
    is_fresh_.assign(is_new.size(), 1);
    overestimate_ = 1.;
  }

  using Candidate = Loop_candidate; // of the loops before the round

  static constexpr std::size_t many_loops = 32;
  static constexpr int most_rounds = 10;
  // So much longer, at most, is a walk on the edges than the loop that it is pulled to.
  static constexpr double refined_edges = 1.3, poor_edges = 1.4;

  static constexpr double much_shorter = 0.99, hardly_shorter = 0.997;

  static constexpr double most_visits = 2e6, most_on_large_mesh = 1.6e6;
  static constexpr double most_overestimate = 4.;    // that is made use of
  static constexpr double least_visits = 200.;       // of a loop, that could find anything
  static constexpr double larger_part = 3.;          // of a part before
  static constexpr double part_on_coarse = 0.6;      // of visits
  static constexpr double part_while_it_pays = 2.;   // of visits for new loops, beside these
  static constexpr double gain_worth_visits = 0.999; // in a round
  static constexpr double few_vertices = 40000., many_vertices = 200000.;
  static constexpr double most_patience = 8.;         // visits over those that are expected
  static constexpr double part_for_small_cells = 0.1; // of visits, at most
  static constexpr double around_tube = 4.; // the longest loop that cells may be made for, over it
  static constexpr double much_longer = 2.; // than others
  static constexpr double part_for_long_ones = 0.25, part_after_sums = 0.1;
  static constexpr double least_for_long_ones = 0.05; // of visits, also if none are left
  static constexpr double visits_of_vertex = 4.;      // by a lean search, with what distances take
  static constexpr double crossings_for_visit = 32.;  // at most, on sums

  bool is_small() const { return double(mesh_.number_of_vertices()) <= few_vertices; }

  bool is_refined() const { return is_small() && !coarse_ground_; } // to be searched through

  // On a large mesh, less: its loops have cost more before, and are not to wait as long again. On a
  // coarse one visits go farther.
  double visits() const {
    const double part = part_of_vertices(few_vertices);
    return effort_ * (coarse_ground_ ? part_on_coarse : 1.) *
           (std::min)(most_visits, 2. * most_visits * part * std::sqrt(part));
  }

  // As many, at least, as to go over a coarse mesh once.
  double visits_for_new() const {
    if(!coarse_ground_)
      return effort_ * most_on_large_mesh;
    return effort_ *
           (std::max)(part_on_coarse * most_on_large_mesh * part_of_vertices(many_vertices),
                      vertices_of_coarse_mesh_);
  }

  double part_of_vertices(double number) const {
    return (std::min)(1., number / double(mesh_.number_of_vertices()));
  }

  // Before much memory is taken for something else.
  void forget_searches() {
    classes_.reset();
    candidates_ = {};
    fine_ground_.forget();
    if(coarse_ground_)
      coarse_ground_->forget();
  }

  // Loops that have just been put together do not tell how short they will be.
  void prepare_search(const std::vector<char>& is_new) {
    if(std::exchange(is_prepared_, true))
      return;
    const bool is_any_new = std::find(is_new.begin(), is_new.end(), 1) != is_new.end();
    if(is_refined())
      fine_ground_.levels().refine(
          is_any_new ? 0. : *std::min_element(lengths_.begin(), lengths_.end()));
    fine_ground_.levels().prepare(execution_, visits());
    if(coarse_ground_) {
      coarse_ground_->levels().prepare(execution_, std::numeric_limits<double>::infinity());
      longest_on_fine_ground_ = least_length_on_coarse_mesh(mesh_);
    }
  }

  // Where to look for loops of some length.
  struct Scale
  {
    Search_ground* ground;
    int level;
  };

  // If there are visits enough, cells are small beside the tube around which the partner runs, too.
  Scale scale(double length, Index partner) {
    Search_ground& ground =
        coarse_ground_ && length >= longest_on_fine_ground_ ? *coarse_ground_ : fine_ground_;
    return {&ground, ground.levels().level(is_thorough_ || is_the_rest_short_
                                               ? (std::min)(length, around_tube * lengths_[partner])
                                               : length)};
  }

  // Where it is not known what bounds, no class is better than another.
  bool is_to_be_shortened(Index i) const { return (*is_pure_)[i / 2] || !are_pairs_kept_; }

  // Most is to be gained from long loops. There may be some for which only the likely tasks were
  // done; and where one passes a row of holes, these are all in one cell if cells are as large as
  // the loop suggests. Among small ones a lean search is all that there are visits for.
  void search_long_ones(double visits) {
    open_long_ones([this](Index i) { return is_known_[i] == 0; });
    repeat(visits);
    const std::vector<double> patience =
        std::exchange(patience_, std::vector<double>(loops_->size(), visits_of_vertex));
    overestimate_ = 1.;
    is_lean_ = true;
    open_long_ones([](Index) { return true; });
    repeat(visits);
    is_lean_ = false;
    overestimate_ = 1.;
    patience_ = patience;
  }

  template <typename Predicate> void open_long_ones(const Predicate& is_wanted) {
    const double enough = much_longer * total_length() / double(lengths_.size());
    open([&](Index i) { return lengths_[i] > enough && is_wanted(i); });
  }

  template <typename Predicate> void open(const Predicate& is_wanted) {
    for(Index i = 0; i < lengths_.size(); ++i)
      is_open_[i] = is_to_be_shortened(i) && is_wanted(i);
  }

  // Sums of loops, a search for those that have taken the place of others, and sums of these.
  void take_sums() {
    work_for_sums_ = shares_by_size(*loops_, crossings_for_visit * visits());
    const double before = total_length();
    std::fill(is_open_.begin(), is_open_.end(), 0);
    sweep_sums();
    if(total_length() < hardly_shorter * before && is_enough(part_after_sums * visits())) {
      repeat(part_after_sums * visits());
      sweep_sums();
    }
  }

  // For the open loops; with less, none is looked for to its end.
  bool is_enough(double visits) const {
    return visits > least_visits * double(std::count(is_open_.begin(), is_open_.end(), 1));
  }

  // As long as it pays.
  void sweep_sums() {
    for(double before = (std::numeric_limits<double>::max)();
        total_length() < hardly_shorter * before && progress_.time().is_any_left();)
    {
      before = total_length();
      if(!find_sums())
        return;
      exchange();
    }
  }

  // Looks for the open loops, and for those that are opened by it, as long as there are visits. A
  // round that gains something is given back what it took, as far as what is to spare goes. Returns
  // how many visits are left.
  double repeat(double visits) { return repeat(visits, (std::max)(0., visits_for_new() - visits)); }

  double repeat(double visits, double spare) {
    part_ = 0.;
    for(int round = 0; round < most_rounds && visits > 0.; ++round) {
      const double before = total_length(), share = visits;
      visits -= double(size_of_loops());
      if(visits <= 0. || !is_any_open() || !progress_.time().is_any_left() ||
         !find_candidates(visits))
        break;
      exchange();
      // It goes on as long as it pays.
      if((are_all_searched_ || is_the_rest_short_) && total_length() > hardly_shorter * before)
        break;
      if(total_length() < gain_worth_visits * before) {
        const double more = (std::max)(0., (std::min)(spare, share - visits));
        visits += more;
        spare -= more;
      }
    }
    return visits;
  }

  bool is_any_open() const {
    return std::find(is_open_.begin(), is_open_.end(), 1) != is_open_.end();
  }

  // What it takes to find out about classes, before anything is visited.
  std::size_t size_of_loops() const {
    return std::accumulate(loops_->begin(), loops_->end(), std::size_t(0),
                           [](std::size_t sum, const Crossing_loop& l) { return sum + l.size(); });
  }

  double total_length() const { return std::accumulate(lengths_.begin(), lengths_.end(), 0.); }

  // About the vertices within half the length of a loop.
  double vertices_around(Index i, Index partner) {
    const auto [ground, level] = scale(part_ * lengths_[i], partner);
    return ground->vertices_around(level, lengths_[i], (*loops_)[i]);
  }

  void measure() {
    lengths_.resize(loops_->size());
    for_each_index(
        execution_, lengths_.size(),
        [this](std::size_t i) { lengths_[i] = length(mesh_, (*loops_)[i]); }, 16);
  }

  // A loop to search along, for loops of about the same length that have to cross it.
  struct Task
  {
    Index partner;
    double length; // of the longest target
    std::vector<Index> targets;
    Search_effort effort = {};
    std::size_t left = 0; // of the visits that are allowed
  };

  // Every curve with a coordinate in a loop crosses one of the loops in the dual class. Those among
  // them that the loop crosses itself are the likely ones: it lies there.
  std::vector<Task> tasks(const std::vector<Class_vector>& duals, bool are_all_likely) const {
    std::map<std::pair<Index, int>, Task> tasks; // by partner and size
    for(Index i = 0; i < loops_->size(); ++i)
      if(is_open_[i] && lengths_[i] > 0.)
        for(const auto& c : duals[i]) {
          if(are_all_likely && coordinate(classes_->row(i), c.first) == 0)
            continue;
          const int size = half_octave(lengths_[i]);
          Task& task = tasks.try_emplace({c.first, size}, Task{c.first, 0., {}}).first->second;
          task.length = (std::max)(task.length, lengths_[i]);
          task.targets.push_back(i);
        }
    std::vector<Task> all;
    for(auto& entry : tasks)
      all.push_back(std::move(entry.second));
    return all;
  }

  // All tasks thoroughly if there are visits enough, else all, or the likely ones; and what is
  // spent on each. Of a lean search it is the likely ones in any case.
  std::vector<Task> tasks_within(double visits, const std::vector<Class_vector>& duals) {
    const double least_part = (std::min)(1., larger_part * part_);
    const double expected = overestimate_ * visits;
    std::vector<Task> chosen = tasks(duals, is_lean_);
    part_ = 1.;
    is_thorough_ = true;
    are_all_tasks_ = !is_lean_;
    Search_plan efforts =
        plan_of_part(chosen, (is_lean_ ? 1. : part_for_small_cells) * expected, part_);
    if(!is_lean_ && efforts.is_tight()) {
      is_thorough_ = false;
      efforts = plan(chosen, expected, least_part);
      are_all_tasks_ = !efforts.is_tight();
      if(!are_all_tasks_) {
        chosen = tasks(duals, true);
        efforts = plan(chosen, expected, least_part);
      }
    }
    for(std::size_t n = 0; n < chosen.size(); ++n)
      chosen[n].effort = efforts.effort(n);
    return chosen;
  }

  // Where loops are much longer than need be, there is not enough for all: then shorter ones are
  // looked for first, since discs grow with the square.
  Search_plan plan(const std::vector<Task>& tasks, double visits, double least_part) {
    constexpr double smallest_part = 0.1;
    for(part_ = 1.;; part_ /= larger_part) {
      const Search_plan plan = plan_of_part(tasks, visits, part_);
      if(!plan.is_tight() || part_ < larger_part * (std::max)(least_part, smallest_part))
        return plan;
    }
  }

  Search_plan plan_of_part(const std::vector<Task>& tasks, double visits, double part) {
    std::vector<double> discs, places;
    for(const Task& task : tasks) {
      double disc = 0.;
      for(Index i : task.targets)
        disc = (std::max)(disc, patience_[i] * vertices_around(i, task.partner));
      discs.push_back(part * part * disc);
      places.push_back(lengths_[task.partner] / (part * task.length));
    }
    return Search_plan(discs, places, visits);
  }

  // Returns whether anything was looked for.
  bool find_candidates(double& visits) {
    classes_ = std::make_unique<Loop_classes>(execution_, mesh_, *loops_);
    const std::vector<Class_vector> duals = dual_classes();
    std::vector<Task> tasks = tasks_within(visits, duals);
    prepare_grounds(tasks);
    std::vector<std::vector<Candidate>> found(tasks.size());
    const std::size_t patience = patience_within(visits, tasks);
    for_each_index(
        execution_, tasks.size(),
        [&](std::size_t n) {
          Task& task = tasks[n];
          task.left = patience * task.effort.visits;
          if(task.left > 0 && progress_.goes_on() && progress_.time().is_any_left())
            found[n] = candidates(task, duals);
        },
        1);
    progress_.throw_if_interrupted();
    close_loops(tasks, patience, visits);
    take_candidates(found);
    return std::any_of(tasks.begin(), tasks.end(),
                       [](const Task& task) { return task.effort.visits > 0; });
  }

  void prepare_grounds(const std::vector<Task>& tasks) {
    std::map<Search_ground*, std::set<int>> levels;
    for(const Task& task : tasks)
      if(task.effort.visits > 0) {
        const auto [own, level] = scale(part_ * task.length, task.partner);
        levels[own].insert(level);
      }
    for(const auto& [ground, used] : levels)
      ground->prepare(execution_, used, *loops_, classes_->edge_crossings(),
                      random_weights(*is_pure_));
  }

  // By how much more is allowed than expected, which may be too little: a search that has to be
  // begun again costs all of it once more.
  static std::size_t patience_within(double visits, const std::vector<Task>& tasks) {
    double planned = 1.;
    for(const Task& task : tasks)
      planned += double(task.effort.visits);
    return static_cast<std::size_t>(std::clamp(0.3 * visits / planned, 1., most_patience));
  }

  // What has been searched to its end is closed. Takes what was spent from the visits.
  void close_loops(const std::vector<Task>& tasks, std::size_t patience, double& visits) {
    std::vector<char> is_exhausted(loops_->size(), 0), is_left_out(loops_->size(), 0);
    double planned_for_all = 0., spent = 0.;
    for(const Task& task : tasks) {
      const std::size_t planned = task.effort.visits;
      planned_for_all += double(planned);
      spent += double(patience * planned - task.left);
      for(Index i : task.targets)
        if(planned == 0)
          is_left_out[i] = 1; // the others may leave something
        else if(task.left == 0)
          is_exhausted[i] = 1; // it takes more than was thought
    }
    visits -= spent;
    overestimate_ = (std::min)(most_overestimate, planned_for_all / (std::max)(1., spent));
    are_all_searched_ = part_ == 1.;
    for(Index i = 0; i < is_open_.size(); ++i) {
      is_known_[i] = is_open_[i] ? are_all_tasks_ : is_known_[i];
      are_all_searched_ = are_all_searched_ && !is_exhausted[i] && !is_left_out[i];
      patience_[i] *= is_exhausted[i] ? 4. : 1.;
      is_open_[i] = is_exhausted[i] || is_left_out[i] || (is_open_[i] && part_ < 1.);
    }
  }

  // Of the open loops; none where numbers are too large, for which nothing is looked for then.
  std::vector<Class_vector> dual_classes() {
    std::vector<Class_vector> duals(loops_->size());
    for_each_index(
        execution_, duals.size(),
        [&](std::size_t i) {
          if(is_open_[i])
            if(std::optional<Class_vector> dual =
                   classes_->class_with({{static_cast<Index>(i), 1}}))
              duals[i] = std::move(*dual);
        },
        16);
    return duals;
  }

  std::vector<Candidate> candidates(Task& task, const std::vector<Class_vector>& duals) {
    const bool is_pure = (*is_pure_)[task.partner / 2], is_tunnel = task.partner % 2 == 0;
    std::vector<Search_targets::Target> wanted;
    for(Index i : task.targets)
      wanted.push_back(
          {part_ * (is_refined() ? refined_edges : poor_edges) * lengths_[i], &duals[i]});
    Search_targets targets(std::move(wanted));
    const Scale own = scale(part_ * task.length, task.partner);
    own.ground->search(own.level, task.partner,
                       {is_pure && is_tunnel, is_lean_, task.effort.spacing}, targets, task.left);
    const std::vector<Search_targets::Found> found = targets.take_found();
    std::vector<std::optional<Candidate>> tightened(found.size());
    for_each_index(
        execution_, found.size(),
        [&](std::size_t i) {
          if(found[i].walk.size() < 3)
            return;
          double limit = 0.;
          for(Index t : found[i].targets)
            limit = (std::max)(limit, lengths_[task.targets[t]]);
          if(std::optional<Crossing_loop> loop =
                 own.ground->tightened(execution_, found[i].walk, limit))
            tightened[i] = candidate(std::move(*loop));
        },
        1);
    std::vector<Candidate> candidates;
    for(std::optional<Candidate>& c : tightened)
      if(c && !(is_pure && !is_of_kind(c->numbers, is_tunnel)))
        candidates.push_back(std::move(*c));
    return candidates;
  }

  std::optional<Candidate> candidate(Crossing_loop loop) const {
    Class_vector numbers = classes_->numbers(loop);
    return Candidate::of(mesh_, std::move(loop), std::move(numbers), *classes_);
  }

  // Shorter sums of two loops, at least one of which is fresh. Returns whether there are any.
  bool find_sums() {
    classes_ = std::make_unique<Loop_classes>(execution_, mesh_, *loops_);
    const Crossing_index index(mesh_, *loops_);
    Workspace_pool<Neighbor_sums> neighbor_sums([&] {
      return std::make_unique<Neighbor_sums>(execution_, mesh_, *loops_, index, lengths_);
    });
    std::vector<std::vector<Candidate>> found(loops_->size());
    for_each_index(
        execution_, loops_->size(),
        [&](std::size_t i) {
          if(progress_.goes_on() && progress_.time().is_any_left())
            found[i] = sums(static_cast<Index>(i), *neighbor_sums.borrow());
        },
        1);
    progress_.throw_if_interrupted();
    std::fill(is_fresh_.begin(), is_fresh_.end(), 0);
    take_candidates(found);
    return !candidates_.empty();
  }

  std::vector<Candidate> sums(Index i, Neighbor_sums& sums) {
    std::vector<Candidate> candidates;
    if(!is_to_be_shortened(i) || (is_the_rest_short_ && !is_fresh_[i]))
      return candidates;
    for(Crossing_loop& loop : sums.of(i, work_for_sums_[i], [&](Index j) {
          const bool is_same_kind = i % 2 == j % 2 && (*is_pure_)[j / 2];
          return (is_fresh_[i] || is_fresh_[j]) && (is_same_kind || !are_pairs_kept_);
        }))
      if(std::optional<Candidate> c = candidate(std::move(loop)))
        candidates.push_back(std::move(*c));
    return candidates;
  }

  void take_candidates(std::vector<std::vector<Candidate>>& found) {
    candidates_.clear();
    for(std::vector<Candidate>& part : found)
      std::move(part.begin(), part.end(), std::back_inserter(candidates_));
  }

  // Whether a curve crosses only loops of the other kind.
  static bool is_of_kind(const Class_vector& numbers, bool is_tunnel) {
    return std::all_of(numbers.begin(), numbers.end(),
                       [&](const auto& c) { return (c.first % 2 == 1) != is_tunnel; });
  }

  void exchange() {
    std::stable_sort(candidates_.begin(), candidates_.end());
    Class_exchange exchange(*classes_);
    Pairing pairing(loops_->size() / 2);
    for(Index k = 0; k < loops_->size() / 2; ++k)
      pairing.match(k, k);
    std::vector<char> is_changed(loops_->size(), 0);
    for(Candidate& c : candidates_)
      try_candidate(c, exchange, pairing, is_changed);
    apply(pairing, is_changed);
  }

  void try_candidate(Candidate& c,
                     Class_exchange& exchange,
                     Pairing& pairing,
                     std::vector<char>& is_changed) {
    const std::optional<Class_vector> x = exchange.coordinates(c.coordinates);
    if(!x)
      return;
    for(Index i : replaceable(*x, c.length, lengths_))
      if(can_pair(c, i, exchange, pairing)) {
        // There is nothing new to be found for a loop in place of one of its class, about as long.
        if(x->size() > 1 || c.length < much_shorter * lengths_[i])
          is_changed[i] = 1;
        exchange.replace(i, c.coordinates, *x);
        open_others(*x, i);
        (*loops_)[i] = std::move(c.loop);
        lengths_[i] = c.length;
        sources_[i] = no_index;
        is_fresh_[i] = 1;
        return;
      }
  }

  // Of a loop with a coordinate in what has taken the place of another, the dual class is another
  // now, and with it what can replace that loop.
  void open_others(const Class_vector& coordinates, Index replaced) {
    for(const auto& [i, value] : coordinates)
      if(i != replaced)
        is_open_[i] = 1;
  }

  // Whether each pair still crosses once, perhaps with other partners, if loop `i` is replaced.
  bool
  can_pair(const Candidate& c, Index i, const Class_exchange& exchange, Pairing& pairing) const {
    if(!are_pairs_kept_)
      return true;
    const Index k = i / 2;
    const bool is_tunnel = i % 2 == 1;
    const Index partner = is_tunnel ? 2 * pairing.row_of(k) : 2 * pairing.column_of(k) + 1;
    if(std::abs(exchange.crossing(c.numbers, partner)) == 1)
      return true;
    if(!(*is_pure_)[k])
      return false;
    const auto columns = [&](Index row) {
      std::vector<Index> found = exchange.tunnels_crossed_once(
          !is_tunnel && row == k ? c.numbers : exchange.numbers(2 * row));
      if(is_tunnel) {
        found.erase(std::remove(found.begin(), found.end(), k), found.end());
        if(std::abs(exchange.crossing(c.numbers, 2 * row)) == 1)
          found.insert(std::lower_bound(found.begin(), found.end(), k), k);
      }
      return found;
    };
    Pairing other = pairing;
    const Index row = is_tunnel ? pairing.row_of(k) : k;
    other.release(row);
    if(!other.augment(row, columns))
      return false;
    pairing = other;
    return true;
  }

  // Puts the tunnels into the order of their handles, and opens what has to be looked at again.
  void apply(const Pairing& pairing, const std::vector<char>& is_changed) {
    const std::vector<Crossing_loop> loops = *loops_;
    const std::vector<Index> sources = sources_;
    const std::vector<char> is_fresh = is_fresh_;
    for(Index k = 0; k < loops.size() / 2; ++k) {
      const Index from = 2 * pairing.column_of(k) + 1, to = 2 * k + 1;
      (*loops_)[to] = loops[from];
      sources_[to] = sources[from];
      is_fresh_[to] = is_fresh[from];
      if(is_changed[2 * k] || is_changed[from] || from != to)
        is_open_[2 * k] = is_open_[to] = 1;
    }
    measure();
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  double effort_, vertices_of_coarse_mesh_;
  Search_ground fine_ground_;
  std::optional<Search_ground> coarse_ground_;
  double longest_on_fine_ground_ = 0.; // if there is a coarse one
  Progress& progress_;
  std::vector<Crossing_loop>* loops_ = nullptr;
  const std::vector<char>* is_pure_ = nullptr;
  bool is_prepared_ = false; // the grounds to search on
  bool are_pairs_kept_ = true;
  bool is_the_rest_short_ = false; // all but what has just been put together
  bool is_lean_ = false;           // the search, of long loops
  bool is_thorough_ = false;       // the search, of the round: all tasks, on small cells
  bool are_all_tasks_ = false;     // not only the likely ones, in the round
  bool are_all_searched_ = false;  // to their end, in the last round
  double part_ = 0.;               // of the length of the loops, to look for
  double overestimate_ = 1.;       // visits planned over visits needed, in the last round
  std::vector<double> lengths_;
  std::vector<Index> sources_;
  std::vector<char> is_open_;         // by loop, whether to look for candidates
  std::vector<char> is_known_;        // by loop, whether all tasks were done for it
  std::vector<char> is_fresh_;        // by loop, whether its sums are still to be tried
  std::vector<double> work_for_sums_; // by loop, what is left, in crossings
  std::vector<double> patience_;      // by loop, how many more vertices than expected to cover
  std::unique_ptr<Loop_classes> classes_;
  std::vector<Candidate> candidates_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_SHORTENING_H
