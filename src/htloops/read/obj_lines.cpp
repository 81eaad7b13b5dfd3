// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/obj_lines.h"

#include <algorithm>
#include <string_view>

namespace htloops {
namespace {

// takes the first line, without its end, off the text.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = (std::min)(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  const std::size_t length_of_end = text.substr(end, 2) == "\r\n" ? 2 : 1;
  text.remove_prefix((std::min)(end + length_of_end, text.size()));
  return line;
}

// A comment ends with its line, whatever stands there.
bool is_continued(std::string_view line) {
  return !line.empty() && line.back() == '\\' && line.find('#') == line.npos;
}

} // namespace

std::string join_continued_lines(std::string text) {
  if(text.find("\\\n") == text.npos && text.find("\\\r") == text.npos)
    return text;
  std::string joined;
  joined.reserve(text.size() + 1);
  std::size_t line_ends = 0;
  for(std::string_view rest = text; !rest.empty();) {
    const std::string_view line = take_line(rest);
    ++line_ends;
    if(is_continued(line)) {
      joined.append(line.substr(0, line.size() - 1)).append(" ");
    } else {
      joined.append(line).append(line_ends, '\n');
      line_ends = 0;
    }
  }
  return joined;
}

} // namespace htloops
