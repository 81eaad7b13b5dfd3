// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONT_TRACKER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONT_TRACKER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Front_event.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_lengths.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Fronts.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/*!
Follows the fronts and the layers that they lie in while vertices are covered one after the other.

A vertex whose covered neighbors form one run moves a front on; where they are its whole ring, a
front closes. With more runs, one is linked after the other, and each link either splits a front or
merges two. A surface that is covered from one vertex begins and ends without a front. So, with
s splits, m merges and c closings of one front each, 1 + s - m - c = 0, and Euler's formula for the
disc, s + m links and c caps says 1 - (s + m) + c = 2 - 2g. Hence m = g: each merge is a handle, and
there are no others.
*/
class Front_tracker
{
public:
  /// \p keeps_areas says whether meetings are to know what was covered when they happened, which
  /// takes a byte per vertex for each.
  explicit Front_tracker(const Flat_mesh& mesh, bool keeps_areas = false)
      : mesh_(mesh)
      , keeps_areas_(keeps_areas)
      , region_(mesh)
      , layer_(mesh.neighbor.size(), no_index)
      , layer_of_vertex_(mesh.number_of_vertices(), no_index)
      , successors_(1) {}

  const std::vector<Front_event>& events() const { return events_; }
  const std::vector<Front_meeting>& meetings() const { return meetings_; }

  /// one more than the largest layer; 0 is the base layer.
  std::size_t number_of_layers() const { return successors_.size(); }

  /// the layers that took the place of a layer.
  const std::vector<Index>& successors(Index layer) const { return successors_[layer]; }

  /// by vertex, the layer of the front that covered it.
  const std::vector<Index>& layers_of_vertices() const { return layer_of_vertex_; }

  /// covers the first vertex of a component, with a front in a new layer.
  Index start(Index v) {
    region_.add(v);
    const Index layer = new_layer();
    layer_of_vertex_[v] = layer;
    set_layer_around(v, layer);
    return layer;
  }

  /// covers a vertex next to a covered one, in the given time step; `covered` are the values from
  /// which the fronts are interpolated.
  template <typename Values> void cover(Index v, std::size_t step, const Values& covered) {
    const Crossing behind = front_before(v);
    const Index layer = layer_of(behind);
    if(closes(v))
      log(Front_event_type::CLOSING, step, v,
          {record(layer, placed(Fronts(region_).loop(behind), covered))}, {});
    region_.add(v);
    layer_of_vertex_[v] = layer;
    set_layer_around(v, layer);
    for(Index run = 1; run < region_.number_of_runs(); ++run)
      link(v, run, step, covered);
  }

  /// the layer of the front that `v`, which is not covered, lies before.
  Index layer_before(Index v) const { return layer_of(front_before(v)); }

  /// calls `f(v, layer)` for each place at which a front in a layer runs around a covered vertex.
  template <typename Function> void for_each_front_vertex(const Function& f) const {
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v)
      if(region_.contains(v))
        for(Index u : mesh_.ring(v))
          if(!region_.are_linked(v, u))
            f(v, layer_of({v, u, 0.5}));
  }

  /// logs that the field was at rest, with `v` next to be covered.
  void log_rest(std::size_t step, Index v) { log(Front_event_type::REST, step, v, {}, {}); }

private:
  Index layer_of(const Crossing& c) const { return layer_[slot(mesh_, c.left, c.right)]; }

  void set_layer_of(const Crossing& c, Index layer) {
    layer_[slot(mesh_, c.left, c.right)] = layer;
  }

  Index new_layer() {
    successors_.emplace_back();
    return static_cast<Index>(successors_.size()) - 1;
  }

  // What `region_.add()` links `v` to first: the first run after an uncovered neighbor.
  Crossing front_before(Index v) const {
    const Ring ring = mesh_.ring(v);
    Index i = 0;
    while(i < ring.size() && region_.contains(ring[i]))
      ++i;
    for(Index count = 0; count < ring.size(); ++count) {
      i = i >= ring.size() ? 0 : ring.next(i);
      if(region_.contains(ring[i]))
        break;
    }
    return {ring[i], v, 0.5};
  }

  bool closes(Index v) const {
    const Ring ring = mesh_.ring(v);
    return std::all_of(ring.begin(), ring.end(), [this](Index u) { return region_.contains(u); });
  }

  void set_layer_around(Index v, Index layer) {
    for(Index u : mesh_.ring(v))
      if(!region_.are_linked(v, u))
        set_layer_of({v, u, 0.5}, layer);
  }

  // The crossing after the last vertex of a run belongs to the front around the run, and is there
  // before and after the run is linked.
  Crossing crossing_after(Index v, Index run) const {
    const Index last = region_.last_of_run(run);
    return {last, mesh_.ring(v).after(last), 0.5};
  }

  template <typename Values>
  void link(Index v, Index run, std::size_t step, const Values& covered) {
    const Crossing a = crossing_after(v, run - 1), b = crossing_after(v, run);
    const Fronts before(region_);
    const bool is_merge = before.front(a) != before.front(b);
    const Index layer_a = layer_of(a), layer_b = layer_of(b);
    Crossing_loop loop_a = placed(before.loop(a), covered);
    Crossing_loop loop_b = placed(before.loop(b), covered);

    region_.link_next_run();
    const Fronts after(region_);
    CGAL_assertion(is_merge == (after.front(a) == after.front(b)));
    if(is_merge) {
      const Index merged = new_layer();
      succeed(layer_a, merged);
      if(layer_b != layer_a)
        succeed(layer_b, merged);
      take_over(after, a, merged);
      log(Front_event_type::MERGE, step, v, {record(layer_a, loop_a), record(layer_b, loop_b)},
          {record(merged, placed(after.loop(a), covered))});
      Crossing_loop& shorter = is_shorter(mesh_, loop_b, loop_a) ? loop_b : loop_a;
      meetings_.push_back({std::move(shorter), v, a.left, b.left,
                           keeps_areas_ ? area_of(covered) : std::vector<char>()});
    } else {
      const Index part_a = new_layer(), part_b = new_layer();
      for(const Index part : {part_a, part_b})
        succeed(layer_a, part);
      take_over(after, a, part_a);
      take_over(after, b, part_b);
      log(Front_event_type::SPLIT, step, v, {record(layer_a, loop_a)},
          {record(part_a, placed(after.loop(a), covered)),
           record(part_b, placed(after.loop(b), covered))});
    }
  }

  void succeed(Index layer, Index by) { successors_[layer].push_back(by); }

  void take_over(const Fronts& fronts, const Crossing& at, Index layer) {
    for(const Crossing& c : fronts.crossings())
      if(fronts.front(c) == fronts.front(at))
        set_layer_of(c, layer);
  }

  Front_event::Front record(Index layer, const Crossing_loop& loop) const {
    return {layer, mesh_.in_units_of_caller(length(mesh_, loop))};
  }

  void log(Front_event_type type,
           std::size_t step,
           Index v,
           std::vector<Front_event::Front> before,
           std::vector<Front_event::Front> after) {
    events_.push_back({type, step, mesh_.index_of_caller(v), std::move(before), std::move(after)});
  }

  const Flat_mesh& mesh_;
  bool keeps_areas_;
  Covered_region region_;
  std::vector<Index> layer_;                   // of the front that crosses an edge, by slot
  std::vector<Index> layer_of_vertex_;         // of the front that covered it
  std::vector<std::vector<Index>> successors_; // by layer
  std::vector<Front_event> events_;
  std::vector<Front_meeting> meetings_;
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONT_TRACKER_H
