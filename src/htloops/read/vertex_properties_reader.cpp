// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/vertex_properties_reader.h"

#include "read/off_header.h"
#include "read/ply_numbers.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace htloops {
namespace {

bool is_coordinate(const std::string& name) { return name == "x" || name == "y" || name == "z"; }

// Nothing if there are fewer numbers than announced.
template <typename Numbers>
Vertex_properties read_columns(const Ply_element& vertex, Numbers numbers) {
  Vertex_properties columns;
  for(const Ply_property& property : vertex.properties)
    columns.push_back({property.name, property.type_name, {}});
  for(std::size_t v = 0; v < vertex.count; ++v) {
    numbers.begin_element();
    for(std::size_t i = 0; i < columns.size(); ++i) {
      double value;
      if(!numbers.read(vertex.properties[i].type, value))
        return {};
      if(!is_coordinate(columns[i].name))
        columns[i].values.push_back(value);
    }
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
  return with_ply_numbers(file, content, text, header.format,
                          [&](auto numbers) { return read_columns(vertex, numbers); });
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

} // namespace

Vertex_properties read_vertex_properties(const Input_file& file) {
  if(file.is_of_format(".ply"))
    return read_from_ply(file.name(), file.content());
  if(file.is_of_format(".off"))
    return read_from_off(file.name(), file.content());
  return {};
}

} // namespace htloops
