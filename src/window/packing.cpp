// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "window/packing.h"

#include <zlib.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>

namespace htl_window {
namespace {

using Stream_end = std::unique_ptr<z_stream, int (*)(z_stream*)>;

constexpr std::size_t longest = (std::numeric_limits<uInt>::max)(), step = std::size_t(1) << 18;

// As many of the bytes as zlib takes at a time.
void hand_over(z_stream& stream, std::string_view& bytes) {
  const std::string_view part = bytes.substr(0, longest);
  bytes.remove_prefix(part.size());
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
  stream.avail_in = static_cast<uInt>(part.size());
}

// Adds what a step of zlib makes; returns what that says.
template <typename Step> int add_step(z_stream& stream, std::string& result, Step run) {
  const std::size_t size = result.size();
  result.resize(size + step);
  stream.next_out = reinterpret_cast<Bytef*>(&result[size]);
  stream.avail_out = step;
  const int state = run();
  result.resize(size + step - stream.avail_out);
  return state;
}

int window_bits(Frame frame) {
  return frame == Frame::NONE ? -MAX_WBITS : frame == Frame::ZLIB ? MAX_WBITS : MAX_WBITS + 16;
}

} // namespace

std::string deflated(std::string_view bytes, Frame frame) {
  constexpr int memory_level = 9;
  z_stream stream{};
  if(deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, window_bits(frame), memory_level,
                  Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib cannot be used");
  const Stream_end end(&stream, deflateEnd);
  std::string result;
  do {
    hand_over(stream, bytes);
    do
      add_step(stream, result,
               [&] { return deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH); });
    while(stream.avail_out == 0);
  } while(!bytes.empty());
  return result;
}

std::optional<std::string>
inflated(std::string_view bytes, Frame frame, const std::function<void(std::size_t)>& watch) {
  constexpr int either_frame = MAX_WBITS + 32;
  z_stream stream{};
  if(inflateInit2(&stream, frame == Frame::NONE ? -MAX_WBITS : either_frame) != Z_OK)
    throw std::runtime_error("zlib cannot be used");
  const Stream_end end(&stream, inflateEnd);
  std::string result;
  int state = Z_OK;
  const auto add = [&] {
    state = add_step(stream, result, [&] { return inflate(&stream, Z_NO_FLUSH); });
    if(watch)
      watch(result.size());
  };
  while(stream.avail_in > 0 || !bytes.empty()) {
    if(stream.avail_in == 0)
      hand_over(stream, bytes);
    if(state == Z_STREAM_END) { // there is another one, or what fills up a block
      const std::string_view rest(reinterpret_cast<const char*>(stream.next_in), stream.avail_in);
      if(rest.find_first_not_of('\0') == rest.npos)
        break;
      inflateReset(&stream);
    }
    add();
    if(state != Z_OK && state != Z_STREAM_END)
      return std::nullopt;
  }
  while(state == Z_OK && stream.avail_out == 0) // what was handed over is not all out
    add();
  return state == Z_STREAM_END ? std::optional(std::move(result)) : std::nullopt;
}

} // namespace htl_window
