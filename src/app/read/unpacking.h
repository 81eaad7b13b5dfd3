// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_UNPACKING_H
#define HTLOOPS_UNPACKING_H

#include "window/packing.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace htloops {

/// How many bytes may be made of few: a quarter of the memory that the program can have. The
/// content of a file, the soup, and the mesh are in memory together, and each is about as large as
/// the others; so what has no room here could not become a mesh, and the machine would stand still
/// before it is known. How well something was packed says less: deflate makes a thousand bytes of
/// one wherever all are equal, of honest zeros, too.
std::size_t most_bytes_of_few();

/// throws the `Failure` of a file of which more bytes than that would be made.
void check_room(const std::string& file, std::size_t bytes);

/// the bytes of streams of deflate, as `htl_window::inflated`, which follow on so many that were
/// unpacked before. Throws the same, and `Interrupted` on Ctrl-C.
std::optional<std::string> unpacked(const std::string& file,
                                    std::string_view bytes,
                                    htl_window::Frame frame = htl_window::Frame::ZLIB,
                                    std::size_t bytes_before = 0);

} // namespace htloops

#endif // HTLOOPS_UNPACKING_H
