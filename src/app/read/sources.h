// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SOURCES_H
#define HTLOOPS_SOURCES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace htloops {

/// A place in a text of lines of numbers and words, where # begins a comment. Lines
/// end as on any system: with a line feed, a carriage return, or both. A byte order mark
/// before the text is passed over, and the Ctrl-Z that ends texts of DOS.
class Text_source
{
public:
  Text_source(std::string_view file, std::string_view text);

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

  /// passes over the rest of this line, where nothing but numbers may be left: colours, normals.
  void skip_numbers();

  /// goes to the end of the text, before which there may be nothing but comments; fails otherwise,
  /// saying what it follows on.
  void expect_end(const std::string& last);

  /// throws the `Failure` of a text that is wrong here, which names the file and the line.
  [[noreturn]] void fail(const std::string& problem) const;

  /// the same for what may be missing because the file was cut off.
  [[noreturn]] void fail_incomplete(const std::string& problem) const;

  /// the number of bytes before this place.
  std::size_t position() const { return static_cast<std::size_t>(at_ - begin_); }

  /// goes to the place before which there are so many bytes, or to the end if that comes before.
  void go_to(std::size_t position) {
    at_ = begin_ + (std::min)(position, static_cast<std::size_t>(end_ - begin_));
  }

  /// the number of the current line, from 1.
  std::size_t line() const;

private:
  void skip_blanks();
  std::string_view next_word() const;

  std::string_view file_;
  const char* begin_;
  const char* at_ = begin_;
  const char* end_;
};

/// a word of a file for a message: without what a terminal would obey, and not too long.
std::string in_quotes(std::string_view word);

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

/// reads the next number, of a type of its own; false, without moving, if the content ends before.
template <typename T> bool read_as(Binary_source& data, double& value) {
  T number;
  if(!data.read(number))
    return false;
  value = static_cast<double>(number);
  return true;
}

using Read_number = bool (*)(Binary_source&, double&);

/// the numbers of a content that are of one type; throws `Failure` if there is no room for them.
std::vector<double> numbers_of_bytes(const std::string& file,
                                     const std::string& content,
                                     bool is_little_endian,
                                     Read_number read);

} // namespace htloops

#endif // HTLOOPS_SOURCES_H
