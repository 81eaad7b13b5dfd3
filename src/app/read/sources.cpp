// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/sources.h"

#include "interrupt.h"
#include "numbers.h"
#include "read/input_file.h"
#include "read/unpacking.h"

#include <boost/endian/conversion.hpp>

#include <charconv>
#include <system_error>

namespace htloops {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

bool ends_word(char c) { return is_blank(c) || is_line_end(c) || c == '#'; }

} // namespace

Text_source::Text_source(std::string_view file, std::string_view text)
    : file_(file)
    , begin_(text.data())
    , end_(text.data() + text.size()) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if(text.substr(0, byte_order_mark.size()) == byte_order_mark)
    at_ += byte_order_mark.size();
  constexpr char ctrl_z = '\x1A';
  if(!text.empty() && text.back() == ctrl_z)
    --end_;
}

void Text_source::skip_blanks() {
  while(at_ != end_ && is_blank(*at_))
    ++at_;
}

void Text_source::skip_line() {
  at_ = std::find_if(at_, end_, is_line_end);
  if(end_ - at_ > 1 && at_[0] == '\r' && at_[1] == '\n')
    ++at_;
  if(at_ != end_)
    ++at_;
}

bool Text_source::skip_to_content() {
  throw_if_interrupted();
  for(;;) {
    skip_blanks();
    if(at_ == end_)
      return false;
    if(!is_line_end(*at_) && *at_ != '#')
      return true;
    skip_line();
  }
}

std::string_view Text_source::next_word() const {
  const char* end = std::find_if(at_, end_, ends_word);
  return {at_, static_cast<std::size_t>(end - at_)};
}

bool Text_source::read(double& value) {
  skip_blanks();
  const std::string_view word = next_word();
  if(!parse_number(word, value))
    return false;
  at_ += word.size();
  return true;
}

bool Text_source::read(long long& value) {
  skip_blanks();
  const auto [end, error] = std::from_chars(at_, end_, value);
  if(error != std::errc() || (end != end_ && !ends_word(*end)))
    return false;
  at_ = end;
  return true;
}

std::string_view Text_source::word() {
  skip_blanks();
  const std::string_view word = next_word();
  at_ += word.size();
  return word;
}

bool Text_source::is_at_line_end() {
  skip_blanks();
  return at_ == end_ || is_line_end(*at_) || *at_ == '#';
}

std::size_t Text_source::line() const {
  std::size_t line = 1;
  for(const char* c = begin_; c != at_; ++c)
    if(*c == '\n' || (*c == '\r' && !(c + 1 != end_ && c[1] == '\n')))
      ++line;
  return line;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text(word.substr(0, longest));
  for(char& c : text)
    if(c < ' ' || c > '~')
      c = '?';
  return "'" + text + (word.size() > longest ? "..." : "") + "'";
}

void Text_source::skip_numbers() {
  for(double number; !is_at_line_end();)
    if(!read(number))
      fail(in_quotes(word()) + " is not a number");
  skip_line();
}

void Text_source::expect_end(const std::string& last) {
  if(skip_to_content())
    fail("unexpected " + in_quotes(word()) + " after " + last);
}

void Text_source::fail(const std::string& problem) const {
  fail_to_read(std::string(file_) + ":" + std::to_string(line()), problem);
}

void Text_source::fail_incomplete(const std::string& problem) const {
  Text_source rest = *this;
  rest.skip_line();
  fail(problem + (rest.skip_to_content() ? "" : "; the file ends here"));
}

Binary_source::Binary_source(const std::string& file,
                             std::string_view content,
                             std::size_t position,
                             bool is_little_endian)
    : file_(&file)
    , content_(content)
    , position_(position)
    , is_swapped_(is_little_endian !=
                  (boost::endian::order::native == boost::endian::order::little)) {}

void Binary_source::fail(const std::string& problem) const {
  fail_to_read(*file_, "byte " + std::to_string(position_) + ": " + problem);
}

std::vector<double> numbers_of_bytes(const std::string& file,
                                     const std::string& content,
                                     bool is_little_endian,
                                     Read_number read) {
  Binary_source source(file, content, 0, is_little_endian);
  std::vector<double> numbers;
  double x;
  if(!read(source, x))
    return numbers;
  const std::size_t count = content.size() / (content.size() - source.bytes_left());
  check_room(file, count * sizeof(double));
  throw_if_interrupted();
  numbers.reserve(count);
  do
    numbers.push_back(x);
  while(read(source, x));
  return numbers;
}

} // namespace htloops
