// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_RANDOM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_RANDOM_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {

/// A generator of random numbers (splitmix64) that gives the same numbers on every platform, which
/// the distributions of the standard library do not.
class Random
{
public:
  explicit Random(std::uint64_t seed)
      : state_(seed * 0x9e3779b97f4a7c15u + 0x632be59bd9b4e019u) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// an integer in [0, n), n > 0. The bias of the remainder is of no consequence here.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }

  /// a number in [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
  }

  template <typename T> void shuffle(std::vector<T>& values) {
    for(std::size_t i = values.size(); i > 1; --i)
      std::swap(values[i - 1], values[below(i)]);
  }

private:
  std::uint64_t state_;
};

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_RANDOM_H
