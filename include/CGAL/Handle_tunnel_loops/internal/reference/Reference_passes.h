// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_REFERENCE_PASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_REFERENCE_PASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_lengths.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Band_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Dual_loop_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Initial_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/fields.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <CGAL/assertions.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/// Intersection numbers with the loops of a family. A loop counts one on each edge that it crosses
/// from left to right, minus one in the other direction; the sum along a closed walk on the edges
/// is the number of times, with sign, that they cross.
class Crossing_numbers
{
public:
  Crossing_numbers(const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops)
      : mesh_(mesh)
      , number_of_loops_(loops.size())
      , counts_(mesh.neighbor.size()) {
    for(Index j = 0; j < loops.size(); ++j)
      for(const Crossing& c : loops[j]) {
        counts_[slot(mesh_, c.left, c.right)].emplace_back(j, 1);
        counts_[slot(mesh_, c.right, c.left)].emplace_back(j, -1);
      }
  }

  /// the number of each loop of the family with another loop.
  std::vector<int> operator()(const Crossing_loop& loop) const {
    std::vector<int> numbers(number_of_loops_, 0);
    for_each_left_edge(loop, [&](Index u, Index v) {
      for(const auto& [j, count] : counts_[slot(mesh_, u, v)])
        numbers[j] += count;
    });
    return numbers;
  }

  /// the edges that loops from number `first` up to `last`, which is excluded, cross.
  Barred_edges walls(std::size_t first, std::size_t last) const {
    Barred_edges walls(counts_.size(), 0);
    for(std::size_t i = 0; i < counts_.size(); ++i)
      for(const auto& [j, count] : counts_[i])
        if(j >= first && j < last)
          walls[i] = 1;
    return walls;
  }

private:
  const Flat_mesh& mesh_;
  std::size_t number_of_loops_;
  std::vector<std::vector<std::pair<Index, int>>> counts_; // loop and number, by slot
};

/*!
Which handles may be replaced by other loops, so that the loops remain a basis.

The first handles h_j do not cross each other, and tunnel t_i crosses handle i once and none with a
larger number: the matrix A of the numbers t_i . h_j is triangular, with units on its diagonal. So
h_1 .. h_g, t_1 .. t_g is a basis of the first homology group, and a loop x has coordinates in it:
x = sum a_i h_i + sum b_i t_i, where x . h_j gives the b_i, and x . t_j then the a_i, by
substitution. The tunnels stay; loops in the place of the handles complete them to a basis if and
only if the matrix of their a_i has the determinant one or minus one.

All numbers are integers of any size.
*/
class Handle_exchange
{
public:
  using Integer = boost::multiprecision::cpp_int;
  using Row = std::vector<Integer>;
  using Numbers = std::vector<int>;

  /// `with_handles[i][j]` is t_i . h_j, `with_tunnels[i][j]` is t_i . t_j.
  Handle_exchange(std::vector<Numbers> with_handles, std::vector<Numbers> with_tunnels)
      : a_(std::move(with_handles))
      , t_(std::move(with_tunnels))
      , inverse_(a_.size(), Row(a_.size(), 0)) {
    for(std::size_t i = 0; i < a_.size(); ++i) {
      CGAL_precondition_msg(std::abs(a_[i][i]) == 1, "a tunnel crosses its handle once");
      inverse_[i][i] = 1;
    }
  }

