// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_BASIS_EXCHANGE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_BASIS_EXCHANGE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Chooses which handle loops can be replaced by their refinements so that the loops remain a basis.

Let h_i and t_i be the loops before. The handles are disjoint, and t_i crosses h_i once and no h_j
with j > i; so (h, t) is a basis, and the class of any curve x = sum of a_i h_i + b_i t_i follows
from its intersection numbers with the basis by two triangular substitutions. Replacing h_k for all
k in a set S gives a basis if and only if the matrix (a_i of the refinement of h_k), i and k in S,
has determinant 1 or -1. The set is grown by elimination with pivots 1 and -1, in integers. Should a
number ever need more than 31 bits, the replacement is refused.
*/
class Basis_exchange
{
public:
  /// Coefficients a_i of a class, by i; no zeros.
  using Row = std::vector<std::pair<Index, std::int64_t>>;

  Basis_exchange(const std::vector<Crossing_loop>& tunnels,
                 const Crossing_index& handle_index,
                 const Crossing_index& tunnel_index)
      : tunnels_(tunnels)
      , handle_index_(handle_index)
      , tunnel_index_(tunnel_index)
      , crossed_handles_(tunnels.size())
      , crossing_tunnels_(tunnels.size())
      , place_(tunnels.size(), static_cast<std::size_t>(-1))
      , value_(tunnels.size(), 0) {
    for(Index i = 0; i < tunnels.size(); ++i) {
      crossed_handles_[i] = handle_index.intersections(tunnels[i]);
      for(const auto& [j, number] : crossed_handles_[i])
        crossing_tunnels_[j].emplace_back(i, number);
      CGAL_precondition_msg(is_dual(crossed_handles_[i], i, Loops_from{i}),
                            "a tunnel crosses its handle once, and none with a larger number");
    }
  }

  /// the coefficients of the class of a loop at the handles; nothing if they are too large. May be
  /// called by many threads.
  std::optional<Row> handle_part(const Crossing_loop& loop) const {
    try {
      Sparse_numbers with_handles = handle_index_.intersections(loop);
      Sparse_numbers with_tunnels = tunnel_index_.intersections(loop);
      subtract_tunnel_part(with_handles, with_tunnels);
      return solve_handle_part(with_tunnels);
    } catch(const Too_large&) {
      return std::nullopt;
    }
  }

  /// whether handle `k` can be replaced by a loop with the given coefficients, besides those
  /// replaced before.
  bool accept(Index k, const Row& coefficients) {
    CGAL_precondition_msg(place_[k] >= accepted_.size(), "a handle is replaced once");
    CGAL_precondition(std::is_sorted(coefficients.begin(), coefficients.end()));
    bool is_unit = false;
    try {
      reduce(coefficients);
      is_unit = std::abs(value_[k]) == 1;
    } catch(const Too_large&) {
    }
    Row row = take_values();
    if(!is_unit)
      return false;
    place_[k] = accepted_.size();
    accepted_.push_back({k, std::move(row)});
    return true;
  }

private:
  struct Too_large : std::runtime_error
  {
    Too_large()
        : std::runtime_error("an integer is too large") {}
  };

  struct Accepted
  {
    Index pivot;
    Row row;
  };

  /// a - b c.
  static std::int64_t minus_product(std::int64_t a, std::int64_t b, std::int64_t c) {
    constexpr std::int64_t limit = std::int64_t(1) << 31;
    const auto is_large = [](std::int64_t x) { return x >= limit || x <= -limit; };
    if(is_large(b) || is_large(c) || is_large(a - b * c))
      throw Too_large();
    return a - b * c;
  }

  // The b_i follow from the intersections with the handles, the last one first.
  void subtract_tunnel_part(Sparse_numbers& with_handles, Sparse_numbers& with_tunnels) const {
    while(!with_handles.empty()) {
      const auto [j, number] = *with_handles.rbegin();
      const std::int64_t b = number * crossed_handles_[j].at(j);
      if(b != 0) {
        for(const auto& [i, crossing] : crossed_handles_[j])
          with_handles[i] = minus_product(with_handles[i], b, crossing);
        for(const auto& [i, crossing] : tunnel_index_.intersections(tunnels_[j]))
          with_tunnels[i] = minus_product(with_tunnels[i], b, crossing);
      }
      with_handles.erase(j);
    }
  }

  // The a_i follow from what is left of the intersections with the tunnels, the first one first.
  Row solve_handle_part(Sparse_numbers& with_tunnels) const {
    Row row;
    while(!with_tunnels.empty()) {
      const auto [j, number] = *with_tunnels.begin();
      const std::int64_t a = -number * crossed_handles_[j].at(j);
      if(a != 0) {
        row.emplace_back(j, a);
        for(const auto& [i, crossing] : crossing_tunnels_[j])
          with_tunnels[i] = minus_product(with_tunnels[i], -a, crossing);
      }
      with_tunnels.erase(j);
    }
    return row;
  }

  // Spreads the row out in `value_` and eliminates the columns of the accepted pivots, in their
  // order.
  void reduce(const Row& row) {
    std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> places;
    const auto subtract = [&](const Row& other, std::int64_t factor) {
      for(const auto& [i, number] : other) {
        const bool was_zero = value_[i] == 0;
        value_[i] = minus_product(value_[i], factor, number);
        if(!was_zero || value_[i] == 0)
          continue;
        touched_.push_back(i);
        if(place_[i] < accepted_.size())
          places.push(place_[i]);
      }
    };
    subtract(row, -1);
    while(!places.empty()) {
      const Accepted& next = accepted_[places.top()];
      places.pop();
      const std::int64_t pivot = value_at(next.row, next.pivot);
      CGAL_assertion_msg(std::abs(pivot) == 1, "pivots are units");
      subtract(next.row, value_[next.pivot] * pivot);
    }
  }

  static std::int64_t value_at(const Row& row, Index i) {
    const auto it = std::lower_bound(row.begin(), row.end(), std::make_pair(i, INT64_MIN));
    CGAL_assertion(it != row.end() && it->first == i);
    return it->second;
  }

  // Gathers what is spread out, and clears it.
  Row take_values() {
    std::sort(touched_.begin(), touched_.end());
    Row row;
    for(Index i : touched_)
      if(value_[i] != 0) {
        row.emplace_back(i, value_[i]);
        value_[i] = 0;
      }
    touched_.clear();
    CGAL_expensive_assertion(std::count(value_.begin(), value_.end(), 0) ==
                             static_cast<std::ptrdiff_t>(value_.size()));
    return row;
  }

  const std::vector<Crossing_loop>& tunnels_;
  const Crossing_index& handle_index_;
  const Crossing_index& tunnel_index_;
  std::vector<Sparse_numbers> crossed_handles_; // t_i . h_j by i
  std::vector<Row> crossing_tunnels_;           // t_i . h_j by j
  std::vector<Accepted> accepted_;
  std::vector<std::size_t> place_; // in `accepted_`, by handle; very large if not accepted
  std::vector<std::int64_t> value_;
  std::vector<Index> touched_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_BASIS_EXCHANGE_H
