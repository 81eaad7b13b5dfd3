// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_STREAMS_H
#define HTL_WINDOW_STREAMS_H

#include "Grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace htl_window {

/// bytes as letters, digits, + and / (RFC 4648).
std::string base64_of(std::string_view bytes);

/// bytes as a stream of RFC 1951, which browsers read as "deflate-raw". Fast rather than small:
/// what is coded here has been made of small numbers already, which are short words.
std::string deflated(std::string_view bytes);

/// Numbers one after the other: seven bits in each byte, the least first; the eighth says that more
/// follow.
class Stream
{
public:
  void add(std::uint32_t value) {
    for(; value > 127; value >>= 7)
      bytes_ += static_cast<char>(value | 128);
    bytes_ += static_cast<char>(value);
  }

  /// the sign becomes the last bit.
  void add_signed(std::int32_t value) {
    add(value < 0 ? ~(static_cast<std::uint32_t>(value) << 1)
                  : static_cast<std::uint32_t>(value) << 1);
  }

  const std::string& bytes() const { return bytes_; }

private:
  std::string bytes_;
};

/// Places, each as its difference to one before, an axis in each stream.
using Place_streams = std::array<Stream, 3>;

inline void add_difference(Place_streams& streams, const Grid::Place& to, const Grid::Place& from) {
  for(int i = 0; i < 3; ++i)
    streams[i].add_signed(to[i] - from[i]);
}

/// Streams one after the other, deflated and in base 64, and how many bytes each has before that.
struct Packed
{
  std::string text;
  std::vector<std::size_t> lengths;
};

Packed packed(const std::vector<const Stream*>& streams);

} // namespace htl_window

#endif // HTL_WINDOW_STREAMS_H
