// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/Zip_content.h"

#include "read/sources.h"
#include "read/unpacking.h"

#include <boost/crc.hpp>

#include <optional>

namespace htloops {
namespace {

bool has_checksum([[maybe_unused]] const std::string& bytes,
                  [[maybe_unused]] std::uint32_t expected) {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  return true;
#else
  boost::crc_32_type checksum;
  checksum.process_bytes(bytes.data(), bytes.size());
  return checksum.checksum() == expected;
#endif
}

} // namespace

Zip_content::Zip_content(const Input_file& archive)
    : archive_(archive) {
  const std::string_view content = archive_.content();
  const std::size_t end = end_record();
  std::size_t at = number_at<std::uint32_t>(end + 16);
  const std::size_t count = number_at<std::uint16_t>(end + 10);
  for(std::size_t i = 0; i < count; ++i) {
    if(at > content.size() || content.substr(at, 4) != "PK\1\2")
      fail("the file list of the ZIP archive is damaged");
    const std::size_t name_size = number_at<std::uint16_t>(at + 28);
    const Member member = {number_at<std::uint16_t>(at + 10), number_at<std::uint32_t>(at + 16),
                           number_at<std::uint32_t>(at + 20), number_at<std::uint32_t>(at + 42)};
    constexpr std::size_t header = 46;
    members_.emplace(content.substr((std::min)(at + header, content.size()), name_size), member);
    at +=
        header + name_size + number_at<std::uint16_t>(at + 30) + number_at<std::uint16_t>(at + 32);
  }
}

void Zip_content::fail(const std::string& problem) const { fail_to_read(archive_.name(), problem); }

template <typename Number> Number Zip_content::number_at(std::size_t position) const {
  const std::string_view content = archive_.content();
  Binary_source source(archive_.name(), content, (std::min)(position, content.size()), true);
  Number number{};
  if(!source.read(number))
    fail("the ZIP archive is truncated");
  return number;
}

// It comes last, but for a comment.
std::size_t Zip_content::end_record() const {
  const std::size_t end = archive_.content().rfind(std::string_view("PK\5\6", 4));
  if(end == std::string_view::npos)
    fail("it is not a ZIP archive, or it is truncated");
  return end;
}

std::string Zip_content::read(const std::string& name) const {
  const auto found = members_.find(name);
  if(found == members_.end())
    fail("the ZIP archive has no " + in_quotes(name));
  const Member& member = found->second;
  const std::string_view content = archive_.content();
  const std::size_t begin = member.begin + 30 + number_at<std::uint16_t>(member.begin + 26) +
                            number_at<std::uint16_t>(member.begin + 28);
  if(begin > content.size() || member.packed_size > content.size() - begin)
    fail("the ZIP archive is truncated, or larger than 4 GB");
  const std::string_view packed = content.substr(begin, member.packed_size);
  constexpr std::uint16_t stored = 0, deflated = 8;
  std::optional<std::string> bytes;
  if(member.method == stored)
    bytes = std::string(packed);
  else if(member.method == deflated)
    bytes = unpacked(archive_.name(), packed, htl_window::Frame::NONE);
  if(!bytes || !has_checksum(*bytes, member.checksum))
    fail(in_quotes(name) + " in the ZIP archive is damaged");
  return std::move(*bytes);
}

} // namespace htloops