  /// replaces handle `k` by the loop x with the given intersection numbers x . h_j and x . t_j if
  /// the loops remain a basis, and says so.
  bool replace(std::size_t k, const Numbers& with_handles, const Numbers& with_tunnels) {
    const Row x = times_inverse(handle_part(with_handles, with_tunnels));
    if(x[k] != 1 && x[k] != -1)
      return false;
    // x is the row in terms of the present rows; row k is what it is exchanged for.
    for(Row& row : inverse_) {
      row[k] *= x[k];
      for(std::size_t i = 0; i < row.size(); ++i)
        if(i != k && x[i] != 0)
          row[i] -= row[k] * x[i];
    }
    return true;
  }

private:
  Row handle_part(const Numbers& with_handles, const Numbers& with_tunnels) const {
    const std::size_t g = a_.size();
    // x . h_j = sum over i >= j of b_i A_ij: the last one first.
    Row b(g, 0);
    for(std::size_t j = g; j-- > 0;) {
      Integer rest = with_handles[j];
      for(std::size_t i = j + 1; i < g; ++i)
        if(a_[i][j] != 0)
          rest -= b[i] * a_[i][j];
      b[j] = rest * a_[j][j];
    }
    // x . t_j - sum b_i (t_i . t_j) = sum over i <= j of a_i (h_i . t_j) = - sum a_i A_ji.
    Row a(g, 0);
    for(std::size_t j = 0; j < g; ++j) {
      Integer rest = with_tunnels[j];
      for(std::size_t i = 0; i < g; ++i)
        if(t_[i][j] != 0)
          rest -= b[i] * t_[i][j];
      for(std::size_t i = 0; i < j; ++i)
        if(a_[j][i] != 0)
          rest += a[i] * a_[j][i];
      a[j] = -rest * a_[j][j];
    }
    return a;
  }

  Row times_inverse(const Row& row) const {
    Row product(row.size(), 0);
    for(std::size_t i = 0; i < row.size(); ++i)
      if(row[i] != 0)
        for(std::size_t j = 0; j < row.size(); ++j)
          product[j] += row[i] * inverse_[i][j];
    return product;
  }

  std::vector<Numbers> a_, t_;
  std::vector<Row> inverse_; // of the matrix of the handle parts
};

/// The passes as the paper has them. Fronts are always logged; nothing is tightened, as all loops
/// but those of the initial pass are streamlines.
class Reference_passes : public Passes
{
public:
  /// \p seeds are the vertices to start from, one in each component.
  Reference_passes(const Flat_mesh& mesh,
                   const std::vector<Index>& seeds,
                   const Pass_options& options)
      : mesh_(mesh)
      , options_(options)
      , rules_(options.literal_rules)
      , seeds_(seeds)
      , constants_(literal_constants(options.field_constants, rules_))
      , dual_loop_pass_(mesh, constants_, rules_) {
    check_rules(rules_);
  }

  void initial_pass(Progress& progress, Statistics& statistics) override {
    statistics.backend = "reference";
    if(rules_.bands)
      follow_bands(progress, statistics);
    else
      follow_fronts(progress, statistics);
    for(const Front_meeting& meeting : meetings_)
      handles_.push_back(meeting.loop);
  }

  Swept_vertices take_swept_vertices() override { return std::move(swept_); }

  /// The region that was covered when a handle was found lies to the left of all
  /// handles that were found later; these are walls, and a larger region is not barred.
  void tunnel_pass(Progress& progress, Statistics& statistics) override {
    const Crossing_numbers with_handles(mesh_, handles_);
    for(std::size_t k = 0; k < handles_.size(); ++k) {
      report(progress, k);
      const std::vector<Crossing_loop> loops =
          dual_loop_pass_.dual_loops(handles_[k], walls_of_tunnel(with_handles, k));
      const auto tunnel = std::find_if(loops.begin(), loops.end(), [&](const Crossing_loop& loop) {
        return rules_.first_reached || is_tunnel(with_handles(loop), k);
      });
      if(tunnel == loops.end() && (rules_.bands || rules_.covered_area || rules_.first_reached))
        throw Literal_failure_exception("no tunnel was found for handle " + std::to_string(k));
      ++(tunnel != loops.end() ? statistics.traced_tunnels : statistics.kept_sweep_tunnels);
      tunnels_.push_back(tunnel != loops.end() ? *tunnel : tunnel_in_covered_region(meetings_[k]));
    }
  }

