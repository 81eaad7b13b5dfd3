// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_BASE64_H
#define HTL_WINDOW_BASE64_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// \file base64.h
/// Bytes as letters, digits, + and / (RFC 4648).

namespace htl_window {

constexpr std::string_view base64_digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

inline std::string base64_of(std::string_view bytes) {
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  const auto byte = [bytes](std::size_t i) {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : std::uint32_t(0);
  };
  char* out = text.data();
  for(std::size_t i = 0; i < bytes.size(); i += 3, out += 4) {
    const std::uint32_t triple = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    const std::size_t filled = (std::min)(bytes.size() - i, std::size_t(3)) + 1;
    for(std::size_t k = 0; k < filled; ++k)
      out[k] = base64_digits[triple >> (18 - 6 * k) & 63u];
  }
  return text;
}

/// the value of each character as a digit; 64 of those that are none.
constexpr std::array<unsigned char, 256> base64_values() {
  std::array<unsigned char, 256> values{};
  for(unsigned char& value : values)
    value = 64;
  for(std::size_t digit = 0; digit < base64_digits.size(); ++digit)
    values[static_cast<unsigned char>(base64_digits[digit])] = static_cast<unsigned char>(digit);
  return values;
}

/// the bytes of a text, of several ones after each other, too; what is none of these characters is
/// passed over.
inline std::string bytes_of_base64(std::string_view text) {
  static constexpr std::array<unsigned char, 256> values = base64_values();
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int number = 0; // of bits
  for(const char c : text) {
    if(c == '=') { // the end of a text: what is left of its last digit is 0
      bits = 0;
      number = 0;
    }
    const std::uint32_t digit = values[static_cast<unsigned char>(c)];
    if(digit == 64)
      continue;
    bits = bits << 6 | digit;
    number += 6;
    if(number >= 8) {
      number -= 8;
      bytes += static_cast<char>(bits >> number & 255u);
    }
  }
  return bytes;
}

} // namespace htl_window

#endif // HTL_WINDOW_BASE64_H
