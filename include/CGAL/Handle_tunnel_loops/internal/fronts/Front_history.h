// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_HISTORY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_HISTORY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Front_event.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/fronts/Front_lengths.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/Contour_cycles.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// What is known of the fronts of a sweep when their contours have been walked. Ends of layers are
/// numbered as in `Layer_links`, but from zero.
struct Walked_fronts
{
  struct Minima
  {
    std::vector<std::uint64_t> keys;
    std::vector<Index> ends; ///< of the layers that begin there
  };
  struct Saddles
  {
    std::vector<std::uint64_t> keys;
    std::vector<Index> begins;                         ///< by saddle, its first lower component
    std::vector<Lower_component_arc> lower_components; ///< by lower component, as all that follow
    std::vector<Linked_fronts> linked; ///< in the step of the unfolding at the lower component
    std::vector<Index> ends;           ///< of the layers just above the gaps
  };
  struct Maxima
  {
    std::vector<std::uint64_t> keys;
    std::vector<double> lengths; ///< of the fronts that close
  };

  Minima minima;
  Saddles saddles;
  Maxima maxima;
};

/// Goes through the saddles from the first one on, numbers the layers and writes down what happens.
class Front_history
{
public:
  Front_history(const Flat_mesh& mesh, const Walked_fronts& fronts)
      : mesh_(mesh)
      , minima_(fronts.minima)
      , saddles_(fronts.saddles)
      , maxima_(fronts.maxima)
      , layer_of_end_(saddles_.lower_components.size() + maxima_.keys.size(), no_index) {
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
    append(minima_.keys, &Front_history::begin);
    append(saddles_.keys, &Front_history::resolve);
    append(maxima_.keys, &Front_history::close);
    std::sort(all.begin(), all.end(),
              [](const Moment& a, const Moment& b) { return a.key < b.key; });
    return all;
  }

  void begin(Index i) { layer_of_end_[minima_.ends[i]] = new_layer(); }

  void close(Index i) {
    const Index layer = layer_of_end_[saddles_.lower_components.size() + i];
    log(Front_event_type::CLOSING, maxima_.keys[i], {front(layer, maxima_.lengths[i])}, {});
  }

  // One event for each step of the unfolding; in between, layers that no vertex lies in may begin
  // and end.
  void resolve(Index saddle) {
    const Index begin = saddles_.begins[saddle];
    const Index k = saddles_.begins[saddle + 1] - begin;
    const Contour_cycles cycles({saddles_.lower_components.data() + begin, k});
    layer_at_.resize(k);
    for(Index at = 0; at < k; ++at)
      layer_at_[at] = layer_of_end_[begin + cycles.first_of_contour(at)];
    for(Index i = 1; i < k; ++i)
      if(saddles_.linked[begin + i].do_meet)
        meet(saddle, cycles, i);
      else
        part(saddle, cycles, i);
    for(Index at = 0; at < k; ++at)
      layer_of_end_[saddles_.ends[begin + at]] = layer_at_[at];
  }

  void meet(Index saddle, const Contour_cycles& cycles, Index i) {
    const Linked_fronts& f = saddles_.linked[saddles_.begins[saddle] + i];
    const std::vector<Front> before = {front(layer_at_[i - 1], f.below[0]),
                                       front(layer_at_[i], f.below[1])};
    const Index met = enter_new_layer(cycles, i, i + 1);
    log(Front_event_type::MERGE, saddles_.keys[saddle], before, {front(met, f.above[0])});
  }

  void part(Index saddle, const Contour_cycles& cycles, Index i) {
    const Linked_fronts& f = saddles_.linked[saddles_.begins[saddle] + i];
    const std::vector<Front> before = {front(layer_at_[i], f.below[0])};
    const Index a = enter_new_layer(cycles, i - 1, i + 1);
    const Index b = enter_new_layer(cycles, i, i + 1);
    log(Front_event_type::SPLIT, saddles_.keys[saddle], before,
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
  const Walked_fronts::Minima& minima_;
  const Walked_fronts::Saddles& saddles_;
  const Walked_fronts::Maxima& maxima_;
  std::vector<Index> layer_of_end_;
  std::vector<Index>
      layer_at_; // of the front that arrives at a lower component of the present saddle
  std::vector<Front_event> events_;
  Index number_of_layers_ = 0;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_HISTORY_H
