// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_LOOP_CONES_H
#define BENCHMARK_LOOP_CONES_H

#include "Triangle_tree.h"

#include <CGAL/Random.h>

#include <cstdint>
#include <map>
#include <vector>

/// \file Loop_cones.h
/// Linking numbers of closed lines with loops, as crossings with cones over the loops.

namespace voxel_measures {

/// A closed line, its first point not repeated.
using Line = std::vector<Point>;

/// Thrown where a line meets the border of a triangle of a cone, as next to none do.
struct Not_generic
{};

/// 1 or -1 if a segment crosses a triangle, by its direction; exact.
inline int crossing(const Point& p, const Point& q, const Triangle& t) {
  const auto side_p = CGAL::orientation(t[0], t[1], t[2], p),
             side_q = CGAL::orientation(t[0], t[1], t[2], q);
  if(side_p == side_q && side_p != CGAL::COPLANAR)
    return 0;
  int positive = 0, negative = 0;
  for(int i = 0; i < 3; ++i) {
    const auto o = CGAL::orientation(p, q, t[i], t[(i + 1) % 3]);
    positive += o == CGAL::POSITIVE;
    negative += o == CGAL::NEGATIVE;
  }
  if(positive > 0 && negative > 0)
    return 0;
  if(positive + negative < 3 || side_p == CGAL::COPLANAR || side_q == CGAL::COPLANAR)
    throw Not_generic();
  return side_p == CGAL::POSITIVE ? 1 : -1;
}

/// The triangles from a point in the middle of each loop to its sides.
class Loop_cones
{
public:
  Loop_cones(const std::vector<Line>& loops, CGAL::Random& random)
      : number_(loops.size()) {
    for(std::size_t i = 0; i < loops.size(); ++i) {
      const Line& loop = loops[i];
      const CGAL::Bbox_3 box = CGAL::bbox_3(loop.begin(), loop.end());
      const auto inner = [&](int axis) {
        return (box.min)(axis) +
               random.get_double(0.45, 0.55) * ((box.max)(axis) - (box.min)(axis));
      };
      const Point apex(inner(0), inner(1), inner(2));
      for(std::size_t k = 0; k < loop.size(); ++k)
        if(loop[k] != loop[(k + 1) % loop.size()]) {
          triangles_.push_back({apex, loop[k], loop[(k + 1) % loop.size()]});
          loop_.push_back(i);
        }
    }
  }

  std::size_t number_of_loops() const { return number_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  std::size_t loop(std::size_t triangle) const { return loop_[triangle]; }

  /// the linking number with each loop.
  std::vector<int> linking(const Line& line) const {
    std::vector<int> row(number_, 0);
    for(std::size_t i = 0; i < line.size(); ++i) {
      const Point &p = line[i], &q = line[(i + 1) % line.size()];
      const CGAL::Bbox_3 box = p.bbox() + q.bbox();
      for(std::size_t t = 0; t < triangles_.size(); ++t)
        if(p != q &&
           CGAL::do_overlap(box, CGAL::bbox_3(triangles_[t].begin(), triangles_[t].end())))
          row[loop_[t]] += crossing(p, q, triangles_[t]);
    }
    return row;
  }

private:
  std::size_t number_;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> loop_; ///< by triangle
};

/// Rows of whole numbers, and whether another one is independent of them; over the numbers modulo a
/// large prime, where rows of rank n have rank n but for some in a billion.
class Independent_rows
{
public:
  std::size_t rank() const { return rows_.size(); }

  /// adds the row if it is independent; returns whether it is.
  bool add(const std::vector<int>& numbers) {
    std::vector<std::uint64_t> row;
    for(const int n : numbers)
      row.push_back(n < 0 ? prime - std::uint64_t(-n) : std::uint64_t(n));
    for(const auto& [pivot, other] : rows_)
      if(const std::uint64_t factor = row[pivot]; factor != 0)
        for(std::size_t i = 0; i < row.size(); ++i)
          row[i] = (row[i] + (prime - factor) * other[i]) % prime;
    for(std::size_t i = 0; i < row.size(); ++i)
      if(row[i] != 0) {
        const std::uint64_t inverse = power(row[i], prime - 2);
        for(std::uint64_t& x : row)
          x = x * inverse % prime;
        rows_.emplace_back(i, row);
        return true;
      }
    return false;
  }

private:
  static constexpr std::uint64_t prime = 2147483647;

  static std::uint64_t power(std::uint64_t base, std::uint64_t exponent) {
    std::uint64_t result = 1;
    for(; exponent != 0; exponent /= 2, base = base * base % prime)
      if(exponent % 2 == 1)
        result = result * base % prime;
    return result;
  }

  std::vector<std::pair<std::size_t, std::vector<std::uint64_t>>> rows_; ///< with their pivots
};

} // namespace voxel_measures

#endif // BENCHMARK_LOOP_CONES_H
