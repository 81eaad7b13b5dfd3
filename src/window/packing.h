// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_PACKING_H
#define HTL_WINDOW_PACKING_H

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace htl_window {

/// What stands around a stream of RFC 1951: nothing, which browsers read as "deflate-raw"; what
/// zlib has (RFC 1950); or what gzip has (RFC 1952).
enum class Frame { NONE, ZLIB, GZIP };

/// packed bytes. Fast rather than small: what is coded here has often been made of small numbers
/// already, which are short words.
std::string deflated(std::string_view bytes, Frame frame = Frame::NONE);

/// the bytes of streams in a frame, one after the other; none if they are broken or cut off. Of
/// zlib and gzip it is the one that they have. Takes memory as there are bytes, whatever the
/// streams announce; `watch(size)` is told again and again how many there are, and may throw.
std::optional<std::string> inflated(std::string_view bytes,
                                    Frame frame = Frame::ZLIB,
                                    const std::function<void(std::size_t)>& watch = {});

} // namespace htl_window

#endif // HTL_WINDOW_PACKING_H
