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
#include <CGAL/Handle_tunnel_loops/internal/reference/Fronts.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/fields.h>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::reference {

/// The number of handles that cannot be seen by looking at the fronts after each time step. Fronts
/// are related by the events of a step; where two that are related already merge, a front has split
/// and its parts have met again in one step.
inline std::size_t handles_within_steps(const std::vector<Front_event>& events) {
  std::size_t number = 0, step = 0;
  std::map<std::size_t, std::size_t> group_of_layer; // in the present step
  for(const Front_event& event : events) {
    if(event.step != step)
      group_of_layer.clear();
    step = event.step;
    if(event.before.empty())
      continue;
    for(const Front_event::Front& front : event.before)
      group_of_layer.emplace(front.layer, front.layer);
    const std::size_t group = group_of_layer.at(event.before.front().layer),
                      other = group_of_layer.at(event.before.back().layer);
    number += event.type == Front_event_type::MERGE && group == other;
    for(auto& [layer, its_group] : group_of_layer)
      if(its_group == other)
        its_group = group;
    for(const Front_event::Front& front : event.after)
      group_of_layer[front.layer] = group;
  }
  return number;
}

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
  const std::vector<Front_meeting>& meetings() const { return tracker_.meetings(); }

  std::size_t number_of_covered() const { return arrivals_.number_of_reached(); }
  bool is_done() const { return number_of_covered() == mesh_.number_of_vertices(); }

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

  Field_resolution resolution() const {
    Field_resolution resolution;
    resolution.handles_within_steps = handles_within_steps(tracker_.events());
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
    field_.start(mesh_, seeds);
    const Values covered = field_.covered();
    for(Index seed : seeds) {
      tracker_.start(seed);
      arrivals_.reach(seed);
    }
    for(Index seed : seeds)
      for(Index u : mesh_.ring(seed)) {
        arrivals_.reach(u);
        cover(u, covered);
      }
    resolve_rows();
  }

  void cover(Index v, const Values& covered) {
    tracker_.cover(v, arrivals_.number_of_steps(), covered);
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
    field_.move_vertices(tracker_.number_of_layers(), layer_of_vertex);
    resolve_rows();
    last_progress_ = arrivals_.number_of_steps();
  }

  // Adds the layers at the end of the successions that begin with `layer`.
  void add_heirs(Index layer, std::vector<Index>& heirs) const {
    for(const Index next : tracker_.successors(layer))
      add_heirs(next, heirs);
    if(tracker_.successors(layer).empty())
      heirs.push_back(layer);
  }

  // Rows of layers that are no more go to the layers that took their place; where these are
  // several, each vertex goes to the nearest front.
  void resolve_rows() {
    if(number_of_resolved_layers_ == tracker_.number_of_layers())
      return;
    std::vector<std::vector<Index>> target(tracker_.number_of_layers());
    for(Index row = 1; row < static_cast<Index>(field_.phi().rows()); ++row)
      if(!tracker_.successors(row).empty() && field_.phi().row(row).nonZeros() != 0)
        target[row] = nearest_fronts(row);
    field_.move_rows(tracker_.number_of_layers(), [&](Index row, Index v) {
      return target[row].empty() ? row : target[row][v];
    });
    number_of_resolved_layers_ = tracker_.number_of_layers();
  }

  // For each vertex the one of the heirs of a layer whose front is the fewest edges away.
  std::vector<Index> nearest_fronts(Index layer_before) const {
    std::vector<Index> layers;
    add_heirs(layer_before, layers);
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

} // namespace CGAL::Handle_tunnel_loops::internal::reference

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_INITIAL_PASS_H
