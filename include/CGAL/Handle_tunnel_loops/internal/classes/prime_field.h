// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PRIME_FIELD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PRIME_FIELD_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstdint>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A number modulo the Mersenne prime 2^61 - 1.
using Residue = std::uint64_t;

constexpr Residue field_size = (Residue(1) << 61) - 1;

inline Residue sum(Residue a, Residue b) {
  return a + b >= field_size ? a + b - field_size : a + b;
}

inline Residue difference(Residue a, Residue b) { return a >= b ? a - b : a + field_size - b; }

/// by halves, for not all compilers have integers of 128 bits.
inline Residue product(Residue a, Residue b) {
  // (a1 2^31 + a0) (b1 2^31 + b0), and 2^62 = 2
  constexpr Residue low = (Residue(1) << 31) - 1;
  const Residue a0 = a & low, a1 = a >> 31, b0 = b & low, b1 = b >> 31;
  const Residue middle = a1 * b0 + a0 * b1; // below 2^62
  const Residue middle_low = middle & ((Residue(1) << 30) - 1), middle_high = middle >> 30;
  const Residue result = 2 * a1 * b1 + middle_high + (middle_low << 31) + a0 * b0;
  const Residue folded = (result & field_size) + (result >> 61);
  return folded >= field_size ? folded - field_size : folded;
}

/// by Fermat's little theorem.
inline Residue inverse(Residue a) {
  Residue result = 1;
  for(Residue exponent = field_size - 2; exponent != 0; exponent >>= 1) {
    if((exponent & 1) != 0)
      result = product(result, a);
    a = product(a, a);
  }
  return result;
}

inline Residue residue_of(std::int64_t x) {
  const std::int64_t r = x % static_cast<std::int64_t>(field_size);
  return r < 0 ? field_size - static_cast<Residue>(-r) : static_cast<Residue>(r);
}

/// the integer of smallest size in a class.
inline std::int64_t smallest_integer_of(Residue a) {
  return a <= field_size / 2 ? static_cast<std::int64_t>(a)
                             : -static_cast<std::int64_t>(field_size - a);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PRIME_FIELD_H
