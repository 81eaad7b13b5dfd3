// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/unread_data.h"

#include "read/ply_header.h"
#include "read/text_cursor.h"

#include <boost/algorithm/string/predicate.hpp>

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

// Colours may stand behind the coordinates and behind the faces, whatever the header is.
Words unread_in_off(std::string_view text, bool has_colours) {
  Words found;
  Text_cursor cursor(text);
  cursor.skip_to_content();
  const std::string_view header = cursor.word();
  const std::string_view prefix = header.substr(0, header.find("OFF"));
  if(prefix.find("ST") != prefix.npos)
    add(found, "texture coordinates");
  if(prefix.find('C') != prefix.npos && !has_colours)
    add(found, "vertex colours");
  if(prefix.find('N') != prefix.npos)
    add(found, "normals");
  long long vertices = 0, faces = 0, corners = 0;
  cursor.skip_to_content();
  if(!cursor.read(vertices) || !cursor.read(faces))
    return found;
  for(long long v = 0; v < vertices && (cursor.skip_line(), cursor.skip_to_content()); ++v)
    if(v == 0 && prefix.empty() && !has_colours && numbers_left(cursor) > 3)
      add(found, "vertex colours");
  cursor.skip_line();
  if(faces > 0 && cursor.skip_to_content() && cursor.read(corners) &&
     numbers_left(cursor) > static_cast<std::size_t>((std::max)(corners, 0ll)))
    add(found, "face colours");
  return found;
}

Words unread_in_obj(std::string_view text) {
  Words found;
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

Words unread_in_ply(std::string_view text, const Vertex_properties& kept) {
  Words found;
  for(const Ply_element& element : read_ply_header(text).elements)
    if(element.name == "vertex" || element.name == "vertices")
      add_properties(found, element, {"x", "y", "z"}, kept);
    else if(element.name == "face" || element.name == "faces")
      add_properties(found, element, {"vertex_indices", "vertex_index"});
    else if(element.count > 0)
      add(found, "the elements " + element.name);
  return found;
}

} // namespace

std::vector<std::string> unread_data(const Input_file& file, const Vertex_properties& kept) {
  if(boost::algorithm::iends_with(file.name(), ".off"))
    return unread_in_off(file.content(), !kept.empty());
  if(boost::algorithm::iends_with(file.name(), ".obj"))
    return unread_in_obj(file.content());
  if(boost::algorithm::iends_with(file.name(), ".ply"))
    return unread_in_ply(file.content(), kept);
  return {};
}

} // namespace htloops
