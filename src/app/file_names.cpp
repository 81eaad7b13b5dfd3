// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "file_names.h"

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <cstdio>

namespace htloops {
namespace {

namespace utf = boost::locale::utf;

std::string escape(char kind, int digits, unsigned value) {
  char text[16];
  std::snprintf(text, sizeof text, "\\%c%0*X", kind, digits, value);
  return text;
}

bool is_control(utf::code_point c) {
  return c < 0x20 || (0x7F <= c && c <= 0x9F) || c == 0x200E || c == 0x200F ||
         (0x2028 <= c && c <= 0x202E) || (0x2066 <= c && c <= 0x2069) || c == 0xFEFF;
}

std::string escaped_control(utf::code_point c) {
  switch(c) {
  case '\t':
    return "\\t";
  case '\n':
    return "\\n";
  case '\r':
    return "\\r";
  default:
    return c < 0x80 ? escape('x', 2, c) : escape('u', 4, c);
  }
}

// Characters stay or are escaped as `is_to_escape` says; bytes that are none are escaped.
template <typename Is_to_escape>
std::string escaped(std::string_view text, Is_to_escape is_to_escape) {
  std::string result;
  for(auto at = text.begin(); at != text.end();) {
    const auto begin = at;
    const utf::code_point c = utf::utf_traits<char>::decode(at, text.end());
    if(c == utf::illegal || c == utf::incomplete) {
      at = begin + 1;
      result += escape('x', 2, static_cast<unsigned char>(*begin));
    } else if(is_to_escape(c))
      result += escaped_control(c);
    else
      result.append(begin, at);
  }
  return result;
}

} // namespace

std::string as_utf8(std::string_view name) {
  return escaped(name, [](utf::code_point) { return false; });
}

std::string printable(std::string_view name) { return escaped(name, is_control); }

std::size_t number_of_characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](unsigned char byte) { return (byte & 0xC0) != 0x80; }));
}

std::string printable_lines(std::string_view message) {
  return escaped(message, [](utf::code_point c) { return c != '\n' && is_control(c); });
}

} // namespace htloops
