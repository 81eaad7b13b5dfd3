// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_COLLECT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_COLLECT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// `f(begin, end)`, vectors computed range by range, in the order of the ranges.
template <typename T, typename Function>
std::vector<std::vector<T>>
collect_parts(Execution execution, std::size_t n, const Function& f, std::size_t grain) {
  std::vector<std::vector<T>> parts((n + grain - 1) / grain);
  execution.for_ranges(
      n, grain, [&](std::size_t begin, std::size_t end) { parts[begin / grain] = f(begin, end); });
  return parts;
}

/// concatenates `f(begin, end)`, vectors computed range by range, in the order of the ranges.
template <typename T, typename Function>
std::vector<T>
collect(Execution execution, std::size_t n, const Function& f, std::size_t grain = 16384) {
  std::vector<T> all;
  for(const std::vector<T>& part : collect_parts<T>(execution, n, f, grain))
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// the same for what is large: an `Uninitialized_vector` is filled by all threads.
template <typename Vector, typename Function>
Vector
collect_many(Execution execution, std::size_t n, const Function& f, std::size_t grain = 16384) {
  const auto parts = collect_parts<typename Vector::value_type>(execution, n, f, grain);
  std::vector<std::size_t> begins(parts.size() + 1, 0);
  for(std::size_t i = 0; i < parts.size(); ++i)
    begins[i + 1] = begins[i] + parts[i].size();
  Vector all(begins.back());
  for_each_index(
      execution, parts.size(),
      [&](std::size_t i) { std::copy(parts[i].begin(), parts[i].end(), all.begin() + begins[i]); },
      1);
  return all;
}

/// replaces each number by the sum of those before it. Returns the sum of all.
template <typename Numbers>
std::size_t sum_before_each(Execution execution, Numbers& numbers, std::size_t grain = 65536) {
  std::vector<std::size_t> sums((numbers.size() + grain - 1) / grain, 0);
  execution.for_ranges(numbers.size(), grain, [&](std::size_t begin, std::size_t end) {
    sums[begin / grain] =
        std::accumulate(numbers.begin() + begin, numbers.begin() + end, std::size_t(0));
  });
  std::size_t sum = 0;
  for(std::size_t& s : sums)
    sum += std::exchange(s, sum);
  CGAL_postcondition(sum <= (std::numeric_limits<std::uint32_t>::max)());
  execution.for_ranges(numbers.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::uint32_t before = static_cast<std::uint32_t>(sums[begin / grain]);
    for(std::size_t i = begin; i < end; ++i)
      before += std::exchange(numbers[i], before);
  });
  return sum;
}

/// Workspaces that are large to make and cheap to use again: as many as are in use at one time.
template <typename Workspace> class Workspace_pool
{
public:
  explicit Workspace_pool(std::function<std::unique_ptr<Workspace>()> make)
      : make_(std::move(make)) {}

  /// lends a workspace until the returned object goes out of scope.
  auto borrow() {
    const auto give_back = [this](Workspace* workspace) {
      const std::lock_guard<std::mutex> lock(mutex_);
      free_.emplace_back(workspace);
    };
    return std::unique_ptr<Workspace, decltype(give_back)>(take().release(), give_back);
  }

private:
  std::unique_ptr<Workspace> take() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if(!free_.empty()) {
        std::unique_ptr<Workspace> workspace = std::move(free_.back());
        free_.pop_back();
        return workspace;
      }
    }
    return make_();
  }

  std::function<std::unique_ptr<Workspace>()> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Workspace>> free_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_COLLECT_H
