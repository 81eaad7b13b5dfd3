// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_PARALLEL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_PARALLEL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Knows whether there is use in going on.
class Watch
{
public:
  /// throws if there is none; for many threads, and so cheap that it can be called very often.
  virtual void look() = 0;

protected:
  ~Watch() = default;
};

/// Whether there can be more threads than one, and the tag that asks for all of them: not CGAL's
/// own, which knows of TBB alone.
#if defined(CGAL_LINKED_WITH_TBB) || defined(CGAL_HTL_STD_THREADS)
constexpr bool has_threads = true;
using Threads_if_available_tag = Parallel_tag;
#else
constexpr bool has_threads = false;
using Threads_if_available_tag = Sequential_tag;
#endif

/// How to do what can be done in any order: in the calling thread, or in all threads that there
/// are. It is the first argument of whatever makes use of it, and no answer depends on it. All that
/// is done with one that is watched ends soon when the watch says so, by an exception.
class Execution
{
public:
  /// in the calling thread.
  constexpr Execution() = default;

  /// in all threads, if there can be several.
  static constexpr Execution parallel() {
    Execution execution;
    execution.is_parallel_ = has_threads;
    return execution;
  }

  constexpr bool is_parallel() const { return is_parallel_; }

  /// the same, watched by what lives longer.
  Execution watched_by(Watch& watch) const {
    Execution execution = *this;
    execution.watch_ = &watch;
    return execution;
  }

  /// for what takes long in one thread: throws if there is no use in going on.
  void look() const {
    if(watch_ != nullptr)
      watch_->look();
  }

  /// how many threads there may be.
  std::size_t number_of_threads() const;

  /// calls `f(begin, end)` on ranges that cover [0, n). They begin at multiples of `grain` and have
  /// that size, whatever the number of threads, so that sums kept per range are reproducible.
  template <typename Function>
  void for_ranges(std::size_t n, std::size_t grain, const Function& f) const {
    const auto call = [&](std::size_t i) {
      look();
      f(i * grain, (std::min)(n, (i + 1) * grain));
    };
    for_each_range((n + grain - 1) / grain, {&call, [](const void* c, std::size_t i) {
                                               (*static_cast<decltype(&call)>(c))(i);
                                             }});
  }

private:
  // A function without its type: the library for threads is compiled for this one only.
  struct Range_function
  {
    const void* function;
    void (*call)(const void*, std::size_t);
  };

  void for_each_range(std::size_t number, const Range_function& f) const;

  bool is_parallel_ = false;
  Watch* watch_ = nullptr;
};

/// the execution that a concurrency tag stands for.
template <typename ConcurrencyTag> constexpr Execution execution_of() {
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
  static_assert(has_threads || !is_parallel,
                "Parallel_tag is used but the program is not linked with TBB");
  return is_parallel ? Execution::parallel() : Execution();
}

/// calls `f(i)` for all i in [0, n).
template <typename Function>
void for_each_index(Execution execution,
                    std::size_t n,
                    const Function& f,
                    std::size_t grain = 4096) {
  execution.for_ranges(n, grain, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      f(i);
  });
}

/// A range of any kind, say the faces of a mesh, cut into parts that threads can go through at the
/// same time. The iterators may be slow to advance, as those of a list, or of a mesh with removed
/// elements: nothing is gone through twice.
template <typename Iterator> class Range_parts
{
public:
  template <typename Range>
  explicit Range_parts(const Range& range, std::size_t part_size = 4096)
      : size_(static_cast<std::size_t>(std::distance(range.begin(), range.end()))) {
    CGAL_precondition(part_size > 0);
    Iterator it = range.begin();
    bounds_.push_back(it);
    for(std::size_t left = size_; left > 0;) {
      const std::size_t step = (std::min)(left, part_size);
      std::advance(it, static_cast<std::ptrdiff_t>(step));
      bounds_.push_back(it);
      left -= step;
    }
  }

  /// \p bounds are where the parts begin, and the end.
  Range_parts(std::size_t size, std::vector<Iterator> bounds)
      : size_(size)
      , bounds_(std::move(bounds)) {}

  /// the number of elements.
  std::size_t size() const { return size_; }

  std::size_t number_of_parts() const { return bounds_.size() - 1; }

  /// calls `f(i, begin, end)` for each part i.
  template <typename Function> void for_each_part(Execution execution, const Function& f) const {
    for_each_index(
        execution, number_of_parts(), [&](std::size_t i) { f(i, bounds_[i], bounds_[i + 1]); }, 1);
  }

  /// calls `f(x)` for each element x.
  template <typename Function> void for_each(Execution execution, const Function& f) const {
    for_each_part(execution, [&](std::size_t, Iterator begin, Iterator end) {
      for(; begin != end; ++begin)
        f(*begin);
    });
  }

private:
  std::size_t size_;
  std::vector<Iterator> bounds_; // where the parts begin, and the end
};

template <typename Range> auto parts_of(const Range& range) {
  return Range_parts<std::decay_t<decltype(range.begin())>>(range);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_PARALLEL_H
