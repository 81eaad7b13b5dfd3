// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_INITIAL_PASS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_INITIAL_PASS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/Front_event.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Front_tracker.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/fields.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/*!
The number of handles that cannot be seen by looking at the fronts after each time step.

Fronts that are related by the events of a step, k of them before it, have merged to k - 1 handles
as far as can be seen. If there were more merges, a front has split and its parts have met again in
one step.
*/
class Handles_within_steps
{
public:
  explicit Handles_within_steps(const std::vector<Front_event>& events) {
    for(const Front_event& event : events) {
      if(event.step != step_)
        end_step();
      step_ = event.step;
      add(event);
    }
    end_step();
  }

  std::size_t number() const { return number_; }

private:
  // Fronts that are related; groups that were joined stay where they are, but empty.
  struct Group
  {
    std::size_t fronts_before = 0, merges = 0;
    std::vector<std::size_t> layers;
  };

  void end_step() {
    for(const Group& group : groups_)
      if(!group.layers.empty())
        number_ += group.merges + 1 - group.fronts_before;
    groups_.clear();
    group_of_layer_.clear();
  }

  void add(const Front_event& event) {
    if(event.before.empty())
      return;
    const std::size_t group = group_of(event.before.front().layer);
    for(const Front_event::Front& front : event.before)
      join(group, group_of(front.layer));
    for(const Front_event::Front& front : event.after)
      put(front.layer, group);
    groups_[group].merges += event.type == Front_event_type::MERGE;
  }

  std::size_t group_of(std::size_t layer) {
    const auto it = group_of_layer_.find(layer);
    if(it != group_of_layer_.end())
      return it->second;
    groups_.emplace_back();
    groups_.back().fronts_before = 1;
    put(layer, groups_.size() - 1);
    return groups_.size() - 1;
  }

  void put(std::size_t layer, std::size_t group) {
    group_of_layer_[layer] = group;
    groups_[group].layers.push_back(layer);
  }

  void join(std::size_t group, std::size_t other) {
    if(group == other)
      return;
    groups_[group].fronts_before += groups_[other].fronts_before;
    groups_[group].merges += groups_[other].merges;
    for(std::size_t layer : groups_[other].layers)
      put(layer, group);
    groups_[other] = Group();
  }

  std::size_t number_ = 0, step_ = 0;
  std::vector<Group> groups_; // of the present step
  std::map<std::size_t, std::size_t> group_of_layer_;
};

/*!
The initial pass (paper, 4.1): fields grow from one vertex in each component of the surface until
all is covered. The fields move, the arrivals say in which order the vertices are reached, and the
tracker follows the fronts vertex by vertex; when it has split or merged layers in a step, the rows
of Phi are split or merged after the step.

A merge is a contact of fronts, not of bands: two layers that were just split still overlap.
*/
class Initial_pass
{
public:
  Initial_pass(const Flat_mesh& mesh,
               const Field_constants& constants,
               const std::vector<Index>& seeds,
               const Literal_rules& rules = Literal_rules())
      : mesh_(mesh)
      , patience_(patience(constants))
      , is_rest_failure_(rules.are_of_fields())
      , field_(mesh, constants, rules)
      , arrivals_(mesh)
      , tracker_(mesh, rules.covered_area) {
    start(seeds);
  }

  const Layered_field& field() const { return field_; }
  const Arrivals& arrivals() const { return arrivals_; }
  const Front_tracker& tracker() const { return tracker_; }

  bool is_done() const { return arrivals_.number_of_reached() == mesh_.number_of_vertices(); }

  void step() {
    const Layered_field::Vector_of_values before = field_.covered();
    field_.step();
    const Layered_field::Vector_of_values covered = field_.covered();
    const std::size_t reached_before = arrivals_.number_of_reached();
    arrivals_.advance(before, covered, [&](Index v) { cover(v, covered); });
    resolve_rows();
    if(arrivals_.number_of_reached() != reached_before)
      last_progress_ = arrivals_.number_of_steps();
    else if(arrivals_.number_of_steps() - last_progress_ > patience_)
      push_on(covered);
  }

  void run(Progress& progress) {
    const double n = static_cast<double>(mesh_.number_of_vertices());
    for(std::size_t i = 1; !is_done(); ++i) {
      step();
      if(i % 16 == 0)
        progress.advance(static_cast<double>(arrivals_.number_of_reached()) / n);
    }
  }

  Field_resolution resolution() const {
    Field_resolution resolution;
    resolution.handles_within_steps = Handles_within_steps(tracker_.events()).number();
    resolution.early_vertices = arrivals_.number_of_early_vertices();
    for(const Front_event& event : tracker_.events()) {
      resolution.rests += event.type == Front_event_type::REST;
      resolution.events_in_seed_region += event.step == 0;
    }
    return resolution;
  }

private:
  using Values = Layered_field::Vector_of_values;

