// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/non_finite_points.h"

#include "failure.h"
#include "read/ply_header.h"
#include "read/text_cursor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace htloops {
namespace {

// The coordinates that follow in a line; false if they are not there, or are all finite.
bool is_non_finite(Text_cursor& cursor) {
  double x, y, z;
  return cursor.read(x) && cursor.read(y) && cursor.read(z) &&
         !(std::isfinite(x) && std::isfinite(y) && std::isfinite(z));
}

// In formats where a keyword begins the line of a vertex, or that of a corner of a face.
void check_lines(const Input_file& file,
                 const std::vector<std::string_view>& keywords,
                 bool has_number,
                 bool has_corners) {
  Text_cursor cursor(file.content());
  std::size_t count = 0;
  for(; cursor.skip_to_content(); cursor.skip_line()) {
    if(std::find(keywords.begin(), keywords.end(), cursor.word()) == keywords.end())
      continue;
    long long number;
    if(has_number && !cursor.read(number))
      return;
    if(is_non_finite(cursor))
      fail_with_non_finite(file, has_corners ? "face " + std::to_string(count / 3)
                                             : "vertex " + std::to_string(count));
    ++count;
  }
}

// Where the vertices come first, and have no lists.
void check_ply_text(const Input_file& file) {
  std::string_view text = file.content();
  const Ply_header header = read_ply_header(text);
  if(header.format != Ply_format::ASCII || header.elements.empty())
    return;
  const Ply_element& vertex = header.elements[0];
  text.remove_prefix(header.size);
  Text_cursor cursor(text);
  for(std::size_t v = 0; v < vertex.count; ++v)
    for(const Ply_property& property : vertex.properties) {
      double value;
      if(property.is_list() || !cursor.skip_to_content() || !cursor.read(value))
        return;
      const bool is_coordinate =
          property.name == "x" || property.name == "y" || property.name == "z";
      if(is_coordinate && !std::isfinite(value))
        fail_with_non_finite(file, "vertex " + std::to_string(v));
    }
}

} // namespace

void fail_with_non_finite(const Input_file& file, const std::string& element) {
  throw Failure(Exit_code::UNACCEPTABLE_MESH,
                file.name() + ": " + element +
                    " has a coordinate that is infinite or not a number");
}

void check_points_are_finite(const Input_file& file, const std::string& extension) {
  if(extension == "obj")
    check_lines(file, {"v"}, false, false);
  else if(extension == "stl")
    check_lines(file, {"vertex"}, false, true);
  else if(extension == "ts")
    check_lines(file, {"VRTX", "PVRTX"}, true, false);
  else if(extension == "ply")
    check_ply_text(file);
}

} // namespace htloops
