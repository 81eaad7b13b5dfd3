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
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_flat_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Band_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Initial_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Streamline.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/fields.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <CGAL/assertions.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::reference {

/// the edges that loops cross.
template <typename Iterator>
Barred_edges walls_along(const Flat_mesh& mesh, Iterator first, Iterator last) {
  Barred_edges walls(mesh.neighbor.size(), 0);
  for(; first != last; ++first)
    for(const Crossing& c : *first)
      walls[slot(mesh, c.left, c.right)] = walls[slot(mesh, c.right, c.left)] = 1;
  return walls;
}

/*!
Which handles may be replaced by other loops, so that the loops remain a basis.

Loops x are told apart by the numbers x . h_j and x . t_j with the first handles and tunnels, and
they are a basis if and only if the matrix of these numbers has the determinant one or minus one. So
a loop may take the place of one of the basis if and only if its coordinate there is one or minus
one. The inverse of the matrix, which has the coordinates, is kept up; it begins with unit rows in
the place of the loops of the first basis, which replace them one by one: the handles do not cross
each other, and tunnel t_i crosses handle i once and none with a larger number.

All numbers are integers of any size.
*/
class Handle_exchange
{
public:
  using Numbers = std::vector<int>;

  /// `with_handles[i][j]` is t_i . h_j, `with_tunnels[i][j]` is t_i . t_j.
  Handle_exchange(const std::vector<Numbers>& with_handles,
                  const std::vector<Numbers>& with_tunnels)
      : g_(with_handles.size())
      , inverse_(2 * g_, Row(2 * g_, 0)) {
    for(std::size_t i = 0; i < 2 * g_; ++i)
      inverse_[i][i] = 1;
    bool is_basis = true;
    for(std::size_t i = 0; i < g_; ++i)
      is_basis = exchange(i, with_handles[i], with_tunnels[i]) && is_basis;
    for(std::size_t i = g_; i-- > 0;) {
      Numbers crossings(g_);
      for(std::size_t j = 0; j < g_; ++j)
        crossings[j] = -with_handles[j][i];
      is_basis = replace(i, Numbers(g_, 0), crossings) && is_basis;
    }
    CGAL_precondition_msg(is_basis, "a tunnel crosses its handle once");
  }

  /// replaces handle `k` by the loop x with the given intersection numbers x . h_j and x . t_j if
  /// the loops remain a basis, and says so.
  bool replace(std::size_t k, const Numbers& with_handles, const Numbers& with_tunnels) {
    return exchange(g_ + k, with_handles, with_tunnels);
  }

private:
  using Row = std::vector<boost::multiprecision::cpp_int>;

  bool exchange(std::size_t k, const Numbers& with_handles, const Numbers& with_tunnels) {
    Row x(2 * g_, 0); // the coordinates
    for(std::size_t i = 0; i < 2 * g_; ++i)
      if(const int number = i < g_ ? with_handles[i] : with_tunnels[i - g_]; number != 0)
        for(std::size_t j = 0; j < 2 * g_; ++j)
          x[j] += number * inverse_[i][j];
    if(x[k] != 1 && x[k] != -1)
      return false;
    for(Row& row : inverse_) {
      row[k] *= x[k];
      for(std::size_t i = 0; i < row.size(); ++i)
        if(i != k && x[i] != 0)
          row[i] -= row[k] * x[i];
    }
    return true;
  }

  std::size_t g_;
  std::vector<Row> inverse_; // the tunnels come first
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
      , constants_(literal_constants(options.field_constants, rules_)) {
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
    const Crossing_index with_handles(mesh_, handles_);
    for(Index k = 0; k < handles_.size(); ++k) {
      report(progress, k);
      const std::vector<Crossing_loop> loops = loops_across(handles_[k], walls_of_tunnel(k));
      const auto tunnel = std::find_if(loops.begin(), loops.end(), [&](const Crossing_loop& loop) {
        return rules_.first_reached || is_tunnel(loop, k, with_handles);
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
    const Crossing_index with_handles(mesh_, handles_), with_tunnels(mesh_, tunnels_);
    std::optional<Handle_exchange> exchange;
    if(!rules_.refined_always)
      exchange = exchange_of_handles(with_handles, with_tunnels);
    for(Index k = 0; k < handles_.size(); ++k) {
      report(progress, k);
      const std::vector<Crossing_loop> loops =
          loops_across(tunnels_[k], walls_along(mesh_, &tunnels_[k], &tunnels_[k] + 1));
      const auto better = std::find_if(loops.begin(), loops.end(), [&](const Crossing_loop& loop) {
        if(!exchange)
          return true;
        return is_dual(with_tunnels.intersections(loop), k, Only_loop{k}) &&
               is_shorter(mesh_, loop, handles_[k]) &&
               exchange->replace(k, numbers(loop, with_handles), numbers(loop, with_tunnels));
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
  void follow_fronts(Progress& progress, Statistics& statistics) {
    initial_pass_ = std::make_unique<Initial_pass>(mesh_, constants_, seeds_, rules_);
    run(*initial_pass_, progress, statistics);
    CGAL_postcondition_msg(meetings_.size() == mesh_.genus, "as many handles as the genus");
    statistics.front_events = initial_pass_->tracker().events();
    statistics.resolution = initial_pass_->resolution();
    keep(initial_pass_->tracker().layers_of_vertices(), initial_pass_->arrivals().times());
  }

  void follow_bands(Progress& progress, Statistics& statistics) {
    Band_pass pass(mesh_, constants_, seeds_, rules_);
    run(pass, progress, statistics);
    if(meetings_.size() != mesh_.genus)
      throw Literal_failure_exception("the fronts merged " + std::to_string(meetings_.size()) +
                                      " times, but there are " + std::to_string(mesh_.genus) +
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
  template <typename Pass> void run(Pass& pass, Progress& progress, Statistics& statistics) {
    const double n = static_cast<double>(mesh_.number_of_vertices());
    try {
      for(std::size_t i = 1; !pass.is_done(); ++i) {
        pass.step();
        if(i % 16 == 0)
          progress.advance(static_cast<double>(pass.number_of_covered()) / n);
      }
    } catch(...) {
      statistics.swept_handles = pass.meetings().size();
      throw;
    }
    meetings_ = pass.meetings();
    statistics.swept_handles = meetings_.size();
  }

  std::vector<Crossing_loop> loops_across(const Crossing_loop& loop,
                                          const Barred_edges& walls) const {
    return dual_loops(mesh_, constants_, rules_, loop, walls);
  }

  // Edges that the field which looks for a tunnel may not cross.
  Barred_edges walls_of_tunnel(std::size_t k) const {
    const auto first = handles_.begin() + k;
    if(!rules_.covered_area)
      return walls_along(mesh_, first, handles_.end());
    Barred_edges walls = walls_along(mesh_, first, first + 1);
    const std::vector<char>& area = meetings_[k].area;
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      for(Index i = mesh_.row_begin[v]; i < mesh_.row_begin[v + 1]; ++i)
        if(area[v] == 0 || area[mesh_.neighbor[i]] == 0)
          walls[i] = 1;
    return walls;
  }

  Handle_exchange exchange_of_handles(const Crossing_index& with_handles,
                                      const Crossing_index& with_tunnels) const {
    std::vector<Handle_exchange::Numbers> of_handles, of_tunnels;
    for(Index k = 0; k < tunnels_.size(); ++k) {
      if(!is_tunnel(tunnels_[k], k, with_handles))
        throw Literal_failure_exception("the loop found for handle " + std::to_string(k) +
                                        " is not its tunnel loop");
      of_handles.push_back(numbers(tunnels_[k], with_handles));
      of_tunnels.push_back(numbers(tunnels_[k], with_tunnels));
    }
    return Handle_exchange(of_handles, of_tunnels);
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
  static bool is_tunnel(const Crossing_loop& loop, Index k, const Crossing_index& with_handles) {
    return is_dual(with_handles.intersections(loop), k, Loops_from{k});
  }

  // How often a loop crosses each of the handles, or of the tunnels.
  Handle_exchange::Numbers numbers(const Crossing_loop& loop, const Crossing_index& index) const {
    Handle_exchange::Numbers numbers(handles_.size(), 0);
    for(const auto& [j, number] : index.intersections(loop))
      numbers[j] = static_cast<int>(number);
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
  std::vector<Crossing_loop> handles_, tunnels_;
};

} // namespace CGAL::Handle_tunnel_loops::internal::reference

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_REFERENCE_PASSES_H
