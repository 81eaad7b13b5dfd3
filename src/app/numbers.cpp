// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "numbers.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#ifdef HTLOOPS_HAS_DOUBLE_CONVERSION
#include <double-conversion/double-conversion.h>
#endif

namespace htloops {
namespace {

// Knows every form of a number, and what is too large or too small for one. A hexadecimal number,
// of which none of the formats knows, is nearly always something else.
bool parse_slowly(std::string_view word, double& value) {
  if(word.find_first_of("xX") != word.npos)
    return false;
  const std::string copy(word);
  char* end = nullptr;
  value = std::strtod(copy.c_str(), &end);
  return !copy.empty() && end == copy.c_str() + copy.size();
}

#ifdef HTLOOPS_HAS_DOUBLE_CONVERSION

// Where the standard library does not know numbers that are not whole.

bool parse_fast(std::string_view word, double& value) {
  static const double_conversion::StringToDoubleConverter converter(
      double_conversion::StringToDoubleConverter::NO_FLAGS, 0., 0., nullptr, nullptr);
  int length = 0;
  value = converter.StringToDouble(word.data(), static_cast<int>(word.size()), &length);
  return length == static_cast<int>(word.size()) && length > 0;
}

/// 0.digits * 10 ^ point.
struct Decimal
{
  std::string digits;
  int point;
};

Decimal shortest_decimal(double value) {
  using Converter = double_conversion::DoubleToStringConverter;
  char digits[Converter::kBase10MaximalLength + 1];
  bool is_negative = false;
  int length = 0, point = 0;
  Converter::DoubleToAscii(value, Converter::SHORTEST, 0, digits, sizeof digits, &is_negative,
                           &length, &point);
  return {{digits, static_cast<std::size_t>(length)}, point};
}

std::string scientific(const Decimal& d) {
  const int exponent = d.point - 1;
  std::string text = d.digits.substr(0, 1);
  if(d.digits.size() > 1)
    text += "." + d.digits.substr(1);
  text += exponent < 0 ? "e-" : "e+";
  const std::string power = std::to_string(std::abs(exponent));
  return text + (power.size() < 2 ? "0" : "") + power;
}

std::string fixed(const Decimal& d) {
  const int length = static_cast<int>(d.digits.size());
  if(d.point <= 0)
    return "0." + std::string(static_cast<std::size_t>(-d.point), '0') + d.digits;
  if(d.point >= length)
    return d.digits + std::string(static_cast<std::size_t>(d.point - length), '0');
  const std::size_t whole = static_cast<std::size_t>(d.point);
  return d.digits.substr(0, whole) + "." + d.digits.substr(whole);
}

// As std::to_chars() has it: without exponent unless that is longer. A large whole number is
// written with all its digits.
void append_shortest(std::string& text, double value) {
  const Decimal d = shortest_decimal(value);
  const std::string with_exponent = scientific(d), without = fixed(d);
  if(without.size() > with_exponent.size())
    text += with_exponent;
  else if(d.point > static_cast<int>(d.digits.size())) {
    char digits[32];
    text.append(digits, static_cast<std::size_t>(
                            std::snprintf(digits, sizeof digits, "%.0f", std::abs(value))));
  } else
    text += without;
}

#endif

} // namespace

bool parse_number(std::string_view word, double& value) {
#ifdef HTLOOPS_HAS_DOUBLE_CONVERSION
  if(parse_fast(word, value))
    return true;
#elif defined __cpp_lib_to_chars
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if(error == std::errc() && end == word.data() + word.size())
    return true;
#endif
  return parse_slowly(word, value);
}

void append_number(std::string& text, double value) {
#ifdef HTLOOPS_HAS_DOUBLE_CONVERSION
  if(std::signbit(value))
    text += "-";
  if(std::isfinite(value) && value != 0.)
    append_shortest(text, value);
  else
    text += std::isnan(value) ? "nan" : value == 0. ? "0" : "inf";
#elif defined __cpp_lib_to_chars
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
#else
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.17g", value);
  text += digits;
#endif
}

} // namespace htloops
