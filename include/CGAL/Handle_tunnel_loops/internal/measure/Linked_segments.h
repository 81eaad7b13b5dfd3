// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LINKED_SEGMENTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LINKED_SEGMENTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_curtains.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linking_rank.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How segments pass through curtains of loops: their numbers add up, along closed polylines, to
/// linking numbers.
class Linked_segments
{
public:
  Linked_segments(Execution execution, const std::vector<std::vector<Vector>>& loops)
      : curtains_(execution, loops)
      , keys_(loops.size()) {
    std::mt19937_64 random;
    double sum = 0.;
    std::size_t number = 1;
    for(const auto& loop : loops)
      for(std::size_t i = 1; i < loop.size(); ++i, ++number)
        sum += norm(loop[i] - loop[i - 1]);
    length_of_pieces_ = 16. * sum / static_cast<double>(number);
    for(std::uint64_t& key : keys_)
      key = random();
  }

  /// adds the numbers of a segment to a row. Long ones are cut into pieces, so that less is near
  /// them.
  void add(const Vector& a, const Vector& b, Linking_row& row, int factor = 1) const {
    constexpr double most_pieces = 256.;
    const double pieces = std::ceil(norm(b - a) / length_of_pieces_);
    const int n = pieces >= 1. ? static_cast<int>((std::min)(pieces, most_pieces)) : 1;
    Vector from = a;
    for(int i = 1; i <= n; ++i) {
      const Vector to = i == n ? b : (1. - double(i) / n) * a + (double(i) / n) * b;
      curtains_.for_each_passage(from, to, [&](const Loop_curtains::Passage& p) {
        row.emplace_back(p.loop, factor * p.sign);
      });
      from = to;
    }
  }

  /// a number of a row that is 0 for one without entries, and adds up; of different rows it is
  /// different, almost surely.
  std::uint64_t name(const Linking_row& row) const {
    std::uint64_t sum = 0;
    for(const auto& [loop, number] : row)
      sum += keys_[loop] * static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
    return sum;
  }

  std::uint64_t name(const Vector& a, const Vector& b) const {
    Linking_row row;
    add(a, b, row);
    return name(row);
  }

private:
  Loop_curtains curtains_;
  std::vector<std::uint64_t> keys_; // by loop
  double length_of_pieces_ = 0.;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LINKED_SEGMENTS_H
