// Rational numbers as the nearest ones of the machine, by integers that GMP has no part in.

#include <CGAL/Handle_tunnel_loops/internal/support/rounded_rational.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace test_rounded_rational {

using Integer = boost::multiprecision::cpp_int;

// What is computed with these integers is none until it is one.
double quotient(const Integer& numerator, const Integer& denominator) {
  return CGAL::Handle_tunnel_loops::internal::rounded_quotient(numerator, denominator);
}

TEST(Rounded_rational, IsExactForNumbersOfTheMachine) {
  EXPECT_EQ(quotient(Integer(0), Integer(7)), 0.);
  EXPECT_EQ(quotient(Integer(-6), Integer(4)), -1.5);
  EXPECT_EQ(quotient(Integer(6), Integer(-4)), -1.5);
  EXPECT_EQ(quotient(Integer(-6), Integer(-4)), 1.5);
  std::mt19937_64 random(3);
  for(int i = 0; i < 1000; ++i) {
    const long long a = static_cast<long long>(random() >> 11) - (1ll << 52),
                    b = static_cast<long long>(random() >> 11) + 1;
    EXPECT_EQ(quotient(Integer(a), Integer(b)), double(a) / double(b)) << a << ' ' << b;
  }
}

TEST(Rounded_rational, IsThatOfIntegersThatAreNoNumbersOfTheMachine) {
  const Integer large = Integer(1) << 5000;
  EXPECT_EQ(quotient(3 * large, 4 * large), 0.75);
  EXPECT_EQ(quotient(large + 1, large), 1.);
  EXPECT_EQ(quotient(large, Integer(1) << 4900), 0x1p100);
  EXPECT_EQ(quotient(Integer(1) << 4900, large), 0x1p-100);
}

TEST(Rounded_rational, IsTheNearest) {
  const Integer one = Integer(1) << 2000, half_place = Integer(1) << (2000 - 53);
  EXPECT_EQ(quotient(one + half_place, one), 1.); // to even
  EXPECT_EQ(quotient(one + half_place + 1, one), 1. + 0x1p-52);
  EXPECT_EQ(quotient(one + 3 * half_place, one), 1. + 0x2p-52);
  EXPECT_EQ(quotient(one + 3 * half_place - 1, one), 1. + 0x1p-52);
}

TEST(Rounded_rational, IsTheNearestWhateverRationalNumbersAreMadeOf) {
  using CGAL::Exact_rational;
  const auto rounded = [](const Exact_rational& number) {
    return CGAL::Handle_tunnel_loops::internal::rounded(number);
  };
  std::mt19937_64 random(5);
  const auto some = [&random] {
    return std::ldexp(double(random() >> 11) - 0x1p52, int(random() % 200) - 100);
  };
  for(int i = 0; i < 1000; ++i) {
    const double a = some(), b = some();
    ASSERT_NE(b, 0.);
    EXPECT_EQ(rounded(Exact_rational(a) / Exact_rational(b)), a / b) << a << ' ' << b;
    EXPECT_EQ(rounded(Exact_rational(a) + Exact_rational(b)), a + b) << a << ' ' << b;
  }
  EXPECT_EQ(rounded(Exact_rational(1.) + Exact_rational(0x1p-53)), 1.); // to even
  EXPECT_EQ(rounded(Exact_rational(-1.) - Exact_rational(0x3p-53)), -1. - 0x2p-52);
  EXPECT_EQ(rounded(Exact_rational(0.)), 0.);
}

} // namespace test_rounded_rational
