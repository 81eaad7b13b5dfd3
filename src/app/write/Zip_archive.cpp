// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/Zip_archive.h"

#include "failure.h"
#include "window/packing.h"
#include "write/bytes.h"

#include <boost/crc.hpp>

#include <limits>

namespace htloops {
namespace {

constexpr std::uint16_t zip_version = 20, deflate = 8, first_day = 33;

std::uint32_t checksum(std::string_view content) {
  boost::crc_32_type crc;
  crc.process_bytes(content.data(), content.size());
  return crc.checksum();
}

std::uint32_t word(std::size_t size) {
  if(size > (std::numeric_limits<std::uint32_t>::max)())
    throw wrong_usage("the mesh is too large for a ZIP archive of 4 GB");
  return static_cast<std::uint32_t>(size);
}

template <typename... Numbers> std::string bytes_of(Numbers... numbers) {
  std::string bytes;
  (append_bytes(bytes, numbers), ...);
  return bytes;
}

} // namespace

void Zip_archive::add(const std::string& name, std::string_view content) {
  constexpr std::uint16_t none = 0;
  const std::string packed = htl_window::deflated(content);
  const std::string facts =
      bytes_of(zip_version, none, deflate, none, first_day, checksum(content), word(packed.size()),
               word(content.size()), static_cast<std::uint16_t>(name.size()), none);
  const std::uint32_t begin = word(bytes_.size());
  bytes_ += "PK\3\4" + facts + name + packed;
  // No comment, on the first disk, with no attributes.
  list_ += "PK\1\2" + bytes_of(zip_version) + facts +
           bytes_of(none, none, none, std::uint32_t(0), begin) + name;
  ++number_of_files_;
}

std::string Zip_archive::finish() && {
  constexpr std::uint16_t none = 0;
  const std::uint32_t begin = word(bytes_.size());
  bytes_ += list_;
  bytes_ += "PK\5\6" + bytes_of(none, none, number_of_files_, number_of_files_, word(list_.size()),
                                begin, none);
  return std::move(bytes_);
}

} // namespace htloops
