// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_TEXT_CURSOR_H
#define HTLOOPS_TEXT_CURSOR_H

#include <cstddef>
#include <string_view>

namespace htloops {

/// A place in a text of lines of numbers and words, where # begins a comment. Lines
/// end as on any system: with a line feed, a carriage return, or both. A byte order mark
/// before the text is passed over, and the Ctrl-Z that ends texts of DOS.
class Text_cursor
{
public:
  explicit Text_cursor(std::string_view text);

  /// moves to the next number or word, over line ends and comments; false at the end of the text.
  bool skip_to_content();

  /// moves to the beginning of the next line.
  void skip_line();

  /// reads the next number of this line; false, without moving, if there is none.
  bool read(double& value);
  bool read(long long& value);

  /// reads the next word of this line; empty if there is none.
  std::string_view word();

  /// whether nothing is left of this line, but for a comment.
  bool is_at_line_end();

  /// the number of bytes before this place.
  std::size_t position() const { return static_cast<std::size_t>(at_ - begin_); }

  /// the number of the current line, from 1.
  std::size_t line() const;

private:
  void skip_blanks();
  std::string_view next_word() const;

  const char* begin_;
  const char* at_;
  const char* end_;
};

} // namespace htloops

#endif // HTLOOPS_TEXT_CURSOR_H
