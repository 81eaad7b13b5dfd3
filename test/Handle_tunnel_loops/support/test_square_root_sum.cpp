// Sums of square roots, and their exact signs.

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/support/Square_root_sum.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace test_square_root_sum {

using CGAL::Exact_rational;
using CGAL::Handle_tunnel_loops::generators::Random;
using CGAL::Handle_tunnel_loops::internal::integer_square_root;
using CGAL::Handle_tunnel_loops::internal::Square_root_sum;
using Integer = boost::multiprecision::cpp_int;

void expect_root(const Integer& n) {
  const Integer root = integer_square_root(n), next = root + 1;
  EXPECT_LE(root * root, n) << n;
  EXPECT_GT(next * next, n) << n;
}

TEST(Integer_square_root, IsTheLargestOne) {
  for(int n = 0; n < 5000; ++n)
    expect_root(n);
  Random random(1);
  for(int i = 0; i < 1000; ++i) {
    Integer n = 0;
    for(std::size_t word = 0; word <= random.below(30); ++word)
      n = (n << 64) + random.next();
    expect_root(n);
    for(int off : {-1, 0, 1})
      if(n > 0)
        expect_root(n * n + off);
  }
}

Square_root_sum sum_of(const std::vector<std::pair<int, Exact_rational>>& terms) {
  Square_root_sum sum;
  for(const auto& [sign, radicand] : terms)
    sum.add(sign, radicand);
  return sum;
}

TEST(Square_roots, AddUp) {
  EXPECT_EQ(sum_of({}).sign(), 0);
  EXPECT_EQ(sum_of({{1, 0}}).sign(), 0);
  EXPECT_EQ(sum_of({{1, 2}, {-1, 3}}).sign(), -1);
  EXPECT_EQ(sum_of({{1, 2}, {1, 8}, {-1, 18}}).sign(), 0);
  EXPECT_EQ(sum_of({{1, Exact_rational(1) / 3}, {1, 3}, {-1, Exact_rational(16) / 3}}).sign(), 0);
  // Known to be close: 10, 11 against 5, 18; and 0.4e-19 apart.
  EXPECT_EQ(sum_of({{1, 10}, {1, 11}, {-1, 5}, {-1, 18}}).sign(), 1);
}

TEST(Square_roots, AreToldApartHoweverClose) {
  Exact_rational tiny = 1;
  for(int i = 0; i < 400; ++i)
    tiny /= 10;
  const Exact_rational five = 5;
  EXPECT_EQ(sum_of({{1, five}, {-1, Exact_rational(five + tiny)}}).sign(), -1);
  EXPECT_EQ(sum_of({{1, 2}, {1, 8}, {-1, 18}, {1, Exact_rational(tiny * tiny)}}).sign(), 1);
  EXPECT_EQ(sum_of({{-1, Exact_rational(five + tiny)}, {1, Exact_rational(five + tiny)}}).sign(),
            0);
}

// Multiples of the roots of a few numbers, where the sums by class are known integers.
TEST(Square_roots, CancelInClasses) {
  Random random(12);
  for(int round = 0; round < 200; ++round) {
    const int roots[] = {1, 2, 3, 5, 6};
    std::vector<int> coefficients(5, 0);
    std::vector<std::pair<int, Exact_rational>> terms;
    for(int i = 0; i < 12; ++i) {
      const std::size_t c = random.below(5);
      const int factor = static_cast<int>(random.below(5)) - 2;
      coefficients[c] += factor;
      terms.emplace_back(factor < 0 ? -1 : 1, factor * factor * roots[c]);
    }
    // Half of the time all is taken back.
    if(round % 2 == 0)
      for(std::size_t c = 0; c < 5; ++c) {
        terms.emplace_back(coefficients[c] < 0 ? 1 : -1,
                           coefficients[c] * coefficients[c] * roots[c]);
        coefficients[c] = 0;
      }
    double value = 0.;
    for(std::size_t c = 0; c < 5; ++c)
      value += coefficients[c] * std::sqrt(roots[c]);
    const int sign = sum_of(terms).sign();
    const bool is_zero = std::count(coefficients.begin(), coefficients.end(), 0) == 5;
    EXPECT_EQ(sign == 0, is_zero);
    if(std::abs(value) > 1e-9) {
      EXPECT_EQ(sign, value > 0. ? 1 : -1);
    }
  }
}

} // namespace test_square_root_sum
