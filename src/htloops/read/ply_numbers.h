// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PLY_NUMBERS_H
#define HTLOOPS_PLY_NUMBERS_H

#include "read/binary_source.h"
#include "read/ply_header.h"
#include "read/text_source.h"

#include <string>
#include <string_view>

namespace htloops {

/// The data of a PLY file in text form: each element has a line.
class Ply_text_numbers
{
public:
  explicit Ply_text_numbers(const Text_source& data)
      : text_(data) {}

  void begin_element() { text_.skip_to_content(); }

  /// whether nothing is left of the element.
  bool end_element() { return text_.is_at_line_end(); }

  /// fails if there is more than all elements.
  void end() { text_.expect_end("the last of the elements that the header declares"); }

  /// reads the next number, which has a type; false if there is none.
  bool read(Ply_type type, double& value);

  /// throws the `Failure` of a file that is wrong here.
  [[noreturn]] void fail(const std::string& problem) const { text_.fail(problem); }

  /// the same for what may be missing because the file was cut off.
  [[noreturn]] void fail_incomplete(const std::string& problem) const {
    text_.fail_incomplete(problem);
  }

private:
  Text_source text_;
};

/// The data of a PLY file in binary form.
class Ply_binary_numbers
{
public:
  explicit Ply_binary_numbers(const Binary_source& data)
      : data_(data) {}

  void begin_element() {}
  bool end_element() { return true; }
  void end() {} // some programs fill up the last block
  bool read(Ply_type type, double& value);

  [[noreturn]] void fail(const std::string& problem) const { data_.fail(problem); }

  [[noreturn]] void fail_incomplete(const std::string& problem) const {
    data_.fail(problem + "; the file ends here");
  }

private:
  template <typename T> bool read_as(double& value);

  Binary_source data_;
};

/// calls `use(numbers)` with the numbers of the form that the header declares; the text of the file
/// has been read up to the data.
template <typename Use>
auto with_ply_numbers(const std::string& file,
                      std::string_view content,
                      const Text_source& data,
                      Ply_format format,
                      Use use) {
  if(format == Ply_format::ASCII)
    return use(Ply_text_numbers(data));
  return use(Ply_binary_numbers(
      Binary_source(file, content, data.position(), format == Ply_format::BINARY_LITTLE_ENDIAN)));
}

} // namespace htloops

#endif // HTLOOPS_PLY_NUMBERS_H
