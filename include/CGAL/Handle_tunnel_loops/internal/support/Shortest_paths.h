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
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The queue of Dijkstra's algorithm: numbered places, the nearest first, and of those that are
/// equally near the first. It keeps its memory. A heap of which each place has four below it, with
/// keys that are compared in one step, takes two thirds of the time of a binary one of pairs.
template <typename Distance> class Distance_queue
{
public:
  void push(Distance distance, Index i) {
    const Key key(distance, i);
    std::size_t place = keys_.size();
    keys_.push_back(key);
    while(place > 0 && key < keys_[(place - 1) / 4]) {
      keys_[place] = keys_[(place - 1) / 4];
      place = (place - 1) / 4;
    }
    keys_[place] = key;
  }

  void clear() { keys_.clear(); }

  /// calls `visit(i)` for what has been put in, and what is put in meanwhile, as long as
  /// `goes_on(distance)`. What has become nearer since, by `labels[i].distance`, is passed over.
  template <typename Labels, typename GoesOn, typename Visit>
  void run(const Labels& labels, const GoesOn& goes_on, const Visit& visit) {
    while(!keys_.empty() && goes_on(keys_.front().distance())) {
      const Key key = keys_.front();
      pop();
      if(!(key.distance() > labels[key.index()].distance))
        visit(key.index());
    }
  }

private:
  // In the order of distances, then of indices.
  class Pair_key
  {
  public:
    Pair_key(Distance distance, Index i)
        : pair_(distance, i) {}
    Distance distance() const { return pair_.first; }
    Index index() const { return pair_.second; }
    bool operator<(const Pair_key& other) const { return pair_ < other.pair_; }

  private:
    std::pair<Distance, Index> pair_;
  };

  // Floating-point numbers that are not negative are in the order of their bits.
  class Float_key
  {
  public:
    Float_key(float distance, Index i) {
      std::uint32_t bits;
      distance += 0.f; // there is one zero
      std::memcpy(&bits, &distance, sizeof(bits));
      bits_ = std::uint64_t(bits) << 32 | i;
    }
    float distance() const {
      const std::uint32_t bits = static_cast<std::uint32_t>(bits_ >> 32);
      float distance;
      std::memcpy(&distance, &bits, sizeof(bits));
      return distance;
    }
    Index index() const { return static_cast<Index>(bits_); }
    bool operator<(const Float_key& other) const { return bits_ < other.bits_; }

  private:
    std::uint64_t bits_;
  };

  using Key = std::conditional_t<std::is_same_v<Distance, float>, Float_key, Pair_key>;

  void pop() {
    const Key key = keys_.back();
    keys_.pop_back();
    const std::size_t n = keys_.size();
    if(n == 0)
      return;
    std::size_t place = 0;
    for(std::size_t first = 1; first < n; first = 4 * place + 1) {
      std::size_t least = first;
      for(std::size_t i = first + 1; i < (std::min)(first + 4, n); ++i)
        if(keys_[i] < keys_[least])
          least = i;
      if(!(keys_[least] < key))
        break;
      keys_[place] = keys_[least];
      place = least;
    }
    keys_[place] = key;
  }

  std::vector<Key> keys_;
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