  /// A refined loop takes the place of its handle if it crosses the tunnel once, is
  /// shorter, and the loops remain a basis.
  void refinement_pass(Progress& progress, Statistics& statistics) override {
    const Crossing_numbers with_handles(mesh_, handles_), with_tunnels(mesh_, tunnels_);
    std::optional<Handle_exchange> exchange;
    if(!rules_.refined_always)
      exchange = exchange_of_handles(with_handles, with_tunnels);
    for(std::size_t k = 0; k < handles_.size(); ++k) {
      report(progress, k);
      const std::vector<Crossing_loop> loops =
          dual_loop_pass_.dual_loops(tunnels_[k], with_tunnels.walls(k, k + 1));
      const auto better = std::find_if(loops.begin(), loops.end(), [&](const Crossing_loop& loop) {
        if(!exchange)
          return true;
        const Numbers numbers = with_tunnels(loop);
        return std::abs(numbers[k]) == 1 && is_shorter(mesh_, loop, handles_[k]) &&
               exchange->replace(k, with_handles(loop), numbers);
      });
      if(better == loops.end() && rules_.refined_always)
        throw Literal_failure_exception("no refined handle was found for tunnel " +
                                        std::to_string(k));
      if(better != loops.end())
        handles_[k] = *better;
      ++(better != loops.end() ? statistics.refined_handles : statistics.kept_sweep_handles);
    }
  }

  void shorten(Progress&) override {}

  std::vector<Flat_pair> take_pairs() override {
    std::vector<Flat_pair> pairs;
    for(std::size_t k = 0; k < handles_.size(); ++k)
      pairs.push_back({std::move(handles_[k]), std::move(tunnels_[k])});
    return pairs;
  }

  std::vector<Time> diffusion(const std::vector<Index>& vertices,
                              Progress& progress,
                              Statistics& statistics) override {
    statistics.backend = "reference";
    Single_field field(mesh_, constants_, Barred_edges(), rules_);
    for(Index v : vertices)
      field.add_source(v);
    for(Index v : vertices)
      for(Index u : mesh_.ring(v))
        field.add_source(u);
    const Arrivals& arrivals = field.arrivals();
    const std::size_t n = number_of_vertices_around(vertices);
    field.run(n, [&] {
      if(arrivals.number_of_steps() % 16 == 0)
        progress.advance(static_cast<double>(arrivals.number_of_reached()) /
                         static_cast<double>(n));
    });
    if(arrivals.number_of_reached() < n)
      fail_at_rest(arrivals.number_of_reached(), n);
    return fixed_point_times(mesh_, arrivals, vertices);
  }

private:
  using Numbers = Handle_exchange::Numbers;

  void follow_fronts(Progress& progress, Statistics& statistics) {
    initial_pass_ = std::make_unique<Initial_pass>(mesh_, constants_, seeds_, rules_);
    run(*initial_pass_, initial_pass_->tracker().meetings(), progress, statistics);
    meetings_ = initial_pass_->tracker().meetings();
    CGAL_postcondition_msg(meetings_.size() == mesh_.genus, "as many handles as the genus");
    statistics.front_events = initial_pass_->tracker().events();
    statistics.resolution = initial_pass_->resolution();
    keep(initial_pass_->tracker().layers_of_vertices(), initial_pass_->arrivals().times());
  }

  void follow_bands(Progress& progress, Statistics& statistics) {
    Band_pass pass(mesh_, constants_, seeds_, rules_);
    run(pass, pass.meetings(), progress, statistics);
    meetings_ = pass.meetings();
    if(meetings_.size() != mesh_.genus)
      throw Literal_failure_exception("the fronts met " + std::to_string(meetings_.size()) +
                                      " times, and there are " + std::to_string(mesh_.genus) +
                                      " handles");
    keep(pass.layers_of_vertices(), pass.times());
  }

  void keep(const std::vector<Index>& layers, const std::vector<double>& times) {
    if(options_.do_keep_layers)
      swept_.layers = layers;
    if(options_.do_keep_times)
      swept_.times = times;
  }

  // What fronts met is counted where the pass fails, too.
  template <typename Pass>
  static void run(Pass& pass,
                  const std::vector<Front_meeting>& meetings,
                  Progress& progress,
                  Statistics& statistics) {
    try {
      pass.run(progress);
    } catch(...) {
      statistics.swept_handles = meetings.size();
      throw;
    }
    statistics.swept_handles = meetings.size();
  }

