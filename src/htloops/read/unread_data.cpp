// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/unread_data.h"

#include "read/obj_lines.h"
#include "read/off_header.h"
#include "read/ply_header.h"
#include "read/text_cursor.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace htloops {
namespace {

using Words = std::vector<std::string>;

void add(Words& found, const std::string& words) {
  if(std::find(found.begin(), found.end(), words) == found.end())
    found.push_back(words);
}

std::size_t numbers_left(Text_cursor& cursor) {
  std::size_t count = 0;
  for(double number = 0.; cursor.read(number);)
    ++count;
  return count;
}

// Colours may stand behind the coordinates and behind the faces, whatever the keyword is.
Words unread_in_off(const std::string& file, std::string_view text, bool keeps_colours) {
  Words found;
  Text_source source(file, text);
  const Off_header header = read_off_header(source);
  if(header.has_texture_coordinates)
    add(found, "texture coordinates");
  if(header.has_colours && !keeps_colours)
    add(found, "vertex colours");
  if(header.has_normals)
    add(found, "normals");
  if(header.is_free_form)
    return found;
  const bool says_nothing = !header.has_colours && found.empty();
  for(std::size_t v = 0; v < header.number_of_points; ++v, source.skip_line()) {
    source.skip_to_content();
    if(v == 0 && says_nothing && !keeps_colours &&
       numbers_left(source) > (header.is_homogeneous ? 4 : 3))
      add(found, "vertex colours");
  }
  long long corners = 0;
  if(header.number_of_faces > 0 && source.skip_to_content() && source.read(corners) &&
     numbers_left(source) > static_cast<std::size_t>((std::max)(corners, 0ll)))
    add(found, "face colours");
  return found;
}

Words unread_in_obj(std::string file_text) {
  Words found;
  const std::string text = join_continued_lines(std::move(file_text));
  Text_cursor cursor(text);
  for(; cursor.skip_to_content(); cursor.skip_line()) {
    const std::string_view keyword = cursor.word();
    if(keyword == "vt")
      add(found, "texture coordinates");
    else if(keyword == "vn")
      add(found, "normals");
    else if(keyword == "usemtl" || keyword == "mtllib")
      add(found, "materials");
    else if(keyword == "g" || keyword == "o")
      add(found, "groups");
    else if(keyword == "l")
      add(found, "lines");
    else if(keyword == "p")
      add(found, "points");
    else if(keyword == "v" && numbers_left(cursor) >= 6)
      add(found, "vertex colours");
  }
  return found;
}

// "the vertex properties red, green", or nothing.
void add_properties(Words& found,
                    const Ply_element& element,
                    std::initializer_list<std::string_view> read,
                    const Vertex_properties& kept = {}) {
  std::string names;
  for(const Ply_property& property : element.properties)
    if(std::find(read.begin(), read.end(), property.name) == read.end() &&
       !has_property(kept, property.name))
      names += (names.empty() ? "" : ", ") + property.name;
  if(!names.empty())
    add(found, "the " + element.name + " properties " + names);
}

Words unread_in_ply(const std::string& file,
                    std::string_view content,
                    const Vertex_properties& kept) {
  Words found;
  Text_source text(file, content);
  for(const Ply_element& element : read_ply_header(text).elements)
    if(element.has_vertices())
      add_properties(found, element, {"x", "y", "z"}, kept);
    else if(element.has_faces())
      add_properties(found, element, {"vertex_indices", "vertex_index"});
    else if(element.count > 0)
      add(found, "the elements " + element.name);
  return found;
}

} // namespace

std::vector<std::string> unread_data(const Input_file& file, const Vertex_properties& kept) {
  if(file.is_of_format(".off"))
    return unread_in_off(file.name(), file.content(), !kept.empty());
  if(file.is_of_format(".obj"))
    return unread_in_obj(std::string(file.content()));
  if(file.is_of_format(".ply"))
    return unread_in_ply(file.name(), file.content(), kept);
  return {};
}

} // namespace htloops
