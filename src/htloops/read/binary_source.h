// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_BINARY_SOURCE_H
#define HTLOOPS_BINARY_SOURCE_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

namespace htloops {

/// A place in the content of a binary mesh file, whose messages name the file and the byte.
class Binary_source
{
public:
  Binary_source(const std::string& file,
                std::string_view content,
                std::size_t position,
                bool is_little_endian);

  std::size_t bytes_left() const { return content_.size() - position_; }

  /// passes over at most that many bytes.
  void skip(std::size_t bytes) { position_ += (std::min)(bytes, bytes_left()); }

  /// reads the next number; false, without moving, if the content ends before.
  template <typename T> bool read(T& value) {
    if(bytes_left() < sizeof(T))
      return false;
    std::array<char, sizeof(T)> bytes;
    std::copy_n(content_.data() + position_, sizeof(T), bytes.begin());
    position_ += sizeof(T);
    if(is_swapped_)
      std::reverse(bytes.begin(), bytes.end());
    std::memcpy(&value, bytes.data(), sizeof(T));
    return true;
  }

  /// throws the `Failure` of a file that is wrong here.
  [[noreturn]] void fail(const std::string& problem) const;

private:
  const std::string* file_;
  std::string_view content_;
  std::size_t position_;
  bool is_swapped_;
};

} // namespace htloops

#endif // HTLOOPS_BINARY_SOURCE_H
