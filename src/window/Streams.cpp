// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Streams.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>

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

std::string deflated(std::string_view bytes) {
  constexpr int raw_window_bits = -15, memory_level = 9;
  z_stream stream{};
  if(deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, raw_window_bits, memory_level,
                  Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib cannot be used");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, deflateEnd);
  std::string result;
  constexpr std::size_t longest = (std::numeric_limits<uInt>::max)(), step = std::size_t(1) << 18;
  do {
    const std::string_view part = bytes.substr(0, longest);
    bytes.remove_prefix(part.size());
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
    stream.avail_in = static_cast<uInt>(part.size());
    do {
      const std::size_t size = result.size();
      result.resize(size + step);
      stream.next_out = reinterpret_cast<Bytef*>(&result[size]);
      stream.avail_out = step;
      deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
      result.resize(size + step - stream.avail_out);
    } while(stream.avail_out == 0);
  } while(!bytes.empty());
  return result;
}

Packed packed(const std::vector<const Stream*>& streams) {
  Packed result;
  std::string bytes;
  for(const Stream* stream : streams) {
    bytes += stream->bytes();
    result.lengths.push_back(stream->bytes().size());
  }
  result.text = base64_of(deflated(bytes));
  return result;
}

} // namespace htl_window
