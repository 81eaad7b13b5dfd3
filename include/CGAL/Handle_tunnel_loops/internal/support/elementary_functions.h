// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ELEMENTARY_FUNCTIONS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ELEMENTARY_FUNCTIONS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

// Functions that C libraries round as they like, while sums, products, quotients, square roots and
// powers of two are the same everywhere. Here they are made of these: the last bit or two may be
// wrong, but are so on all machines.

namespace CGAL::Handle_tunnel_loops::internal {

/// c[0] + c[1] x + c[2] x^2 + ...
template <std::size_t n> double polynomial(const std::array<double, n>& c, double x) {
  double sum = c[n - 1];
  for(std::size_t i = n - 1; i-- > 0;)
    sum = rounded_product(sum, x) + c[i];
  return sum;
}

struct Sine_and_cosine
{
  double sine, cosine;
};

/// of an angle of no more than a million.
inline Sine_and_cosine sine_and_cosine(double angle) {
  CGAL_precondition(!(std::abs(angle) > 1e6));
  // A quarter turn in three parts: the first two have so few digits that products with them are
  // exact.
  constexpr double quarter[] = {1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21};
  // The series, of which what is left out is less than a rounding error for half a quarter turn.
  constexpr std::array<double, 8> of_sine = {
      -1. / 6,        1. / 120,        -1. / 5040,          1. / 362880,
      -1. / 39916800, 1. / 6227020800, -1. / 1307674368000, 1. / 355687428096000};
  constexpr std::array<double, 8> of_cosine = {
      1. / 24,        -1. / 720,         1. / 40320,          -1. / 3628800,
      1. / 479001600, -1. / 87178291200, 1. / 20922789888000, -1. / 6402373705728000};
  const double quarters = std::floor(rounded_product(angle, 2. / CGAL_PI) + 0.5);
  double x = angle;
  for(const double part : quarter)
    x -= rounded_product(quarters, part);
  const double square = rounded_product(x, x);
  const double sine = x + rounded_product(rounded_product(x, square), polynomial(of_sine, square));
  const double cosine =
      1. - rounded_product(0.5, square) +
      rounded_product(rounded_product(square, square), polynomial(of_cosine, square));
  switch(static_cast<long long>(quarters) & 3) {
  case 0:
    return {sine, cosine};
  case 1:
    return {cosine, -sine};
  case 2:
    return {-sine, -cosine};
  default:
    return {-cosine, sine};
  }
}

inline double sine(double angle) { return sine_and_cosine(angle).sine; }
inline double cosine(double angle) { return sine_and_cosine(angle).cosine; }

/// the angle of a number between 0 and 1 that is a tangent.
inline double arc_tangent_in_octant(double tangent) {
  constexpr double of_quarters[] = {0., 0.24497866312686414, 0.4636476090008061, 0.6435011087932844,
                                    0.7853981633974483};
  constexpr std::array<double, 10> series = {1.,       -1. / 3, 1. / 5,   -1. / 7, 1. / 9,
                                             -1. / 11, 1. / 13, -1. / 15, 1. / 17, -1. / 19};
  const double nearest = std::floor(rounded_product(4., tangent) + 0.5), known = nearest / 4.;
  const double x = (tangent - known) / (1. + rounded_product(tangent, known));
  return of_quarters[static_cast<int>(nearest)] +
         rounded_product(x, polynomial(series, rounded_product(x, x)));
}

/// the angle, between -pi and pi, of a direction in the plane; 0 of none.
inline double arc_tangent(double y, double x) {
  const double width = std::abs(x), height = std::abs(y);
  if(!(width > 0. || height > 0.))
    return 0.;
  const double angle = height <= width ? arc_tangent_in_octant(height / width)
                                       : CGAL_PI / 2. - arc_tangent_in_octant(width / height);
  return std::copysign(x < 0. ? CGAL_PI - angle : angle, y);
}

/// the angles, between -pi / 2 and pi / 2, and between 0 and pi, of a sine and a cosine.
inline double arc_sine(double sine) {
  return arc_tangent(sine, std::sqrt(rounded_product(1. - sine, 1. + sine)));
}
inline double arc_cosine(double cosine) {
  return arc_tangent(std::sqrt(rounded_product(1. - cosine, 1. + cosine)), cosine);
}

// ln 2 in two parts, of which products of the first one with exponents are exact.
constexpr double ln_2[] = {0.6931471803691238, 1.9082149292705877e-10};

/// the natural logarithm of a positive number.
inline double logarithm(double number) {
  CGAL_precondition(number > 0.);
  constexpr std::array<double, 12> series = {2.,      2. / 3,  2. / 5,  2. / 7,  2. / 9,  2. / 11,
                                             2. / 13, 2. / 15, 2. / 17, 2. / 19, 2. / 21, 2. / 23};
  int exponent;
  double fraction = std::frexp(number, &exponent);
  if(fraction < 0.7071067811865476) {
    fraction *= 2.;
    --exponent;
  }
  const double x = (fraction - 1.) / (fraction + 1.);
  return rounded_product(exponent, ln_2[0]) +
         (rounded_product(x, polynomial(series, rounded_product(x, x))) +
          rounded_product(exponent, ln_2[1]));
}

/// the whole part of twice the logarithm to the base 2 of a positive number.
inline int half_octave(double number) {
  int exponent;
  const double fraction = 2. * std::frexp(number, &exponent); // from 1 to 2
  return 2 * (exponent - 1) + (rounded_product(fraction, fraction) >= 2. ? 1 : 0);
}

/// e to the power of a number.
inline double exponential(double number) {
  constexpr double most = 710., least = -750.; // more, or less, is infinite, or nothing
  constexpr std::array<double, 15> series = {1.,
                                             1.,
                                             1. / 2,
                                             1. / 6,
                                             1. / 24,
                                             1. / 120,
                                             1. / 720,
                                             1. / 5040,
                                             1. / 40320,
                                             1. / 362880,
                                             1. / 3628800,
                                             1. / 39916800,
                                             1. / 479001600,
                                             1. / 6227020800,
                                             1. / 87178291200};
  if(!(number > least && number < most))
    return number >= most ? std::numeric_limits<double>::infinity() : number <= least ? 0. : number;
  const double exponent = std::floor(number / (ln_2[0] + ln_2[1]) + 0.5);
  const double rest =
      number - rounded_product(exponent, ln_2[0]) - rounded_product(exponent, ln_2[1]);
  return std::ldexp(polynomial(series, rest), static_cast<int>(exponent));
}

/// a positive number to the power of another one.
inline double power(double number, double exponent) {
  return exponential(rounded_product(exponent, logarithm(number)));
}

/// a number to the power of a whole one that is not negative, by squaring it.
inline double integer_power(double number, int exponent) {
  CGAL_precondition(exponent >= 0);
  double product = 1.;
  for(; exponent > 0; exponent /= 2, number = rounded_product(number, number))
    if(exponent % 2 == 1)
      product = rounded_product(product, number);
  return product;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_ELEMENTARY_FUNCTIONS_H
