// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_FRONT_HISTORY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_FRONT_HISTORY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Front_event.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A place in the unit of the mesh.
struct Point
{
  double x, y, z;
};

CGAL_HTL_HOST_DEVICE inline Point point_of(const Crossing& c, const Mesh_view& mesh) {
  const double* p = mesh.points.data() + 3 * std::size_t(c.left);
  const double* q = mesh.points.data() + 3 * std::size_t(c.right);
  return {p[0] + rounded_product(c.ratio, q[0] - p[0]),
          p[1] + rounded_product(c.ratio, q[1] - p[1]),
          p[2] + rounded_product(c.ratio, q[2] - p[2])};
}

CGAL_HTL_HOST_DEVICE inline double distance(const Point& p, const Point& q) {
  return rounded_length(q.x - p.x, q.y - p.y, q.z - p.z);
}

/// A curve from the first to the last of its crossings.
struct Measured_curve
{
  Point first = {}, last = {};
  double length = 0.;
  bool is_empty = true;

  CGAL_HTL_HOST_DEVICE void add(const Point& p) {
    if(is_empty)
      first = p;
    else
      length += distance(last, p);
    last = p;
    is_empty = false;
  }

  CGAL_HTL_HOST_DEVICE void add(const Measured_curve& other) {
    add(other.first);
    length += other.length;
    last = other.last;
  }

  CGAL_HTL_HOST_DEVICE double closed_length() const { return length + distance(last, first); }
};

/// Measures the arcs, one thread for each: these are long, and all fronts are made of them.
struct Measure_arcs
{
  Saddle_arrays saddles;
  Span<const Index> saddle_of_lower_component;
  Span<Measured_curve> arcs; ///< by lower component

  CGAL_HTL_HOST_DEVICE void operator()(Index lower_component) const {
    const Index saddle = saddle_of_lower_component[lower_component];
    Measured_curve arc;
    saddles.saddle(saddle).trace_arc(
        lower_component - saddles.begin[saddle],
        [&](const Crossing& c) { arc.add(point_of(c, saddles.mesh)); });
    arcs[lower_component] = arc;
  }
};

/// The fronts that meet or part in one step of the unfolding of a saddle. Two meet and go on as the
/// first one above, or the first one below parts.
struct Linked_fronts
{
  std::uint64_t do_meet;     ///< zero or one; no byte is without a value
  double below[2], above[2]; ///< lengths, in the unit of the mesh
};

/// Measures them, for the step at each lower component but the first ones.
struct Measure_links
{
  Saddle_arrays saddles;
  Span<const Index> saddle_of_lower_component;
  Span<const Measured_curve> arcs;
  Span<Linked_fronts> fronts;

  CGAL_HTL_HOST_DEVICE void operator()(Index lower_component) const {
    const Index saddle = saddle_of_lower_component[lower_component],
                i = lower_component - saddles.begin[saddle];
    if(i == 0)
      return;
    Linked_fronts& f = fronts[lower_component];
    f.do_meet = !saddles.saddle(saddle).cycles().are_joined(i - 1, i, i);
    f.below[0] = length(saddle, i - 1, i);
    f.below[1] = f.do_meet ? length(saddle, i, i) : 0.;
    f.above[0] = length(saddle, i - 1, i + 1);
    f.above[1] = f.do_meet ? 0. : length(saddle, i, i + 1);
  }

private:
  CGAL_HTL_HOST_DEVICE double length(Index saddle, Index start, Index step) const {
    Measured_curve front;
    saddles.saddle(saddle).trace_contour(
        start, step, [&](const Crossing& c) { front.add(point_of(c, saddles.mesh)); },
        [&](Index i) { front.add(arcs[saddles.begin[saddle] + i]); });
    return front.closed_length();
  }
};

/// Measures the fronts that close, just below the maxima.
struct Measure_closings
{
  Mesh_view mesh;
  Span<const Index> maxima;
  Span<double> lengths;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    Measured_curve front;
    for(const Index u : mesh.ring(maxima[i]))
      front.add(point_of({u, maxima[i], largest_ratio}, mesh));
    lengths[i] = front.closed_length();
  }
};

/// What is known of the fronts of a sweep when their contours have been walked. Ends of layers are
/// numbered as in `Layer_links`, but from zero.
struct Walked_fronts
{
  std::vector<std::uint64_t> minima; ///< arrival keys, as those of the others
  std::vector<Index> ends_of_minima; ///< of the layers that begin there

  std::vector<std::uint64_t> saddles;
  std::vector<Index> begins;                         ///< by saddle, its first lower component
  std::vector<Lower_component_arc> lower_components; ///< by lower component, as the next two
  std::vector<Linked_fronts> linked;  ///< in the step of the unfolding at the lower component
  std::vector<Index> ends_above_gaps; ///< of the layers that begin there

