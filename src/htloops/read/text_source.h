// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_TEXT_SOURCE_H
#define HTLOOPS_TEXT_SOURCE_H

#include "read/text_cursor.h"

#include <string>
#include <string_view>

namespace htloops {

/// a word of a file for a message: without what a terminal would obey, and not too long.
std::string in_quotes(std::string_view word);

/// A place in the text of a mesh file, whose messages name the file and the line.
class Text_source : public Text_cursor
{
public:
  Text_source(const std::string& file, std::string_view text);

  /// passes over the rest of this line, where nothing but numbers may be left: colours, normals.
  void skip_numbers();

  /// goes to the end of the text, before which there may be nothing but comments; fails otherwise,
  /// saying what it follows on.
  void expect_end(const std::string& last);

  /// throws the `Failure` of a text that is wrong here.
  [[noreturn]] void fail(const std::string& problem) const;

  /// the same for what may be missing because the file was cut off.
  [[noreturn]] void fail_incomplete(const std::string& problem) const;

private:
  const std::string* file_;
};

} // namespace htloops

#endif // HTLOOPS_TEXT_SOURCE_H
