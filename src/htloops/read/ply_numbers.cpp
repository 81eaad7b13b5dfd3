// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/ply_numbers.h"

#include <cstdint>
#include <limits>

namespace htloops {

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

template <typename T> bool Ply_binary_numbers::read_as(double& value) {
  T number;
  if(!data_.read(number))
    return false;
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

} // namespace htloops
