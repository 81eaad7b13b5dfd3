// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_WORDS_H
#define HTLOOPS_WORDS_H

#include <array>
#include <cstddef>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

namespace htloops {

/// a line of a table, or a part of one, as `std::snprintf()` writes it.
template <typename... Values> std::string formatted(const char* format, Values... values) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// a number with its noun: "1 edge", "3 edges".
inline std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// a number with as many digits as tell it from all others.
inline std::string in_words(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for(std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

/// that a file is about another mesh, by numbers of vertices and faces.
inline std::string mesh_difference(const std::array<std::size_t, 2>& expected,
                                   const std::array<std::size_t, 2>& found) {
  return "it belongs to a mesh with " + std::to_string(expected[0]) + " vertices and " +
         std::to_string(expected[1]) + " faces, but this mesh has " + std::to_string(found[0]) +
         " and " + std::to_string(found[1]);
}

} // namespace htloops

#endif // HTLOOPS_WORDS_H
