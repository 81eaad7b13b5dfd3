// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_TEXT_WRITER_H
#define HTLOOPS_TEXT_WRITER_H

#include "write/atomic_file.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

namespace htloops {

/// appends the shortest decimal number that reads back as exactly `value`.
void append_number(std::string& text, double value);

/// A text file written through a buffer; it appears under its name when `finish()` is called.
/// Throws `Failure` when the file cannot be written and `Interrupted` on Ctrl-C.
class Text_writer
{
public:
  explicit Text_writer(const std::string& target)
      : file_(target) {}

  Text_writer& operator<<(std::string_view text) {
    buffer_ += text;
    return flush_if_full();
  }

  Text_writer& operator<<(const char* text) { return *this << std::string_view(text); }

  Text_writer& operator<<(char c) {
    buffer_ += c;
    return *this;
  }

  Text_writer& operator<<(double value) {
    append_number(buffer_, value);
    return flush_if_full();
  }

  template <typename Integer>
  std::enable_if_t<std::is_integral_v<Integer>, Text_writer&> operator<<(Integer value) {
    buffer_ += std::to_string(value);
    return flush_if_full();
  }

  void finish();

  /// makes what has been written visible now, where there is a name for it already: on the standard
  /// output.
  void show();

private:
  static constexpr std::size_t buffer_size = std::size_t(1) << 18;

  Text_writer& flush_if_full() {
    if(buffer_.size() >= buffer_size)
      flush();
    return *this;
  }

  void flush();

  Atomic_file file_;
  std::string buffer_;
};

} // namespace htloops

#endif // HTLOOPS_TEXT_WRITER_H
