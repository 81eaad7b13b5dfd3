// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/unpacking.h"

#include "interrupt.h"
#include "read/input_file.h"
#include "system/memory.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>

namespace htloops {
namespace {

std::string in_megabytes(std::size_t bytes) { return std::to_string(bytes >> 20) + " MB"; }

} // namespace

std::size_t most_bytes_of_few() {
  const std::uint64_t most = (std::min)(memory_of_machine(), memory_allowed()) / 4;
  return static_cast<std::size_t>(
      (std::min)(most, std::uint64_t((std::numeric_limits<std::size_t>::max)())));
}

void check_room(const std::string& file, std::size_t bytes) {
  static const std::size_t most = most_bytes_of_few();
  if(bytes > most)
    fail_to_read(file, "its content would need more than " + in_megabytes(most) +
                           ", a quarter of the available memory");
}

std::optional<std::string> unpacked(const std::string& file,
                                    std::string_view bytes,
                                    htl_window::Frame frame,
                                    std::size_t bytes_before) {
  try {
    return htl_window::inflated(bytes, frame, [&](std::size_t size) {
      throw_if_interrupted();
      check_room(file, bytes_before + size);
    });
  } catch(const std::bad_alloc&) {
    fail_to_read(file, "not enough memory to decompress it");
  }
}

} // namespace htloops
