// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_BYTES_H
#define HTLOOPS_BYTES_H

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

namespace htloops {

/// appends a number as its bytes, in an order.
template <boost::endian::order order = boost::endian::order::little, typename Number>
void append_bytes(std::string& text, Number number) {
  std::array<char, sizeof number> bytes;
  std::memcpy(bytes.data(), &number, sizeof number);
  if constexpr(order != boost::endian::order::native)
    std::reverse(bytes.begin(), bytes.end());
  text.append(bytes.data(), bytes.size());
}

} // namespace htloops

#endif // HTLOOPS_BYTES_H
