// Sines and the like: as near to those of the C library as matters, and with the same bits
// everywhere.

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace test_elementary_functions {

namespace internal = CGAL::Handle_tunnel_loops::internal;

// The numbers of this generator are those of the standard; uniform distributions are not.
class Numbers
{
public:
  double between(double least, double most) {
    return least + internal::rounded_product(most - least, double(random_() >> 11) * 0x1p-53);
  }
  double of_any_size() {
    const int exponent = int(random_() % 200) - 100;
    return std::ldexp(between(0.5, 1.), exponent);
  }

private:
  std::mt19937_64 random_{7};
};

// In units of the last place of the one that is right.
double error(double found, double right) {
  if(found == right)
    return 0.;
  int exponent;
  std::frexp(right, &exponent);
  return std::abs(found - right) / std::ldexp(1., exponent - 53);
}

constexpr int number_of_cases = 20000;
constexpr double small_error = 5.;

TEST(Elementary_functions, OfAnglesAreNearTheTruth) {
  Numbers numbers;
  for(int i = 0; i < number_of_cases; ++i) {
    const double size = i % 3 == 0   ? 1.
                        : i % 3 == 1 ? 100.
                                     : 1e6,
                 angle = numbers.between(-size, size);
    EXPECT_LT(error(internal::sine(angle), std::sin(angle)), small_error) << angle;
    EXPECT_LT(error(internal::cosine(angle), std::cos(angle)), small_error) << angle;
    const double x = numbers.between(-1., 1.), scale = numbers.of_any_size(),
                 y = numbers.between(-1., 1.) * scale;
    EXPECT_LT(error(internal::arc_tangent(x, y), std::atan2(x, y)), small_error) << x << ' ' << y;
    EXPECT_LT(error(internal::arc_tangent(y, x), std::atan2(y, x)), small_error) << y << ' ' << x;
    EXPECT_LT(error(internal::arc_sine(x), std::asin(x)), small_error) << x;
    EXPECT_LT(error(internal::arc_cosine(x), std::acos(x)), small_error) << x;
  }
}

TEST(Elementary_functions, OfSizesAreNearTheTruth) {
  Numbers numbers;
  for(int i = 0; i < number_of_cases; ++i) {
    const double x = i % 2 == 0 ? numbers.of_any_size() : numbers.between(0.9, 1.1);
    EXPECT_LT(error(internal::logarithm(x), std::log(x)), small_error) << x;
    EXPECT_EQ(internal::half_octave(x), int(std::floor(2. * std::log2(x)))) << x;
    const double e = i % 2 == 0 ? numbers.between(-700., 700.) : numbers.between(-1., 1.);
    EXPECT_LT(error(internal::exponential(e), std::exp(e)), small_error) << e;
    EXPECT_NEAR(internal::power(x, 0.7) / std::pow(x, 0.7), 1., 1e-13) << x;
    EXPECT_NEAR(internal::integer_power(1.01, i % 300) / std::pow(1.01, i % 300), 1., 1e-13);
  }
}

TEST(Elementary_functions, AreExactWhereTheyCanBe) {
  EXPECT_EQ(internal::sine(0.), 0.);
  EXPECT_EQ(internal::cosine(0.), 1.);
  EXPECT_EQ(internal::cosine(CGAL_PI), -1.);
  EXPECT_EQ(internal::sine(CGAL_PI / 2.), 1.);
  EXPECT_EQ(internal::arc_tangent(0., 1.), 0.);
  EXPECT_EQ(internal::arc_tangent(0., -1.), CGAL_PI);
  EXPECT_EQ(internal::arc_tangent(-1., 0.), -CGAL_PI / 2.);
  EXPECT_EQ(internal::arc_tangent(1., 1.), CGAL_PI / 4.);
  EXPECT_EQ(internal::arc_tangent(0., 0.), 0.);
  EXPECT_EQ(internal::arc_sine(1.), CGAL_PI / 2.);
  EXPECT_EQ(internal::arc_cosine(-1.), CGAL_PI);
  EXPECT_EQ(internal::logarithm(1.), 0.);
  EXPECT_EQ(internal::exponential(0.), 1.);
  EXPECT_EQ(internal::exponential(1000.), std::numeric_limits<double>::infinity());
  EXPECT_EQ(internal::exponential(-1000.), 0.);
  EXPECT_EQ(internal::half_octave(1.), 0);
  EXPECT_EQ(internal::half_octave(0.25), -4);
  EXPECT_EQ(internal::half_octave(3.), 3);
  EXPECT_EQ(internal::integer_power(3., 0), 1.);
  EXPECT_EQ(internal::integer_power(3., 5), 243.);
}

TEST(Elementary_functions, HaveTheSameBitsEverywhere) {
  Numbers numbers;
  std::uint64_t sum = 0;
  const auto add = [&sum](double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    sum = (sum ^ bits) * 1099511628211u;
  };
  for(int i = 0; i < number_of_cases; ++i) {
    const double x = numbers.between(-50., 50.), y = numbers.between(-1., 1.),
                 z = numbers.of_any_size();
    for(const double value :
        {internal::sine(x), internal::cosine(x), internal::arc_tangent(x, y), internal::arc_sine(y),
         internal::arc_cosine(y), internal::logarithm(z), internal::exponential(x),
         internal::power(z, y), internal::integer_power(y, i % 20)})
      add(value);
  }
  EXPECT_EQ(sum, 17953424234727909811u);
}

TEST(Length_of_any, IsThatOfVectorsOfAnySize) {
  EXPECT_EQ(internal::rounded_length_of_any(3., -4., 0.), 5.);
  EXPECT_EQ(internal::rounded_length_of_any(0., 0., 0.), 0.);
  EXPECT_EQ(internal::rounded_length_of_any(0x3p800, 0x4p800, 0.), 0x5p800);
  EXPECT_EQ(internal::rounded_length_of_any(0x3p-1070, 0., -0x4p-1070), 0x5p-1070);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(internal::rounded_length_of_any(1., -infinity, 0.), infinity);
  Numbers numbers;
  for(int i = 0; i < 1000; ++i) {
    const double x = numbers.between(-1., 1.), y = numbers.between(-1., 1.),
                 z = numbers.between(-1., 1.);
    EXPECT_EQ(internal::rounded_length_of_any(x, y, z), internal::rounded_length(x, y, z));
  }
}

} // namespace test_elementary_functions
