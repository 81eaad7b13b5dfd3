// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/binary_source.h"

#include "read/input_file.h"

#include <cstdint>

namespace htloops {
namespace {

bool is_little_endian_here() {
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

} // namespace

Binary_source::Binary_source(const std::string& file,
                             std::string_view content,
                             std::size_t position,
                             bool is_little_endian)
    : file_(&file)
    , content_(content)
    , position_(position)
    , is_swapped_(is_little_endian != is_little_endian_here()) {}

void Binary_source::fail(const std::string& problem) const {
  fail_to_read(*file_, "byte " + std::to_string(position_) + ": " + problem);
}

} // namespace htloops
