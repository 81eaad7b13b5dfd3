// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/ply_numbers.h"

#include "read/input_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

namespace htloops {
namespace {

bool is_little_endian_here() {
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

} // namespace

bool Ply_text_numbers::read(Ply_type type, double& value) {
  if(!is_integer(type))
    return text_.read(value);
  long long integer;
  if(!text_.read(integer) || integer < (std::numeric_limits<std::int32_t>::min)() ||
     integer > (std::numeric_limits<std::uint32_t>::max)())
    return false;
  value = static_cast<double>(integer);
  return true;
}

Ply_binary_numbers::Ply_binary_numbers(const std::string& file,
                                       std::string_view content,
                                       std::size_t position,
                                       Ply_format format)
    : file_(&file)
    , content_(content)
    , position_(position)
    , is_swapped_((format == Ply_format::BINARY_LITTLE_ENDIAN) != is_little_endian_here()) {}

template <typename T> bool Ply_binary_numbers::read_as(double& value) {
  if(content_.size() - position_ < sizeof(T))
    return false;
  std::array<char, sizeof(T)> bytes;
  std::copy_n(content_.data() + position_, sizeof(T), bytes.begin());
  position_ += sizeof(T);
  if(is_swapped_)
    std::reverse(bytes.begin(), bytes.end());
  T number;
  std::memcpy(&number, bytes.data(), sizeof(T));
  value = static_cast<double>(number);
  return true;
}

bool Ply_binary_numbers::read(Ply_type type, double& value) {
  switch(type) {
  case Ply_type::INT8:
    return read_as<std::int8_t>(value);
  case Ply_type::UINT8:
    return read_as<std::uint8_t>(value);
  case Ply_type::INT16:
    return read_as<std::int16_t>(value);
  case Ply_type::UINT16:
    return read_as<std::uint16_t>(value);
  case Ply_type::INT32:
    return read_as<std::int32_t>(value);
  case Ply_type::UINT32:
    return read_as<std::uint32_t>(value);
  case Ply_type::FLOAT:
    return read_as<float>(value);
  case Ply_type::DOUBLE:
    return read_as<double>(value);
  case Ply_type::NONE:
    break;
  }
  return false;
}

void Ply_binary_numbers::fail(const std::string& problem) const {
  fail_to_read(*file_, "byte " + std::to_string(position_) + ": " + problem);
}

void Ply_binary_numbers::fail_incomplete(const std::string& problem) const {
  fail(problem + "; the file ends here");
}

} // namespace htloops
