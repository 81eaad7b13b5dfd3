// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_ZIP_CONTENT_H
#define HTLOOPS_ZIP_CONTENT_H

#include "read/input_file.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace htloops {

/// The files in an archive of ZIP.
class Zip_content
{
public:
  /// Throws `Failure` if the file is none, or is cut off.
  explicit Zip_content(const Input_file& archive);

  bool has(const std::string& name) const { return members_.count(name) != 0; }

  /// the content of a member. Throws `Failure` if there is none of that name, or if it is broken.
  std::string read(const std::string& name) const;

private:
  struct Member
  {
    std::uint16_t method;
    std::uint32_t checksum;
    std::size_t packed_size, begin;
  };

  [[noreturn]] void fail(const std::string& problem) const;
  template <typename Number> Number number_at(std::size_t position) const;
  std::size_t end_record() const;

  const Input_file& archive_;
  std::map<std::string, Member> members_;
};

} // namespace htloops

#endif // HTLOOPS_ZIP_CONTENT_H
