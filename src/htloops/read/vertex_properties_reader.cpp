// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/vertex_properties_reader.h"

#include "read/ply_header.h"
#include "read/text_cursor.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace htloops {
namespace {

template <typename T> double number_in(const std::array<char, 8>& bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return static_cast<double>(value);
}

bool is_little_endian_here() {
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

// Of a type of PLY, its bytes in the order of this machine.
double number_of_type(const std::string& type, const std::array<char, 8>& bytes) {
  const bool is_unsigned = type[0] == 'u';
  switch(size_of_ply_type(type)) {
  case 1:
    return is_unsigned ? number_in<std::uint8_t>(bytes) : number_in<std::int8_t>(bytes);
  case 2:
    return is_unsigned ? number_in<std::uint16_t>(bytes) : number_in<std::int16_t>(bytes);
  case 8:
    return number_in<double>(bytes);
  default:
    if(type[0] == 'f')
      return number_in<float>(bytes);
    return is_unsigned ? number_in<std::uint32_t>(bytes) : number_in<std::int32_t>(bytes);
  }
}

class Binary_numbers
{
public:
  Binary_numbers(std::string_view data, bool is_little_endian)
      : rest_(data)
      , is_swapped_(is_little_endian != is_little_endian_here()) {}

  bool read(const std::string& type, double& value) {
    const std::size_t size = size_of_ply_type(type);
    if(rest_.size() < size)
      return false;
    std::array<char, 8> bytes{};
    std::copy_n(rest_.begin(), size, bytes.begin());
    rest_.remove_prefix(size);
    if(is_swapped_)
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    value = number_of_type(type, bytes);
    return true;
  }

private:
  std::string_view rest_;
  bool is_swapped_;
};

class Text_numbers
{
public:
  explicit Text_numbers(std::string_view data)
      : cursor_(data) {}

  bool read(const std::string&, double& value) {
    return cursor_.skip_to_content() && cursor_.read(value);
  }

private:
  Text_cursor cursor_;
};

bool is_coordinate(const std::string& name) { return name == "x" || name == "y" || name == "z"; }

// Nothing if there are fewer numbers than announced.
template <typename Numbers>
Vertex_properties read_columns(const Ply_element& vertex, Numbers numbers) {
  Vertex_properties columns;
  for(const Ply_property& property : vertex.properties)
    columns.push_back({property.name, property.type, {}});
  for(std::size_t v = 0; v < vertex.count; ++v)
    for(Vertex_property& column : columns) {
      double value;
      if(!numbers.read(column.type, value))
        return {};
      if(!is_coordinate(column.name))
        column.values.push_back(value);
    }
  columns.erase(std::remove_if(columns.begin(), columns.end(),
                               [](const Vertex_property& p) { return is_coordinate(p.name); }),
                columns.end());
  return columns;
}

Vertex_properties read_from_ply(std::string_view text) {
  const Ply_header header = read_ply_header(text);
  if(header.elements.empty() || header.elements[0].name.find("vert") != 0)
    return {};
  const Ply_element& vertex = header.elements[0];
  if(std::any_of(vertex.properties.begin(), vertex.properties.end(),
                 [](const Ply_property& p) { return p.is_list(); }))
    return {};
  text.remove_prefix(header.size);
  if(header.format == Ply_format::ASCII)
    return read_columns(vertex, Text_numbers(text));
  return read_columns(vertex,
                      Binary_numbers(text, header.format == Ply_format::BINARY_LITTLE_ENDIAN));
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
Vertex_properties read_from_off(std::string_view text) {
  Text_cursor cursor(text);
  cursor.skip_to_content();
  const std::string_view keyword = cursor.word();
  long long vertices = 0;
  if((keyword != "OFF" && keyword != "COFF") || !cursor.skip_to_content() || !cursor.read(vertices))
    return {};
  Vertex_properties colours = {
      {"red", "", {}}, {"green", "", {}}, {"blue", "", {}}, {"alpha", "", {}}};
  for(long long v = 0; v < vertices; ++v) {
    cursor.skip_line();
    double number;
    if(!cursor.skip_to_content() || !cursor.read(number) || !cursor.read(number) ||
       !cursor.read(number))
      return {};
    for(Vertex_property& colour : colours)
      if(cursor.read(number))
        colour.values.push_back(number);
    if(colours[2].values.empty())
      return {}; // as in most files
  }
  if(colours[3].values.empty())
    colours.pop_back();
  name_types(colours);
  const bool is_complete =
      std::all_of(colours.begin(), colours.end(), [vertices](const Vertex_property& p) {
        return p.values.size() == static_cast<std::size_t>(vertices);
      });
  return is_complete ? colours : Vertex_properties();
}

} // namespace

Vertex_properties read_vertex_properties(const Input_file& file) {
  if(boost::algorithm::iends_with(file.name(), ".ply"))
    return read_from_ply(file.content());
  if(boost::algorithm::iends_with(file.name(), ".off"))
    return read_from_off(file.content());
  return {};
}

} // namespace htloops
