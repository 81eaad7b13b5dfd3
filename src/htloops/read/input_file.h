// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_INPUT_FILE_H
#define HTLOOPS_INPUT_FILE_H

#include <string>
#include <string_view>
#include <utility>

namespace htloops {

/// A file and its content, which is read once: what came through a pipe does not come again. So all
/// readers take one of these, and a name stands for the file that has it.
class Input_file
{
public:
  /// throws `Failure` if the file cannot be read.
  Input_file(std::string name);

  /// a file that is in memory already; its name says of which format it is.
  Input_file(std::string name, std::string content)
      : name_(std::move(name))
      , content_(std::move(content)) {}

  const std::string& name() const { return name_; }
  std::string_view content() const { return content_; }

private:
  std::string name_;
  std::string content_;
};

/// throws the `Failure` of a file whose content is wrong.
[[noreturn]] void fail_to_read(const std::string& file, const std::string& problem);

} // namespace htloops

#endif // HTLOOPS_INPUT_FILE_H
