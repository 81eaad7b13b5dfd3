#include "app/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>

namespace test_htloops_numbers {

using htloops::append_number;
using htloops::parse_number;

std::string text_of(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

TEST(Numbers, read_back_as_themselves) {
  std::mt19937_64 random(1);
  for(int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value = 0., read = 0.;
    std::memcpy(&value, &bits, sizeof value);
    if(!std::isfinite(value))
      continue;
    ASSERT_TRUE(parse_number(text_of(value), read)) << text_of(value);
    ASSERT_EQ(std::memcmp(&read, &value, sizeof value), 0) << text_of(value);
  }
}

// Whatever makes them: the standard library, or double-conversion in its place.
TEST(Numbers, have_one_form_on_all_machines) {
  EXPECT_EQ(text_of(0.), "0");
  EXPECT_EQ(text_of(-0.), "-0");
  EXPECT_EQ(text_of(0.1), "0.1");
  EXPECT_EQ(text_of(-1. / 3.), "-0.3333333333333333");
  EXPECT_EQ(text_of(100000.), "1e+05");
  EXPECT_EQ(text_of(123456.), "123456");
  EXPECT_EQ(text_of(0.0001), "1e-04");
  EXPECT_EQ(text_of(0.00001), "1e-05");
  EXPECT_EQ(text_of(0.000123), "0.000123");
  EXPECT_EQ(text_of(1e22), "1e+22");
  EXPECT_EQ(text_of(123456789012345678.), "123456789012345680");
  EXPECT_EQ(text_of(4.9e-324), "5e-324");
  EXPECT_EQ(text_of(1.7976931348623157e308), "1.7976931348623157e+308");
}

TEST(Numbers, of_words_that_are_none) {
  double value = 0.;
  for(const char* word : {"", "-", "x", "1x", "1 ", " 1 x", "0x10", "1,5", "--1", "1e"})
    EXPECT_FALSE(parse_number(word, value)) << '"' << word << '"';
}

TEST(Numbers, of_words_of_any_form) {
  double value = 0.;
  for(const char* word : {"1.5", "+1.5", "15e-1", "0.15E1", "1.50", "01.5"}) {
    EXPECT_TRUE(parse_number(word, value)) << word;
    EXPECT_EQ(value, 1.5) << word;
  }
  EXPECT_TRUE(parse_number("1e999", value) && std::isinf(value));
  EXPECT_TRUE(parse_number("1e-999", value) && value == 0.);
  EXPECT_TRUE(parse_number("nan", value) && std::isnan(value));
}

} // namespace test_htloops_numbers
