// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SHORTEST_PATHS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SHORTEST_PATHS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The queue of Dijkstra's algorithm: numbered places, the nearest first, and of those that are
/// equally near the first. It keeps its memory.
template <typename Distance>
class Distance_queue : std::priority_queue<std::pair<Distance, Index>,
                                           std::vector<std::pair<Distance, Index>>,
                                           std::greater<>>
{
public:
  void push(Distance distance, Index i) { this->emplace(distance, i); }
  void clear() { this->c.clear(); }

  /// calls `visit(i)` for what has been put in, and what is put in meanwhile, as long as
  /// `goes_on(distance)`. What has become nearer since, by `labels[i].distance`, is passed over.
  template <typename Labels, typename GoesOn, typename Visit>
  void run(const Labels& labels, const GoesOn& goes_on, const Visit& visit) {
    while(!this->empty() && goes_on(this->top().first)) {
      const auto [distance, i] = this->top();
      this->pop();
      if(!(distance > labels[i].distance))
        visit(i);
    }
  }
};

/*!
Dijkstra's algorithm on numbered places. Each has a label: its `distance`, and what else is to be
known of the way there. A new label is that of a place that has not been reached.

A workspace that can be used again and again; clearing it costs as much as what has been reached.
*/
template <typename Label> class Shortest_paths
{
public:
  explicit Shortest_paths(std::size_t number_of_places)
      : labels_(number_of_places) {}

  const Label& operator[](Index i) const { return labels_[i]; }
  Label& operator[](Index i) { return labels_[i]; }
  std::size_t size() const { return labels_.size(); }
  void resize(std::size_t number_of_places) { labels_.resize(number_of_places); }

  bool is_reached(Index i) const { return labels_[i].distance != Label().distance; }
  const std::vector<Index>& reached() const { return reached_; }

  /// gives a place a label, from which it is to be visited.
  void reach(Index i, const Label& label) {
    if(!is_reached(i))
      reached_.push_back(i);
    labels_[i] = label;
    queue_.push(label.distance, i);
  }

  /// calls `visit(i)` for what is reached, the nearest first, as long as `goes_on(distance)`. It
  /// can be called again to go on from there.
  template <typename GoesOn, typename Visit> void grow(const GoesOn& goes_on, const Visit& visit) {
    queue_.run(labels_, goes_on, visit);
  }
  template <typename Visit> void grow(const Visit& visit) {
    grow([](auto) { return true; }, visit);
  }

  /// takes the labels of places back, from which nothing is to be visited any more.
  void forget(const std::vector<Index>& places) {
    for(const Index i : places)
      labels_[i] = Label();
    reached_.erase(
        std::remove_if(reached_.begin(), reached_.end(), [&](Index i) { return !is_reached(i); }),
        reached_.end());
  }

  void clear() {
    for(const Index i : reached_)
      labels_[i] = Label();
    reached_.clear();
    queue_.clear();
  }

private:
  std::vector<Label> labels_;
  std::vector<Index> reached_;
  Distance_queue<decltype(Label::distance)> queue_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SHORTEST_PATHS_H
