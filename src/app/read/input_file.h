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

#include "file_names.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace htloops {

/// A file and its content, which is read once: what came through a pipe does not come again. So all
/// readers take one of these, and a name stands for the file that has it. Copies share the content.
class Input_file
{
public:
  /// `-` is the standard input. Throws `Failure` if the file cannot be read. `format` is how the
  /// name of a file of its format ends, `off` say; empty if its own name tells. What gzip has
  /// packed is unpacked, and `.gz` is no part of how its name ends. Also throws if the file is
  /// empty.
  Input_file(std::string name, const std::string& format = "");

  /// a file that is in memory already; its name says of which format it is.
  static Input_file in_memory(std::string name, std::string content) {
    Input_file file;
    file.name_ = printable(name);
    file.path_ = std::move(name);
    file.set_content(std::move(content));
    return file;
  }

  /// as it can be printed.
  const std::string& name() const { return name_; }

  /// as it is called where it lies.
  const std::string& path() const { return path_; }

  /// whether it is of the format of files whose names end so, `.off` say.
  bool is_of_format(std::string_view extension) const;

  std::string_view content() const { return *content_; }

  /// forgets the content, which cannot be asked for any more. It takes twice the memory of the mesh
  /// in it.
  void close() { content_.reset(); }

private:
  Input_file() = default;

  void set_content(std::string content);

  std::string name_, path_;
  std::string format_; // with the dot; empty if the name tells
  std::shared_ptr<const std::string> content_;
};

/// throws the `Failure` of a file whose content is wrong.
[[noreturn]] void fail_to_read(const std::string& file, const std::string& problem);

} // namespace htloops

#endif // HTLOOPS_INPUT_FILE_H
