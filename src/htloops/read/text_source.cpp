// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/text_source.h"

#include "read/input_file.h"

namespace htloops {

std::string in_quotes(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text(word.substr(0, longest));
  for(char& c : text)
    if(c < ' ' || c > '~')
      c = '?';
  return "'" + text + (word.size() > longest ? "..." : "") + "'";
}

Text_source::Text_source(const std::string& file, std::string_view text)
    : Text_cursor(text)
    , file_(&file) {}

void Text_source::skip_numbers() {
  for(double number; !is_at_line_end();)
    if(!read(number))
      fail(in_quotes(word()) + " is no number");
  skip_line();
}

void Text_source::expect_end(const std::string& last) {
  if(skip_to_content())
    fail(in_quotes(word()) + " follows " + last);
}

void Text_source::fail(const std::string& problem) const {
  fail_to_read(*file_ + ":" + std::to_string(line()), problem);
}

void Text_source::fail_incomplete(const std::string& problem) const {
  Text_source rest = *this;
  rest.skip_line();
  fail(problem + (rest.skip_to_content() ? "" : "; the file ends here"));
}

} // namespace htloops
