// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SORT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SORT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// sorts; not stable.
template <typename Iterator, typename Less>
void sort(Execution execution, Iterator first, Iterator last, const Less& less) {
#ifdef CGAL_LINKED_WITH_TBB
  if(execution.is_parallel())
    return tbb::parallel_sort(first, last, less);
#endif
  (void)execution;
  std::sort(first, last, less);
}

/// sorts items, of which there are fewer than 2^32, by one digit of their keys; those with the same
/// digit keep their order. Each range of them knows beforehand where its items of each digit go, so
/// that the ranges can be moved at the same time.
template <unsigned digits, typename Item, typename Digit>
void sort_by_digit(Execution execution,
                   const Uninitialized_vector<Item>& items,
                   Uninitialized_vector<Item>& sorted,
                   const Digit& digit) {
  constexpr std::size_t grain = std::size_t(1) << 16;
  CGAL_precondition(items.size() <= (std::numeric_limits<std::uint32_t>::max)());
  CGAL_precondition(sorted.size() == items.size());
  const std::size_t ranges = (items.size() + grain - 1) / grain;
  std::vector<std::uint32_t> places(ranges * digits, 0); // by range and digit
  execution.for_ranges(items.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::uint32_t* count = places.data() + begin / grain * digits;
    for(std::size_t i = begin; i < end; ++i)
      ++count[digit(items[i])];
  });
  std::uint32_t sum = 0;
  for(std::size_t d = 0; d < digits; ++d)
    for(std::size_t r = 0; r < ranges; ++r)
      sum += std::exchange(places[r * digits + d], sum);
  execution.for_ranges(items.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::uint32_t* place = places.data() + begin / grain * digits;
    for(std::size_t i = begin; i < end; ++i)
      sorted[place[digit(items[i])]++] = items[i];
  });
}

/// sorts items by the low bits of `key(item)`, an unsigned integer; equal ones keep their order.
template <unsigned bits, typename Item, typename Key>
void radix_sort(Execution execution, Uninitialized_vector<Item>& items, const Key& key) {
  constexpr unsigned bits_of_digit = 10, digits = 1u << bits_of_digit;
  Uninitialized_vector<Item> sorted(items.size());
  for(unsigned shift = 0; shift < bits; shift += bits_of_digit) {
    sort_by_digit<digits>(execution, items, sorted,
                          [&](const Item& item) { return key(item) >> shift & (digits - 1); });
    items.swap(sorted);
  }
}

/// spreads the ten low bits of `x` to every third bit.
inline std::uint32_t every_third_bit(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

/// the cell of a Morton curve, of 2^30 through the unit box, that a point is in.
inline std::uint32_t cell_of_curve(const Vector& p) {
  constexpr double cells = 1023.;
  std::uint32_t cell = 0;
  for(int d = 0; d < 3; ++d) {
    CGAL_precondition(p[d] >= 0. && p[d] <= 1.);
    cell |= every_third_bit(static_cast<std::uint32_t>(p[d] * cells)) << d;
  }
  return cell;
}

/// the numbers 0 .. n - 1 of points `point(i)` in the unit box, sorted along a Morton curve, those
/// in one cell by their numbers. Meshes come in any order; a field that walks them in file order
/// waits for memory.
template <typename Point>
Uninitialized_vector<Index>
space_filling_order(Execution execution, std::size_t n, const Point& point) {
  struct Numbered_cell
  {
    std::uint32_t cell;
    Index number;
  };
  Uninitialized_vector<Numbered_cell> numbered(n);
  for_each_index(execution, n, [&](std::size_t i) {
    numbered[i] = {cell_of_curve(point(i)), static_cast<Index>(i)};
  });
  radix_sort<30>(execution, numbered, [](const Numbered_cell& c) { return c.cell; });

  Uninitialized_vector<Index> order(n);
  for_each_index(execution, n, [&](std::size_t i) { order[i] = numbered[i].number; });
  return order;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SORT_H
