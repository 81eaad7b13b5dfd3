// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_GROWING_FILE_H
#define HTLOOPS_GROWING_FILE_H

#include "write/files.h"

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace htloops {

/// A file of lines that is to be read while it grows, and to be of use wherever it ends. What is
/// appended is there at once, under the name of the file, and as a whole; only when the first of it
/// comes, what the file had before is gone. The name "-" is the standard output. Throws as
/// `Text_writer` does.
class Growing_file
{
public:
  /// every file of its kind begins with `header`.
  explicit Growing_file(const std::string& target, std::string header = "");

  const std::string& target() const { return target_; }

  /// the lines that the file has already, after the header; the last may have been cut off. Nothing
  /// if there is no file. Throws `Failure` if it has another header.
  std::string old_lines() const;

  /// from now on more lines follow these, which the file has after its header.
  void go_on_after(const std::string& lines);

  /// `lines` are whole ones.
  void append(std::string_view lines);

private:
  std::FILE* stream();

  const std::string target_;
  const std::string header_;
  std::uintmax_t size_ = 0; // 0 if what there is now is to be replaced
  Open_file file_;
};

} // namespace htloops

#endif // HTLOOPS_GROWING_FILE_H