  // The region of a seed is the seed and its neighbors.
  void start(const std::vector<Index>& seeds) {
    std::map<Index, Index> layer_of_vertex;
    Values covered = field_.covered();
    for(Index seed : seeds) {
      const Index layer = tracker_.start(seed);
      arrivals_.reach(seed);
      layer_of_vertex[seed] = layer;
      for(Index u : mesh_.ring(seed))
        layer_of_vertex[u] = layer;
    }
    for(const auto& [v, layer] : layer_of_vertex) {
      field_.add_source(v);
      covered[v] = 1.;
    }
    for(Index seed : seeds)
      for(Index u : mesh_.ring(seed)) {
        arrivals_.reach(u);
        cover(u, covered);
      }
    set_to_one(layer_of_vertex);
  }

  void cover(Index v, const Values& covered) {
    tracker_.cover(v, arrivals_.number_of_steps(), covered);
  }

  void set_to_one(const std::map<Index, Index>& layer_of_vertex) {
    field_.move_rows(tracker_.number_of_layers(), [&](Index row, Index v) {
      const auto it = layer_of_vertex.find(v);
      return it == layer_of_vertex.end() ? row : it->second;
    });
    resolve_rows();
  }

  // On a mesh that is coarser than the front is wide, the field can come to rest: at a vertex of
  // high degree with one covered neighbor, say. Then all that it touches is declared covered.
  void push_on(const Values& covered) {
    if(is_rest_failure_)
      fail_at_rest(arrivals_.number_of_reached(), mesh_.number_of_vertices());
    std::map<Index, Index> layer_of_vertex;
    arrivals_.push_on(covered, [&](Index v) {
      if(layer_of_vertex.empty())
        tracker_.log_rest(arrivals_.number_of_steps(), v);
      layer_of_vertex[v] = tracker_.layer_before(v);
      cover(v, covered);
    });
    set_to_one(layer_of_vertex);
    last_progress_ = arrivals_.number_of_steps();
  }

  // The layers at the end of the successions that begin with `layer`.
  std::vector<Index> heirs(Index layer) const {
    std::vector<Index> layers(1, layer), last;
    while(!layers.empty()) {
      const Index l = layers.back();
      layers.pop_back();
      const std::vector<Index>& next = tracker_.successors(l);
      layers.insert(layers.end(), next.rbegin(), next.rend());
      if(next.empty())
        last.push_back(l);
    }
    return last;
  }

  // Rows of layers that are no more go to the layers that took their place; where these are
  // several, each vertex goes to the nearest front.
  void resolve_rows() {
    if(number_of_resolved_layers_ == tracker_.number_of_layers())
      return;
    std::vector<std::vector<Index>> target(tracker_.number_of_layers());
    for(Index row = 1; row < static_cast<Index>(field_.phi().rows()); ++row)
      if(!tracker_.successors(row).empty() && field_.phi().row(row).nonZeros() != 0)
        target[row] = nearest_fronts(heirs(row));
    field_.move_rows(tracker_.number_of_layers(), [&](Index row, Index v) {
      return target[row].empty() ? row : target[row][v];
    });
    number_of_resolved_layers_ = tracker_.number_of_layers();
  }

  // For each vertex the one of the layers whose front is the fewest edges away.
  std::vector<Index> nearest_fronts(const std::vector<Index>& layers) const {
    std::vector<char> is_candidate(tracker_.number_of_layers(), 0);
    for(Index layer : layers)
      is_candidate[layer] = 1;
    std::vector<Index> nearest(mesh_.number_of_vertices(), no_index), queue;
    const auto visit = [&](Index v, Index layer) {
      if(nearest[v] != no_index)
        return;
      nearest[v] = layer;
      queue.push_back(v);
    };
    if(layers.size() > 1)
      tracker_.for_each_front_vertex([&](Index v, Index layer) {
        if(is_candidate[layer])
          visit(v, layer);
      });
    for(std::size_t i = 0; i < queue.size(); ++i)
      for(Index u : mesh_.ring(queue[i]))
        visit(u, nearest[queue[i]]);
    for(Index& layer : nearest)
      if(layer == no_index)
        layer = layers.front(); // the only one, or all are closed
    return nearest;
  }

  const Flat_mesh& mesh_;
  std::size_t patience_;
  bool is_rest_failure_;
  Layered_field field_;
  Arrivals arrivals_;
  Front_tracker tracker_;
  std::size_t number_of_resolved_layers_ = 1;
  std::size_t last_progress_ = 0;
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_INITIAL_PASS_H
