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

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

template <typename ConcurrencyTag>
struct Is_parallel : std::is_convertible<ConcurrencyTag, Parallel_tag>
{};

/// The execution policies: `for_ranges(n, grain, f)` calls `f(begin, end)` on ranges that cover
/// [0, n). Ranges begin at multiples of `grain` and have that size, whatever the number of
/// threads, so that sums kept per range are reproducible. `invoke(f, g)` calls both, perhaps at the
/// same time. `sort(first, last, less)` is not stable. `number_of_threads()` is what there may be.
struct Sequential_execution
{
  static constexpr bool is_parallel = false;

  static std::size_t number_of_threads() { return 1; }

  template <typename Function>
  static void for_ranges(std::size_t n, std::size_t grain, const Function& f) {
    for(std::size_t begin = 0; begin < n; begin += grain)
      f(begin, (std::min)(n, begin + grain));
  }

  template <typename F, typename G> static void invoke(const F& f, const G& g) {
    f();
    g();
  }

  template <typename Iterator, typename Less>
  static void sort(Iterator first, Iterator last, const Less& less) {
    std::sort(first, last, less);
  }
};

#ifdef CGAL_LINKED_WITH_TBB
struct Parallel_execution
{
  static constexpr bool is_parallel = true;

  static std::size_t number_of_threads() {
    return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  }

  template <typename Function>
  static void for_ranges(std::size_t n, std::size_t grain, const Function& f) {
    const std::size_t number_of_ranges = (n + grain - 1) / grain;
    tbb::parallel_for(std::size_t(0), number_of_ranges,
                      [&](std::size_t i) { f(i * grain, (std::min)(n, (i + 1) * grain)); });
  }

  template <typename F, typename G> static void invoke(const F& f, const G& g) {
    for_ranges(2, 1, [&](std::size_t i, std::size_t) {
      if(i == 0)
        f();
      else
        g();
    });
  }

  template <typename Iterator, typename Less>
  static void sort(Iterator first, Iterator last, const Less& less) {
    tbb::parallel_sort(first, last, less);
  }
};
#endif

template <typename ConcurrencyTag> constexpr auto execution() {
#ifdef CGAL_LINKED_WITH_TBB
  return std::conditional_t<Is_parallel<ConcurrencyTag>::value, Parallel_execution,
                            Sequential_execution>();
#else
  static_assert(!Is_parallel<ConcurrencyTag>::value,
                "Parallel_tag is used but the program is not linked with TBB");
  return Sequential_execution();
#endif
}

/// calls `f(i)` for all i in [0, n).
template <typename Execution, typename Function>
void for_each_index(Execution, std::size_t n, const Function& f, std::size_t grain = 4096) {
  Execution::for_ranges(n, grain, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      f(i);
  });
}

/// concatenates `f(begin, end)`, vectors computed range by range, in the order of the ranges.
template <typename T, typename Execution, typename Function>
std::vector<T> collect(Execution, std::size_t n, const Function& f, std::size_t grain = 16384) {
  std::vector<std::vector<T>> parts((n + grain - 1) / grain);
  Execution::for_ranges(
      n, grain, [&](std::size_t begin, std::size_t end) { parts[begin / grain] = f(begin, end); });
  std::vector<T> all;
  for(const std::vector<T>& part : parts)
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// replaces each number by the sum of those before it. Returns the sum of all.
template <typename Execution, typename Numbers>
std::size_t sum_before_each(Execution, Numbers& numbers, std::size_t grain = 65536) {
  std::vector<std::size_t> sums((numbers.size() + grain - 1) / grain, 0);
  Execution::for_ranges(numbers.size(), grain, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      sums[begin / grain] += numbers[i];
  });
  std::size_t sum = 0;
  for(std::size_t& s : sums)
    sum += std::exchange(s, sum);
  Execution::for_ranges(numbers.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::uint32_t before = static_cast<std::uint32_t>(sums[begin / grain]);
    for(std::size_t i = begin; i < end; ++i)
      before += std::exchange(numbers[i], before);
  });
  return sum;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_PARALLEL_H
