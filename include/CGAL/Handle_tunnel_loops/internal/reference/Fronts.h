// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Front_event.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_flat_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::reference {

/*!
What a field has covered: vertices, and links between neighbors.

Neighbors that are both covered are linked, but for those of one vertex, the center. The covered
neighbors of a vertex form runs along its ring. When the vertex is covered, its runs are linked to
it one after the other, so that the boundary of the region changes in one place at a time: a vertex
with many runs is as good as that many vertices with two.
*/
class Covered_region
{
public:
  explicit Covered_region(const Flat_mesh& mesh)
      : mesh_(mesh)
      , is_covered_(mesh.number_of_vertices(), 0) {}

  const Flat_mesh& mesh() const { return mesh_; }
  bool contains(Index v) const { return is_covered_[v] != 0; }

  /// adds a vertex and links it to the first of its runs, if it has any.
  void add(Index v) {
    find_runs(v);
    is_covered_[v] = 1;
    center_ = v;
    number_of_linked_runs_ = 1;
  }

  /// the number of runs of the vertex that was added last.
  Index number_of_runs() const { return static_cast<Index>(last_of_run_.size()); }

  /// the last vertex of a run, counterclockwise.
  Index last_of_run(Index run) const { return last_of_run_[run]; }

  void link_next_run() { ++number_of_linked_runs_; }

  /// whether neighbors are both covered, and linked.
  bool are_linked(Index u, Index v) const {
    if(!contains(u) || !contains(v))
      return false;
    if(u == center_ || v == center_)
      return run_[mesh_.ring(center_).position(u == center_ ? v : u)] < number_of_linked_runs_;
    return true;
  }

  /// The boundary crosses an edge wherever a covered vertex is not linked to its neighbor, close to
  /// the covered vertex if both are. It keeps the covered vertex on its left. This is the next edge
  /// that it crosses.
  Crossing next(const Crossing& c) const {
    const Index apex = apex_ahead(mesh_, c);
    return are_linked(c.left, apex) ? Crossing{apex, c.right, 0.5} : Crossing{c.left, apex, 0.5};
  }

private:
  void find_runs(Index v) {
    const Ring ring = mesh_.ring(v);
    run_.assign(ring.size(), 0);
    last_of_run_.clear();
    Index start = 0;
    while(start < ring.size() && contains(ring[start]))
      ++start;
    if(start == ring.size())
      return; // the whole ring
    for(Index i = ring.next(start); i != start; i = ring.next(i)) {
      if(!contains(ring[i]))
        continue;
      if(!contains(ring[ring.previous(i)]))
        last_of_run_.push_back(no_index);
      run_[i] = static_cast<Index>(last_of_run_.size()) - 1;
      last_of_run_.back() = ring[i];
    }
  }

  const Flat_mesh& mesh_;
  std::vector<char> is_covered_;
  Index center_ = no_index;
  std::vector<Index> run_; // by position in the ring of the center
  std::vector<Index> last_of_run_;
  Index number_of_linked_runs_ = 0;
};

/*!
The fronts: the components of the boundary of a region (paper, section 5).

The boundary has a piece in each triangle with one or two covered vertices. These are the nodes of a
graph; they are adjacent where they share a crossed edge, and its connected components are the
fronts. Each is a simple closed curve, however coarse the mesh, so that it is found by following it.
(A triangle with vertices that are covered but not linked may have more than one piece. So the nodes
are the places at which the boundary comes into a triangle.)
*/
class Fronts
{
public:
  explicit Fronts(const Covered_region& region)
      : region_(region)
      , node_(region.mesh().neighbor.size(), no_index) {
    find_nodes();
    front_.resize(crossings_.size(), no_index);
    for(const Crossing& start : crossings_)
      if(front(start) == no_index) {
        for(const Crossing& c : loop(start))
          front_[node(c)] = number_;
        ++number_;
      }
  }

  Index number_of_fronts() const { return number_; }

  /// all edges that are crossed.
  const std::vector<Crossing>& crossings() const { return crossings_; }

  /// the number of the front that crosses an edge.
  Index front(const Crossing& c) const { return front_[node(c)]; }

