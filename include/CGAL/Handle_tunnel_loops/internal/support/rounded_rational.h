// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ROUNDED_RATIONAL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ROUNDED_RATIONAL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Handle_tunnel_loops::internal {

/// the quotient of two of Boost's integers, rounded to the nearest number. They may be too large to
/// be rounded before they are divided.
template <typename Integer> double rounded_quotient(Integer numerator, Integer denominator) {
  if(numerator == 0)
    return 0.;
  const bool is_negative = (numerator < 0) != (denominator < 0);
  numerator = abs(numerator);
  denominator = abs(denominator);
  constexpr int bits = 60; // of the integer quotient, or one more: some more than a result has
  const int shift = bits + static_cast<int>(msb(denominator)) - static_cast<int>(msb(numerator));
  if(shift > 0)
    numerator <<= shift;
  else
    denominator <<= -shift;
  const Integer quotient = numerator / denominator;
  const bool is_more = quotient * denominator != numerator; // than half-way, if it looks like that
  const double value = std::ldexp(
      static_cast<double>(static_cast<std::uint64_t>(quotient) | std::uint64_t(is_more)), -shift);
  return is_negative ? -value : value;
}

#ifdef CGAL_USE_GMP
/// a rational number rounded to the nearest one; of two that are as near, to the even one.
inline double rounded(const Exact_rational& number) {
  const double nearer_to_zero = CGAL::to_double(number); // GMP leaves digits off
  const double infinity = std::numeric_limits<double>::infinity();
  const double farther = std::nextafter(nearer_to_zero, number < 0 ? -infinity : infinity);
  if(!std::isfinite(farther))
    return nearer_to_zero;
  const Exact_rational middle = (Exact_rational(nearer_to_zero) + Exact_rational(farther)) / 2;
  if(number == middle) {
    int exponent;
    return std::fmod(std::ldexp(std::frexp(farther, &exponent), 53), 2.) == 0. ? farther
                                                                               : nearer_to_zero;
  }
  return (number < middle) == (number < 0) ? farther : nearer_to_zero;
}
#else
/// the same without GMP.
inline double rounded(const Exact_rational& number) {
  using Traits = Fraction_traits<Exact_rational>;
  typename Traits::Numerator_type numerator;
  typename Traits::Denominator_type denominator;
  typename Traits::Decompose()(number, numerator, denominator);
  return rounded_quotient(numerator, denominator);
}
#endif

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ROUNDED_RATIONAL_H
