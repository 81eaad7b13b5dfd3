// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_CLASS_VECTOR_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_CLASS_VECTOR_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A sparse vector of integers, sorted by index, without zeros: coordinates of a class in a basis,
/// or intersection numbers with one.
using Class_vector = std::vector<std::pair<Index, std::int64_t>>;

/// No factor and no coordinate of a sum of multiples is larger, so that products fit and sums of
/// them do.
constexpr std::int64_t largest_coordinate = std::int64_t(1) << 30;

inline bool is_too_large(std::int64_t x) {
  return x > largest_coordinate || x < -largest_coordinate;
}

/// the coordinate at an index.
inline std::int64_t coordinate(const Class_vector& v, Index i) {
  const auto it =
      std::lower_bound(v.begin(), v.end(), i, [](const auto& c, Index j) { return c.first < j; });
  return it != v.end() && it->first == i ? it->second : 0;
}

/// the sum of the products of coordinates at the same index.
inline std::int64_t product_sum(const Class_vector& v, const Class_vector& w) {
  std::int64_t sum = 0;
  for(const auto& [i, value] : w)
    sum += value * coordinate(v, i);
  return sum;
}

/// sums coordinates at the same index and leaves out zeros.
inline void normalize(Class_vector& v) {
  std::sort(v.begin(), v.end());
  std::size_t kept = 0;
  for(std::size_t i = 0; i < v.size();) {
    auto sum = v[i];
    for(++i; i < v.size() && v[i].first == sum.first; ++i)
      sum.second += v[i].second;
    if(sum.second != 0)
      v[kept++] = sum;
  }
  v.resize(kept);
}

/// adds a multiple of another vector. Returns `false` if a coordinate becomes too large.
inline bool add_multiple(Class_vector& v, std::int64_t factor, const Class_vector& w) {
  if(factor == 0)
    return true;
  if(is_too_large(factor))
    return false;
  Class_vector sum;
  sum.reserve(v.size() + w.size());
  auto a = v.begin();
  for(const auto& [index, value] : w) {
    for(; a != v.end() && a->first < index; ++a)
      sum.push_back(*a);
    const std::int64_t before = a != v.end() && a->first == index ? (a++)->second : 0;
    const std::int64_t x = before + factor * value;
    if(is_too_large(x))
      return false;
    if(x != 0)
      sum.emplace_back(index, x);
  }
  sum.insert(sum.end(), a, v.end());
  v = std::move(sum);
  return true;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_CLASS_VECTOR_H