  // Edges that the field which looks for a tunnel may not cross.
  Barred_edges walls_of_tunnel(const Crossing_numbers& with_handles, std::size_t k) const {
    if(!rules_.covered_area)
      return with_handles.walls(k, handles_.size());
    Barred_edges walls = with_handles.walls(k, k + 1);
    const std::vector<char>& area = meetings_[k].area;
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      for(Index i = mesh_.row_begin[v]; i < mesh_.row_begin[v + 1]; ++i)
        if(area[v] == 0 || area[mesh_.neighbor[i]] == 0)
          walls[i] = 1;
    return walls;
  }

  Handle_exchange exchange_of_handles(const Crossing_numbers& with_handles,
                                      const Crossing_numbers& with_tunnels) const {
    std::vector<Numbers> numbers = numbers_of_tunnels(with_handles);
    for(std::size_t k = 0; k < numbers.size(); ++k)
      if(!is_tunnel(numbers[k], k))
        throw Literal_failure_exception("what was found for handle " + std::to_string(k) +
                                        " is no tunnel of it");
    return Handle_exchange(std::move(numbers), numbers_of_tunnels(with_tunnels));
  }

  // In the components of the given ones.
  std::size_t number_of_vertices_around(const std::vector<Index>& vertices) const {
    std::vector<char> has_vertex(mesh_.seeds.size(), 0);
    for(Index v : vertices)
      has_vertex[mesh_.component[v]] = 1;
    return static_cast<std::size_t>(
        std::count_if(mesh_.component.begin(), mesh_.component.end(),
                      [&](Index component) { return has_vertex[component] != 0; }));
  }

  void report(Progress& progress, std::size_t k) const {
    progress.advance(static_cast<double>(k) / static_cast<double>(handles_.size()));
  }

  // Whether a loop crosses handle k once and none that was found later.
  static bool is_tunnel(const Numbers& numbers, std::size_t k) {
    return std::abs(numbers[k]) == 1 && std::all_of(numbers.begin() + k + 1, numbers.end(),
                                                    [](int number) { return number == 0; });
  }

  std::vector<Numbers> numbers_of_tunnels(const Crossing_numbers& with_loops) const {
    std::vector<Numbers> numbers;
    for(const Crossing_loop& tunnel : tunnels_)
      numbers.push_back(with_loops(tunnel));
    return numbers;
  }

  // Through what was covered before the fronts met, from behind one of them to behind the other,
  // and back over the place where they met. All of it is on the left of the later handles, and only
  // the last part crosses the handle, once: it is a tunnel on every mesh.
  Crossing_loop tunnel_in_covered_region(const Front_meeting& meeting) const {
    std::vector<Index> walk = covered_path(meeting);
    walk.push_back(meeting.saddle);
    remove_spurs(walk);
    return pushed_left(mesh_, walk);
  }

  // With the fewest edges, from one foot to the other.
  std::vector<Index> covered_path(const Front_meeting& meeting) const {
    const Arrivals& arrivals = initial_pass_->arrivals();
    std::vector<Index> next(mesh_.number_of_vertices(), no_index), queue(1, meeting.foot_b);
    next[meeting.foot_b] = meeting.foot_b;
    for(std::size_t i = 0; next[meeting.foot_a] == no_index; ++i) {
      CGAL_assertion_msg(i < queue.size(), "what is covered hangs together");
      for(Index u : mesh_.ring(queue[i]))
        if(next[u] == no_index && arrivals.rank(u) < arrivals.rank(meeting.saddle)) {
          next[u] = queue[i];
          queue.push_back(u);
        }
    }
    std::vector<Index> path(1, meeting.foot_a);
    while(path.back() != meeting.foot_b)
      path.push_back(next[path.back()]);
    return path;
  }

  const Flat_mesh& mesh_;
  Pass_options options_;
  Literal_rules rules_;
  std::vector<Index> seeds_;
  Field_constants constants_;
  std::unique_ptr<Initial_pass> initial_pass_;
  Swept_vertices swept_;
  std::vector<Front_meeting> meetings_;
  Dual_loop_pass dual_loop_pass_;
  std::vector<Crossing_loop> handles_, tunnels_;
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_REFERENCE_PASSES_H