  /// the front from one of its crossings on, with the covered vertices on its left.
  Crossing_loop loop(const Crossing& start) const {
    Crossing_loop loop;
    Crossing c = start;
    do {
      loop.push_back(c);
      c = region_.next(c);
    } while(c.left != start.left || c.right != start.right);
    return loop;
  }

private:
  void find_nodes() {
    const Flat_mesh& mesh = region_.mesh();
    for(Index u = 0; u < mesh.number_of_vertices(); ++u)
      if(region_.contains(u))
        for(Index i = mesh.row_begin[u]; i < mesh.row_begin[u + 1]; ++i)
          if(!region_.are_linked(u, mesh.neighbor[i])) {
            node_[i] = static_cast<Index>(crossings_.size());
            crossings_.push_back({u, mesh.neighbor[i], 0.5});
          }
  }

  Index node(const Crossing& c) const { return node_[slot(region_.mesh(), c.left, c.right)]; }

  const Covered_region& region_;
  std::vector<Index> node_; // by slot
  std::vector<Crossing> crossings_;
  std::vector<Index> front_; // by node
  Index number_ = 0;
};

/// Two fronts have met: a handle. `loop` is the shorter of the two, with what was covered on the
/// left.
struct Front_meeting
{
  Crossing_loop loop;
  Index saddle;           ///< the vertex at which they met
  Index foot_a, foot_b;   ///< covered neighbors of the saddle, behind either front
  std::vector<char> area; ///< the vertices that any layer but the base had come to
};

/// where the base layer has eroded.
template <typename Values> std::vector<char> area_of(const Values& covered) {
  std::vector<char> area(static_cast<std::size_t>(covered.size()));
  for(std::size_t v = 0; v < area.size(); ++v)
    area[v] = covered[v] > 0.;
  return area;
}

/// a front on the line on which the field has the value of the threshold.
template <typename Values> Crossing_loop placed(Crossing_loop loop, const Values& covered) {
  for(Crossing& c : loop) {
    const double drop = covered[c.left] - covered[c.right];
    const double ratio = drop > 0. ? (covered[c.left] - threshold) / drop : 0.5;
    c.ratio = (std::min)(0.99, (std::max)(0.01, ratio));
  }
  return loop;
}

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

  Index new_layer() {
    successors_.emplace_back();
    return static_cast<Index>(successors_.size()) - 1;
  }

  // What `region_.add()` links `v` to first: the first run after an uncovered neighbor.
  Crossing front_before(Index v) const {
    const Ring ring = mesh_.ring(v);
    const auto is_covered = [this](Index u) { return region_.contains(u); };
    const Index* const uncovered = std::find_if_not(ring.begin(), ring.end(), is_covered);
    const Index* u = std::find_if(uncovered, ring.end(), is_covered);
    if(u == ring.end())
      u = std::find_if(ring.begin(), uncovered, is_covered);
    return {*u, v, 0.5};
  }

  bool closes(Index v) const {
    const Ring ring = mesh_.ring(v);
    return std::all_of(ring.begin(), ring.end(), [this](Index u) { return region_.contains(u); });
  }

  void set_layer_around(Index v, Index layer) {
    for(Index u : mesh_.ring(v))
      if(!region_.are_linked(v, u))
        layer_[slot(mesh_, v, u)] = layer;
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
      successors_[layer_a].push_back(merged);
      if(layer_b != layer_a)
        successors_[layer_b].push_back(merged);
      take_over(after, a, merged);
      log(Front_event_type::MERGE, step, v, {record(layer_a, loop_a), record(layer_b, loop_b)},
          {record(merged, placed(after.loop(a), covered))});
      Crossing_loop& shorter = is_shorter(mesh_, loop_b, loop_a) ? loop_b : loop_a;
      meetings_.push_back({std::move(shorter), v, a.left, b.left,
                           keeps_areas_ ? area_of(covered) : std::vector<char>()});
    } else {
      const Index part_a = new_layer(), part_b = new_layer();
      for(const Index part : {part_a, part_b})
        successors_[layer_a].push_back(part);
      take_over(after, a, part_a);
      take_over(after, b, part_b);
      log(Front_event_type::SPLIT, step, v, {record(layer_a, loop_a)},
          {record(part_a, placed(after.loop(a), covered)),
           record(part_b, placed(after.loop(b), covered))});
    }
  }

  void take_over(const Fronts& fronts, const Crossing& at, Index layer) {
    for(const Crossing& c : fronts.crossings())
      if(fronts.front(c) == fronts.front(at))
        layer_[slot(mesh_, c.left, c.right)] = layer;
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

} // namespace CGAL::Handle_tunnel_loops::internal::reference

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONTS_H
