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

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// how many of the first `n` elements of two sorted ranges, merged, are of the first one, which has
/// those that are equal before the second one.
template <typename Iterator, typename Less>
std::size_t
part_of_first(std::size_t n, Iterator first, Iterator second, Iterator end, const Less& less) {
  const auto size = static_cast<std::size_t>(second - first);
  const auto other_size = static_cast<std::size_t>(end - second);
  std::size_t least = n - (std::min)(n, other_size), most = (std::min)(n, size);
  while(least < most) {
    const std::size_t i = least + (most - least) / 2;
    if(less(second[n - i - 1], first[i]))
      most = i;
    else
      least = i + 1;
  }
  return least;
}

/// merges sorted ranges, of which each begins where `bounds` says, the first with the second, the
/// third with the fourth, and so on, to as many pieces as there are ranges.
template <typename Iterator, typename Target, typename Less>
void merge_pairs(Execution execution,
                 const std::vector<std::size_t>& bounds,
                 std::size_t width,
                 Iterator from,
                 Target to,
                 const Less& less) {
  const std::size_t parts = bounds.size() - 1, pieces = 2 * width;
  for_each_index(
      execution, parts,
      [&](std::size_t part) {
        const std::size_t begin = part / pieces * pieces, piece = part % pieces;
        const Iterator first = from + bounds[begin], second = from + bounds[begin + width],
                       end = from + bounds[begin + pieces];
        const auto size = static_cast<std::size_t>(end - first);
        const std::size_t n = size * piece / pieces, m = size * (piece + 1) / pieces;
        const std::size_t i = part_of_first(n, first, second, end, less);
        const std::size_t j = part_of_first(m, first, second, end, less);
        std::merge(first + i, first + j, second + (n - i), second + (m - j), to + bounds[begin] + n,
                   less);
      },
      1);
}

/// sorts; equal elements keep their order, so that the result is the same for any number of
/// threads.
template <typename Iterator, typename Less>
void sort(Execution execution, Iterator first, Iterator last, const Less& less) {
  constexpr std::size_t least_part = 2048;
  const auto n = static_cast<std::size_t>(last - first);
  std::size_t parts = 1; // a power of four, so that what is merged ends where it began
  while(parts < execution.number_of_threads() && n / (4 * parts) >= least_part)
    parts *= 4;
  if(parts == 1)
    return std::stable_sort(first, last, less);

  std::vector<std::size_t> bounds(parts + 1);
  for(std::size_t part = 0; part <= parts; ++part)
    bounds[part] = n / parts * part + (std::min)(part, n % parts);
  for_each_index(
      execution, parts,
      [&](std::size_t part) {
        std::stable_sort(first + bounds[part], first + bounds[part + 1], less);
      },
      1);
  std::vector<typename std::iterator_traits<Iterator>::value_type> merged(first, last);
  for(std::size_t width = 1; width < parts; width *= 4) {
    merge_pairs(execution, bounds, width, first, merged.begin(), less);
    merge_pairs(execution, bounds, 2 * width, merged.begin(), first, less);
  }
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
