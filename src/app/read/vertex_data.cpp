// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/vertex_data.h"

#include "read/meshes/formats.h"
#include "read/sources.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace htloops {
namespace {

bool is_coordinate(const std::string& name) { return name == "x" || name == "y" || name == "z"; }

// Nothing if there are fewer numbers than announced.
Vertex_properties read_columns(const Ply_element& vertex, Ply_numbers numbers) {
  Vertex_properties columns;
  for(const Ply_property& property : vertex.properties)
    columns.push_back({property.name, property.type_name, {}});
  for(std::size_t v = 0; v < vertex.count; ++v) {
    numbers.begin_element();
    for(std::size_t i = 0; i < columns.size(); ++i)
      if(!numbers.read(*vertex.properties[i].type, columns[i].values.emplace_back()))
        return {};
  }
  columns.erase(std::remove_if(columns.begin(), columns.end(),
                               [](const Vertex_property& p) { return is_coordinate(p.name); }),
                columns.end());
  return columns;
}

Vertex_properties read_from_ply(const std::string& file, std::string_view content) {
  Text_source text(file, content);
  const Ply_header header = read_ply_header(text);
  if(header.elements.empty() || !header.elements[0].has_vertices())
    return {};
  const Ply_element& vertex = header.elements[0];
  if(std::any_of(vertex.properties.begin(), vertex.properties.end(),
                 [](const Ply_property& p) { return p.is_list(); }))
    return {};
  return read_columns(vertex, Ply_numbers(file, content, text, header.format));
}

// Colours are numbers from 0 to 255, or shares of 1.
void name_types(Vertex_properties& colours) {
  bool is_share = true;
  for(const Vertex_property& p : colours)
    is_share = is_share && std::all_of(p.values.begin(), p.values.end(),
                                       [](double x) { return 0. <= x && x <= 1.; });
  for(Vertex_property& p : colours)
    p.type = is_share ? "double" : "uchar";
}

// Nothing unless each vertex has a colour.
Vertex_properties read_from_off(const std::string& file, std::string_view text) {
  Text_source source(file, text);
  const Off_header header = read_off_header(source);
  if(header.has_texture_coordinates || header.has_normals || header.is_homogeneous ||
     header.is_free_form)
    return {};
  Vertex_properties colours = {
      {"red", "", {}}, {"green", "", {}}, {"blue", "", {}}, {"alpha", "", {}}};
  for(std::size_t v = 0; v < header.number_of_points; ++v, source.skip_line()) {
    double number;
    if(!source.skip_to_content() || !source.read(number) || !source.read(number) ||
       !source.read(number))
      return {};
    for(Vertex_property& colour : colours)
      if(source.read(number))
        colour.values.push_back(number);
    if(colours[2].values.empty())
      return {}; // as in most files
  }
  if(colours[3].values.empty())
    colours.pop_back();
  name_types(colours);
  const bool is_complete =
      std::all_of(colours.begin(), colours.end(), [&header](const Vertex_property& p) {
        return p.values.size() == header.number_of_points;
      });
  return is_complete ? colours : Vertex_properties();
}

using Words = std::vector<std::string>;

void add(Words& found, const std::string& words) {
  if(std::find(found.begin(), found.end(), words) == found.end())
    found.push_back(words);
}

std::size_t numbers_left(Text_source& cursor) {
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
    add(found, "vertex colors");
  if(header.has_normals)
    add(found, "normals");
  if(header.is_free_form)
    return found;
  const bool says_nothing = !header.has_colours && found.empty();
  for(std::size_t v = 0; v < header.number_of_points; ++v, source.skip_line()) {
    source.skip_to_content();
    if(v == 0 && says_nothing && !keeps_colours &&
       numbers_left(source) > (header.is_homogeneous ? 4 : 3))
      add(found, "vertex colors");
  }
  long long corners = 0;
  if(header.number_of_faces > 0 && source.skip_to_content() && source.read(corners) &&
     numbers_left(source) > static_cast<std::size_t>((std::max)(corners, 0ll)))
    add(found, "face colors");
  return found;
}

Words unread_in_obj(const std::string& file, std::string file_text) {
  static constexpr std::pair<std::string_view, const char*> names[] = {
      {"vt", "texture coordinates"},
      {"vn", "normals"},
      {"usemtl", "materials"},
      {"mtllib", "materials"},
      {"g", "groups"},
      {"o", "groups"},
      {"l", "lines"},
      {"p", "points"}};
  Words found;
  const std::string text = join_continued_lines(std::move(file_text));
  Text_source cursor(file, text);
  for(; cursor.skip_to_content(); cursor.skip_line()) {
    const std::string_view keyword = cursor.word();
    for(const auto& [name, words] : names)
      if(keyword == name)
        add(found, words);
    if(keyword == "v" && numbers_left(cursor) >= 6)
      add(found, "vertex colors");
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

std::vector<double> read_values(const Input_file& file, std::size_t number_of_vertices) {
  Text_source cursor(file.name(), file.content());
  std::vector<double> values;
  while(cursor.skip_to_content()) {
    double value = 0.;
    if(!cursor.read(value))
      fail_to_read(file.name(), "line " + std::to_string(cursor.line()) + ": expected a number");
    if(!std::isfinite(value))
      fail_to_read(file.name(),
                   "the value of vertex " + std::to_string(values.size()) + " is not finite");
    values.push_back(value);
  }
  if(values.size() != number_of_vertices)
    fail_to_read(file.name(), "it has " + std::to_string(values.size()) + " values for " +
                                  std::to_string(number_of_vertices) + " vertices");
  return values;
}

Vertex_properties read_vertex_properties(const Input_file& file) {
  if(file.is_of_format(".ply"))
    return read_from_ply(file.name(), file.content());
  if(file.is_of_format(".off"))
    return read_from_off(file.name(), file.content());
  return {};
}

std::vector<std::string> unread_data(const Input_file& file, const Vertex_properties& kept) {
  if(file.is_of_format(".off"))
    return unread_in_off(file.name(), file.content(), !kept.empty());
  if(file.is_of_format(".obj"))
    return unread_in_obj(file.name(), std::string(file.content()));
  if(file.is_of_format(".ply"))
    return unread_in_ply(file.name(), file.content(), kept);
  return {};
}

} // namespace htloops
