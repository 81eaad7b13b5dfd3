// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SQUARE_ROOT_SUM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SQUARE_ROOT_SUM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/assertions.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <sstream>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
A sum of square roots of rational numbers, each added or subtracted, and its exact sign.

The roots are computed by integers with more and more binary digits, until the sum is farther from
zero than it can be off. Whether it is zero is decided beforehand: square roots of integers that are
no rational multiples of each other are linearly independent over the rationals, so that the sum
is zero exactly if it is for the terms of each class of multiples; and sqrt(m) is a multiple of
sqrt(n) exactly if m n is a square.
*/
class Square_root_sum
{
public:
  /// adds `sign` (1 or -1) times the square root of a number that is not negative.
  void add(int sign, const Exact_rational& radicand) {
    CGAL_precondition(sign == 1 || sign == -1);
    CGAL_precondition(radicand >= 0);
    typename Fraction::Numerator_type numerator;
    typename Fraction::Denominator_type denominator;
    typename Fraction::Decompose()(radicand, numerator, denominator);
    // sqrt(p / q) = sqrt(p q) / q
    const Integer p = integer(numerator), q = integer(denominator);
    if(p != 0)
      terms_.push_back({sign, q, Integer(p * q)});
  }

  int sign() const {
    constexpr unsigned first_digits = 96;
    if(const int s = sign(first_digits))
      return s;
    if(is_zero())
      return 0;
    for(unsigned digits = 2 * first_digits;; digits *= 2)
      if(const int s = sign(digits))
        return s;
  }

private:
  using Fraction = Fraction_traits<Exact_rational>;
  using Integer = boost::multiprecision::cpp_int;

  // sign * sqrt(root) / divisor
  struct Term
  {
    int sign;
    Integer divisor, root;
  };

  // (numerator / denominator) * sqrt(root)
  struct Class_sum
  {
    Integer root, numerator, denominator;
  };

  // Integers of different libraries have in common how they are written.
  template <typename Number> static Integer integer(const Number& number) {
    std::ostringstream digits;
    digits << number;
    return Integer(digits.str());
  }

  // 0 if so many binary digits do not decide.
  int sign(unsigned digits) const {
    Integer sum = 0;
    for(const Term& t : terms_)
      sum += t.sign *
             Integer(boost::multiprecision::sqrt(Integer(t.root << (2 * digits))) / t.divisor);
    // Each term is less than 2 too small.
    const Integer error = 2 * terms_.size();
    return sum > error ? 1 : sum < -error ? -1 : 0;
  }

  bool is_zero() const {
    std::vector<Class_sum> classes;
    for(const Term& t : terms_)
      add_to_class(t, classes);
    for(const Class_sum& c : classes)
      if(c.numerator != 0)
        return false;
    return true;
  }

  static void add_to_class(const Term& t, std::vector<Class_sum>& classes) {
    for(Class_sum& c : classes) {
      Integer rest;
      const Integer factor = boost::multiprecision::sqrt(Integer(t.root * c.root), rest);
      if(rest == 0) {
        // sqrt(t.root) = (factor / c.root) sqrt(c.root)
        const Integer divisor = t.divisor * c.root;
        c.numerator = c.numerator * divisor + t.sign * factor * c.denominator;
        c.denominator *= divisor;
        return;
      }
    }
    classes.push_back({t.root, t.sign, t.divisor});
  }

  std::vector<Term> terms_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SQUARE_ROOT_SUM_H
