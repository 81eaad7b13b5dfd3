// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/patterns.h"

#include "system/files.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <system_error>

namespace htloops {
namespace {

// Whether a byte is one of those in brackets, which begin a pattern and are taken from it; where
// none end, the bracket is a byte itself.
bool fits_brackets(char byte, std::string_view& pattern) {
  const bool is_negative = pattern.size() > 1 && (pattern[1] == '!' || pattern[1] == '^');
  const std::size_t first = is_negative ? 2 : 1;
  const std::size_t end = pattern.find(']', first + 1); // one that is first is meant
  if(end == std::string_view::npos) {
    pattern.remove_prefix(1);
    return byte == '[';
  }
  bool is_in = false;
  for(std::size_t i = first; i < end; ++i)
    if(i + 2 < end && pattern[i + 1] == '-') {
      is_in = is_in || (pattern[i] <= byte && byte <= pattern[i + 2]);
      i += 2;
    } else
      is_in = is_in || pattern[i] == byte;
  pattern.remove_prefix(end + 1);
  return is_in != is_negative;
}

bool fits_byte(char byte, std::string_view& pattern) {
  if(pattern.front() == '[')
    return fits_brackets(byte, pattern);
  const char expected = pattern.front();
  pattern.remove_prefix(1);
  return expected == '?' || expected == byte;
}

// The names in a folder that fit a pattern without folders, as parts of paths.
std::vector<std::string> entries(const std::string& folder, const std::string& pattern) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  std::error_code error;
  for(fs::directory_iterator entry(path_of(folder.empty() ? "." : folder), error), end;
      !error && entry != end; entry.increment(error))
  {
    const std::string name = name_of_path(entry->path().filename());
    if((name.front() != '.' || pattern.front() == '.') && fits(name, pattern))
      names.push_back(folder + name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

} // namespace

bool is_pattern(const std::string& word) { return word.find_first_of("*?[") != std::string::npos; }

bool fits(std::string_view name, std::string_view pattern) {
  // Where the last "*" is, and what of the name comes behind what it stands for: that may be more.
  std::string_view behind_star, rest;
  bool has_star = false;
  for(;;) {
    if(!pattern.empty() && pattern.front() == '*') {
      pattern.remove_prefix(1);
      has_star = true;
      behind_star = pattern;
      rest = name;
    } else if(name.empty()) {
      return pattern.empty();
    } else {
      const char byte = name.front();
      name.remove_prefix(1);
      if(pattern.empty() || !fits_byte(byte, pattern)) {
        if(!has_star || rest.empty())
          return false;
        rest.remove_prefix(1);
        name = rest;
        pattern = behind_star;
      }
    }
  }
}

std::vector<std::string> names_fitting(const std::string& words) {
  const std::string pattern = name_of_path(path_of(words)); // on Windows with slashes
  std::vector<std::string> names = {""};                    // of what is before `begin`
  for(std::size_t begin = 0; begin < pattern.size() && !names.empty();) {
    const std::size_t end = (std::min)(pattern.find('/', begin), pattern.size());
    const std::size_t next = (std::min)(pattern.find_first_not_of('/', end), pattern.size());
    const std::string part = pattern.substr(begin, end - begin),
                      slashes = pattern.substr(end, next - end);
    std::vector<std::string> longer;
    for(const std::string& name : names) {
      const std::vector<std::string> found =
          is_pattern(part) ? entries(name, part) : std::vector<std::string>{name + part};
      for(const std::string& entry : found)
        if(std::error_code error;
           slashes.empty() ? std::filesystem::exists(path_of(entry), error)
                           : entry.empty() || std::filesystem::is_directory(path_of(entry), error))
          longer.push_back(entry + slashes);
    }
    names = std::move(longer);
    begin = next;
  }
  return names;
}

} // namespace htloops