  std::vector<std::uint64_t> maxima;
  std::vector<double> closing_lengths; ///< of the fronts that close
};

/// Goes through the saddles from the first one on, numbers the layers and writes down what happens.
class Front_history
{
public:
  Front_history(const Flat_mesh& mesh, const Walked_fronts& fronts)
      : mesh_(mesh)
      , fronts_(fronts)
      , layer_of_end_(fronts.lower_components.size() + fronts.maxima.size(), no_index) {
    for(const Moment& moment : moments())
      (this->*moment.happen)(moment.number);
  }

  std::vector<Front_event> take_events() { return std::move(events_); }

  /// the number of the layer with each end.
  const std::vector<Index>& layer_of_end() const { return layer_of_end_; }

private:
  using Front = Front_event::Front;

  // A critical vertex, and what happens there.
  struct Moment
  {
    std::uint64_t key;
    void (Front_history::*happen)(Index number);
    Index number; // among those of its kind
  };

  std::vector<Moment> moments() const {
    std::vector<Moment> all;
    const auto append = [&](const std::vector<std::uint64_t>& keys, auto happen) {
      for(Index i = 0; i < keys.size(); ++i)
        all.push_back({keys[i], happen, i});
    };
    append(fronts_.minima, &Front_history::begin);
    append(fronts_.saddles, &Front_history::resolve);
    append(fronts_.maxima, &Front_history::close);
    std::sort(all.begin(), all.end(),
              [](const Moment& a, const Moment& b) { return a.key < b.key; });
    return all;
  }

  void begin(Index i) { layer_of_end_[fronts_.ends_of_minima[i]] = new_layer(); }

  void close(Index i) {
    const Index layer = layer_of_end_[fronts_.lower_components.size() + i];
    log(Front_event_type::CLOSING, fronts_.maxima[i], {front(layer, fronts_.closing_lengths[i])},
        {});
  }

  // One event for each step of the unfolding; in between, layers that no vertex lies in may begin
  // and end.
  void resolve(Index saddle) {
    const Index begin = fronts_.begins[saddle];
    const Index k = fronts_.begins[saddle + 1] - begin;
    const Contour_cycles cycles = {{fronts_.lower_components.data() + begin, k}};
    layer_at_.resize(k);
    for(Index at = 0; at < k; ++at)
      layer_at_[at] = layer_of_end_[begin + cycles.first_of_contour(at)];
    for(Index i = 1; i < k; ++i)
      if(fronts_.linked[begin + i].do_meet)
        meet(saddle, cycles, i);
      else
        part(saddle, cycles, i);
    for(Index at = 0; at < k; ++at)
      layer_of_end_[fronts_.ends_above_gaps[begin + at]] = layer_at_[at];
  }

  void meet(Index saddle, const Contour_cycles& cycles, Index i) {
    const Linked_fronts& f = fronts_.linked[fronts_.begins[saddle] + i];
    const std::vector<Front> before = {front(layer_at_[i - 1], f.below[0]),
                                       front(layer_at_[i], f.below[1])};
    const Index met = enter_new_layer(cycles, i, i + 1);
    log(Front_event_type::MERGE, fronts_.saddles[saddle], before, {front(met, f.above[0])});
  }

  void part(Index saddle, const Contour_cycles& cycles, Index i) {
    const Linked_fronts& f = fronts_.linked[fronts_.begins[saddle] + i];
    const std::vector<Front> before = {front(layer_at_[i], f.below[0])};
    const Index a = enter_new_layer(cycles, i - 1, i + 1);
    const Index b = enter_new_layer(cycles, i, i + 1);
    log(Front_event_type::SPLIT, fronts_.saddles[saddle], before,
        {front(a, f.above[0]), front(b, f.above[1])});
  }

  Index new_layer() { return ++number_of_layers_; }

  Index enter_new_layer(const Contour_cycles& cycles, Index start, Index step) {
    const Index layer = new_layer();
    cycles.for_each(start, step, [&](Index at, Index) { layer_at_[at] = layer; });
    return layer;
  }

  Front front(Index layer, double length) const {
    return {layer, mesh_.in_units_of_caller(length)};
  }

  void log(Front_event_type type,
           std::uint64_t key,
           const std::vector<Front>& before,
           const std::vector<Front>& after) {
    events_.push_back({type, step_of(static_cast<Time>(key >> 32)),
                       mesh_.index_of_caller(static_cast<Index>(key)), before, after});
  }

  const Flat_mesh& mesh_;
  const Walked_fronts& fronts_;
  std::vector<Index> layer_of_end_;
  std::vector<Index>
      layer_at_; // of the front that arrives at a lower component of the present saddle
  std::vector<Front_event> events_;
  Index number_of_layers_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_FRONT_HISTORY_H
