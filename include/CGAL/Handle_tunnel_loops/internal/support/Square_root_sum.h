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

#include <cstdint>
#include <sstream>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the largest integer whose square is not larger than \p n: by Newton's method with as many digits
/// as are right by then, so that the last of few divisions takes nearly all of the time.
inline boost::multiprecision::cpp_int integer_square_root(const boost::multiprecision::cpp_int& n) {
  CGAL_precondition(n >= 0);
  if(n == 0)
    return n;
  const unsigned c = static_cast<unsigned>(boost::multiprecision::msb(n)) / 2;
  boost::multiprecision::cpp_int root = 1;
  unsigned steps = 0;
  while(c >> steps != 0)
    ++steps;
  for(unsigned digits = 0; steps-- > 0;) {
    const unsigned before = std::exchange(digits, c >> steps);
    // `root` is the root of the leading digits of n, or one more.
    root = (root << (digits - before - 1)) + (n >> (2 * c - before - digits + 1)) / root;
  }
  return root * root > n ? root - 1 : root;
}

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

  // For which of some primes a number is a quadratic residue: the product of two numbers is no
  // square if these differ for a prime that divides neither.
  struct Residues
  {
    std::uint64_t are_residues = 0, are_divisors = 0;

    explicit Residues(const Integer& number) {
      std::uint64_t bit = 1;
      for(unsigned prime = 3; bit != 0; prime += 2)
        if(is_prime(prime)) {
          const unsigned rest = static_cast<unsigned>(number % prime);
          are_residues |= is_residue(rest, prime) ? bit : 0;
          are_divisors |= rest == 0 ? bit : 0;
          bit <<= 1;
        }
    }

    bool allow_square(const Residues& other) const {
      return ((are_residues ^ other.are_residues) & ~(are_divisors | other.are_divisors)) == 0;
    }
  };

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
    Residues residues;
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
      sum += t.sign * Integer(integer_square_root(Integer(t.root << (2 * digits))) / t.divisor);
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
    const Residues residues(t.root);
    for(Class_sum& c : classes) {
      if(!residues.allow_square(c.residues))
        continue;
      const Integer product = t.root * c.root, factor = integer_square_root(product);
      if(factor * factor == product) {
        // sqrt(t.root) = (factor / c.root) sqrt(c.root)
        const Integer divisor = t.divisor * c.root;
        c.numerator = c.numerator * divisor + t.sign * factor * c.denominator;
        c.denominator *= divisor;
        return;
      }
    }
    classes.push_back({t.root, t.sign, t.divisor, residues});
  }

  static bool is_prime(unsigned n) {
    for(unsigned d = 3; d * d <= n; d += 2)
      if(n % d == 0)
        return false;
    return true;
  }

  static bool is_residue(unsigned rest, unsigned prime) {
    for(unsigned x = 1; 2 * x < prime; ++x)
      if(x * x % prime == rest)
        return true;
    return false;
  }

  std::vector<Term> terms_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_SQUARE_ROOT_SUM_H
