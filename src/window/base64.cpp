// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "base64.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace htl_window {

std::string base64_of(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  const auto byte = [bytes](std::size_t i) {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : std::uint32_t(0);
  };
  char* out = text.data();
  for(std::size_t i = 0; i < bytes.size(); i += 3, out += 4) {
    const std::uint32_t triple = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    const std::size_t filled = (std::min)(bytes.size() - i, std::size_t(3)) + 1;
    for(std::size_t k = 0; k < filled; ++k)
      out[k] = digits[triple >> (18 - 6 * k) & 63u];
  }
  return text;
}

} // namespace htl_window
