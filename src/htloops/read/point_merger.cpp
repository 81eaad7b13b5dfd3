// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/point_merger.h"

#include <cstring>

namespace htloops {

std::size_t Point_merger::Hash::operator()(const Bits& bits) const {
  std::uint64_t hash = 0;
  for(const std::uint64_t x : bits) {
    hash = (hash ^ x) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32; // the bits in which coordinates differ are the upper ones
  }
  return static_cast<std::size_t>(hash);
}

Point_merger::Bits Point_merger::bits_of(const Point& point) {
  Bits bits;
  for(int i = 0; i < 3; ++i) {
    const double x = point[i] + 0.; // makes one of the two zeros
    std::memcpy(&bits[static_cast<std::size_t>(i)], &x, sizeof x);
  }
  return bits;
}

} // namespace htloops
