// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SETS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SETS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// sorts the elements of a vector and leaves one of each, so that `is_in()` finds them.
template <typename T> void make_set(std::vector<T>& all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

template <typename T> bool is_in(const T& t, const std::vector<T>& set) {
  return std::binary_search(set.begin(), set.end(), t);
}

/// the union of two vectors of which each is in ascending order.
template <typename T> std::vector<T> united(const std::vector<T>& a, const std::vector<T>& b) {
  std::vector<T> all;
  all.reserve(a.size() + b.size());
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

/// how many different indices there are: counted by bits where they are near each other, as this is
/// faster than to sort them.
inline std::size_t number_of_different(std::vector<Index> indices) {
  constexpr std::size_t most_bits = 64; // for each
  if(indices.empty())
    return 0;
  const auto [least, greatest] = std::minmax_element(indices.begin(), indices.end());
  const Index first = *least;
  const std::size_t range = std::size_t(*greatest - first) + 1;
  if(range > most_bits * indices.size()) {
    make_set(indices);
    return indices.size();
  }
  std::vector<bool> is_there(range);
  std::size_t number = 0;
  for(Index i : indices)
    if(!is_there[i - first]) {
      is_there[i - first] = true;
      ++number;
    }
  return number;
}

/// A set that is asked far more often than it has elements: a bit for each index from the least to
/// the greatest one.
class Index_range_set
{
public:
  /// of indices in ascending order.
  explicit Index_range_set(const std::vector<Index>& indices)
      : first_(indices.empty() ? 0 : indices.front())
      , bits_(indices.empty() ? 0 : indices.back() - first_ + 1) {
    for(Index i : indices)
      bits_[i - first_] = true;
  }

  bool contains(Index i) const { return i - first_ < bits_.size() && bits_[i - first_]; }

private:
  Index first_;
  std::vector<bool> bits_;
};

/// Disjoint sets of numbers that many threads may unite at the same time. Parents are smaller than
/// their children, so that the root of a set is its least number, whatever the threads do.
class Concurrent_disjoint_sets
{
public:
  Concurrent_disjoint_sets() = default;

  /// no number below \p n is in a set yet.
  Concurrent_disjoint_sets(Execution execution, std::size_t n)
      : is_shared_(execution.is_parallel())
      , size_(n)
      , parent_(new std::atomic<Index>[n]) {
    for_each_index(execution, n,
                   [this](std::size_t i) { set_parent(static_cast<Index>(i), none); });
  }

  std::size_t size() const { return size_; }

  /// makes a set of one number. While this goes on, nothing is united.
  void insert(Index i) { set_parent(i, i); }

  bool contains(Index i) const { return parent(i) != none; }

  void unite(Index i, Index j) {
    for(;;) {
      i = root(i);
      j = root(j);
      if(i == j)
        return;
      if(i < j)
        std::swap(i, j);
      if(put_below(i, j))
        return;
    }
  }

  /// the least number that is known to be in the same set: that of the set, once nothing is united
  /// any more.
  Index root(Index i) {
    for(;;) {
      const Index up = parent(i);
      CGAL_assertion_msg(up <= i, "parents are smaller than their children, and in a set");
      if(up == i)
        return i;
      const Index above = parent(up);
      if(above == up)
        return up;
      set_parent(i, above);
      i = above;
    }
  }

  /// lets all numbers point to their roots, and returns these in ascending order.
  std::vector<Index> flatten(Execution execution) {
    return collect<Index>(execution, size_, [this](std::size_t begin, std::size_t end) {
      std::vector<Index> roots;
      for(Index i = static_cast<Index>(begin); i < end; ++i) {
        if(!contains(i))
          continue;
        const Index r = root(i);
        CGAL_assertion(r <= i);
        if(r == i)
          roots.push_back(i);
        set_parent(i, r);
      }
      return roots;
    });
  }

  /// what a number points to: its root, after `flatten()`, or what `relabel()` has put there.
  Index label(Index i) const { return parent(i); }

  /// replaces each root, after `flatten()`, by `f(root)`. Nothing can be united any more.
  template <typename Function> void relabel(Execution execution, const Function& f) {
    for_each_index(execution, size_, [&](std::size_t i) {
      if(contains(static_cast<Index>(i)))
        set_parent(static_cast<Index>(i), f(label(static_cast<Index>(i))));
    });
  }

private:
  static constexpr Index none = no_index;

  // Puts a root below another. Fails if another thread has put it elsewhere.
  bool put_below(Index root, Index other) {
    if(is_shared_)
      return parent_[root].compare_exchange_strong(root, other, std::memory_order_relaxed);
    set_parent(root, other);
    return true;
  }

  // What threads tell each other are the parents alone; nothing else is published with them.
  Index parent(Index i) const { return parent_[i].load(std::memory_order_relaxed); }
  void set_parent(Index i, Index parent) { parent_[i].store(parent, std::memory_order_relaxed); }

  bool is_shared_ = false; // by several threads
  std::size_t size_ = 0;
  std::unique_ptr<std::atomic<Index>[]> parent_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SETS_H
