// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/input_file.h"
#include "read/meshes/formats.h"
#include "read/meshes/readers.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>

namespace htloops {
namespace {

void check_version(Text_source& text) {
  const std::string_view version = text.word();
  if(version != "1.0" && !version.empty())
    text.fail("unknown PLY version " + in_quotes(version));
}

Ply_format read_format(Text_source& text) {
  const std::string_view format = text.word();
  if(format == "ascii")
    return Ply_format::ASCII;
  if(format == "binary_little_endian")
    return Ply_format::BINARY_LITTLE_ENDIAN;
  if(format != "binary_big_endian")
    text.fail("unknown PLY format " + in_quotes(format));
  return Ply_format::BINARY_BIG_ENDIAN;
}

Ply_element read_element(Text_source& text) {
  Ply_element element;
  element.name = text.word();
  long long count;
  if(!text.read(count) || count < 0)
    text.fail("an element needs a name and a count");
  element.count = static_cast<std::size_t>(count);
  return element;
}

constexpr Ply_type ply_types[] = {{"char", "int8", true, read_as<std::int8_t>},
                                  {"uchar", "uint8", true, read_as<std::uint8_t>},
                                  {"short", "int16", true, read_as<std::int16_t>},
                                  {"ushort", "uint16", true, read_as<std::uint16_t>},
                                  {"int", "int32", true, read_as<std::int32_t>},
                                  {"uint", "uint32", true, read_as<std::uint32_t>},
                                  {"float", "float32", false, read_as<float>},
                                  {"double", "float64", false, read_as<double>}};

// The type of a name; null if PLY has no such type.
const Ply_type* ply_type(std::string_view name) {
  const auto found =
      std::find_if(std::begin(ply_types), std::end(ply_types), [name](const Ply_type& type) {
        return name == type.name || name == type.other_name;
      });
  return found == std::end(ply_types) ? nullptr : found;
}

Ply_property read_property(Text_source& text) {
  Ply_property property;
  property.type_name = text.word();
  if(property.type_name == "list") {
    const std::string_view count_type = text.word();
    property.count_type = ply_type(count_type);
    if(!property.is_list() || !property.count_type->is_integer)
      text.fail("the length of a list has the type " + in_quotes(count_type) +
                ", which is not an integer type");
    property.type_name = text.word();
  }
  property.type = ply_type(property.type_name);
  if(property.type == nullptr)
    text.fail("unknown property type " + in_quotes(property.type_name));
  property.name = text.word();
  return property;
}

constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

// The number of the first property that is as wanted, or nowhere.
template <typename Is_wanted>
std::size_t find_property(const Ply_element& element, Is_wanted is_wanted) {
  const auto& properties = element.properties;
  const auto found = std::find_if(properties.begin(), properties.end(), is_wanted);
  return found == properties.end() ? nowhere : static_cast<std::size_t>(found - properties.begin());
}

bool is_vertex_list(const Ply_property& property) {
  return (property.name == "vertex_indices" || property.name == "vertex_index") &&
         property.is_list() && property.type->is_integer;
}

std::size_t number_of_vertices(const Ply_header& header) {
  std::size_t count = 0;
  for(const Ply_element& element : header.elements)
    count += element.has_vertices() ? element.count : 0;
  return count;
}

class Ply_parser
{
public:
  Ply_parser(const std::string& file, std::string_view content)
      : file_(file)
      , content_(content)
      , text_(file, content) {}

  Soup parse() {
    for(const Ply_element& element : header_.elements) {
      if(element.properties.empty() && element.count != 0)
        fail_to_read(file_, "its header declares " + element.name + " without properties");
      if(element.has_vertices())
        read_points(element);
      else if(element.has_faces())
        read_faces(element);
      else if(element.has_strips())
        read_strips(element);
      else
        read_items(element, nowhere, ignore, [] {});
    }
    numbers_.end();
    return std::move(soup_);
  }

private:
  static constexpr std::size_t smallest_element = 4;

  void read_points(const Ply_element& element) {
    std::array<std::size_t, 3> coordinates;
    for(std::size_t i = 0; i < 3; ++i) {
      const std::string name(1, "xyz"[i]);
      coordinates[i] = find_property(
          element, [&](const Ply_property& p) { return p.name == name && !p.is_list(); });
      if(coordinates[i] == nowhere)
        fail_to_read(file_, "its vertices have no coordinate " + name);
    }
    soup_.points.reserve((std::min)(element.count, content_.size() / smallest_element));
    read_items(element, nowhere, ignore, [&] {
      soup_.points.emplace_back(values_[coordinates[0]], values_[coordinates[1]],
                                values_[coordinates[2]]);
    });
  }

  void read_faces(const Ply_element& element) {
    const std::size_t corners = vertex_list_of(element);
    soup_.faces.reserve((std::min)(element.count, content_.size() / smallest_element));
    const auto set_corner = [&](std::size_t i, std::size_t count, double value) {
      if(i == 0)
        face_.resize(count);
      soup_.set_corner(face_, i, vertex(value));
    };
    read_items(element, corners, set_corner, [&] {
      if(values_[corners] == 0.)
        face_.resize(0);
      soup_.faces.push_back(face_);
    });
  }

  // Each number after the first two makes a triangle with the two before, which is turned over
  // every second time; -1 begins anew. A number may come twice, which goes on elsewhere without a
  // triangle.
  void read_strips(const Ply_element& element) {
    std::array<std::uint32_t, 3> last{};
    std::size_t length = 0;
    const auto add = [&](std::size_t i, std::size_t, double value) {
      if(i == 0 || value == -1.)
        length = 0;
      if(value == -1.)
        return;
      last = {last[1], last[2], vertex(value)};
      if(++length >= 3)
        add_triangle_of_strip(last, length % 2 == 0);
    };
    read_items(element, vertex_list_of(element), add, [] {});
  }

  void add_triangle_of_strip(const std::array<std::uint32_t, 3>& corners, bool is_turned) {
    const auto& [a, b, c] = corners;
    if(a == b || b == c || c == a)
      return;
    face_.resize(3);
    soup_.set_corner(face_, 0, is_turned ? b : a);
    soup_.set_corner(face_, 1, is_turned ? a : b);
    soup_.set_corner(face_, 2, c);
    soup_.faces.push_back(face_);
  }

  std::size_t vertex_list_of(const Ply_element& element) const {
    const std::size_t corners = find_property(element, is_vertex_list);
    if(corners == nowhere)
      fail_to_read(file_, "its " + std::string(element.has_faces() ? "faces" : element.name) +
                              " have no list vertex_indices (or vertex_index) of an integer type");
    return corners;
  }

  // The numbers of an item are left in values_; those of one of its lists are given to `take`, with
  // their place in it and its length.
  template <typename Take, typename Keep>
  void read_items(const Ply_element& element, std::size_t taken, Take take, Keep keep) {
    values_.resize(element.properties.size());
    for(item_ = 0; item_ < element.count; ++item_) {
      numbers_.begin_element();
      for(std::size_t i = 0; i < element.properties.size(); ++i) {
        const Ply_property& property = element.properties[i];
        values_[i] =
            read(element, property, property.is_list() ? *property.count_type : *property.type);
        if(!property.is_list())
          continue;
        if(i == taken)
          read_list(element, property, values_[i], take);
        else
          read_list(element, property, values_[i], ignore);
      }
      if(!numbers_.end_element())
        numbers_.fail(name_of_item(element) +
                      " has more values on its line than the header declares");
      keep();
    }
  }

  static constexpr auto ignore = [](std::size_t, std::size_t, double) {};

  template <typename Take>
  void
  read_list(const Ply_element& element, const Ply_property& property, double count, Take take) {
    if(count < 0.)
      numbers_.fail("the length of " + property.name + " of " + name_of_item(element) +
                    " is negative");
    const auto length = static_cast<std::size_t>(count);
    for(std::size_t i = 0; i < length; ++i)
      take(i, length, read(element, property, *property.type));
  }

  double read(const Ply_element& element, const Ply_property& property, const Ply_type& type) {
    double value;
    if(!numbers_.read(type, value))
      numbers_.fail_incomplete("expected " + property.name + " of " + name_of_item(element));
    return value;
  }

  std::uint32_t vertex(double value) const {
    if(value < 0. || value >= static_cast<double>(number_of_points_))
      numbers_.fail(
          no_such_vertex(soup_.faces.size(), static_cast<long long>(value), number_of_points_));
    return static_cast<std::uint32_t>(value);
  }

  std::string name_of_item(const Ply_element& element) const {
    return element.name + " " + std::to_string(item_) + " of " + std::to_string(element.count);
  }

  const std::string& file_;
  const std::string_view content_; // there is no room for more, whatever the header says
  Text_source text_;
  const Ply_header header_ = read_ply_header(text_);
  Ply_numbers numbers_{file_, content_, text_, header_.format};
  const std::size_t number_of_points_ = number_of_vertices(header_);
  Soup soup_;
  std::size_t item_ = 0;
  std::vector<double> values_;
  Soup_face face_;
};

} // namespace

Ply_header read_ply_header(Text_source& text) {
  Ply_header header;
  if(text.word() != "ply")
    text.fail("a PLY file begins with the word ply");
  for(text.skip_line(); text.skip_to_content(); text.skip_line()) {
    const std::string_view keyword = text.word();
    if(keyword == "format") {
      header.format = read_format(text);
      check_version(text);
    } else if(keyword == "element") {
      header.elements.push_back(read_element(text));
    } else if(keyword == "property") {
      if(header.elements.empty())
        text.fail("a property comes before the first element");
      header.elements.back().properties.push_back(read_property(text));
    } else if(keyword == "end_header") {
      text.skip_line();
      return header;
    }
  }
  text.fail("the header has no end_header");
}

bool Ply_numbers::read(const Ply_type& type, double& value) {
  if(!is_text_)
    return type.read(bytes_, value);
  if(!type.is_integer)
    return text_.read(value);
  long long integer;
  if(!text_.read(integer) || integer < (std::numeric_limits<std::int32_t>::min)() ||
     integer > (std::numeric_limits<std::uint32_t>::max)())
    return false;
  value = static_cast<double>(integer);
  return true;
}

Soup read_ply(const Input_file& file) { return Ply_parser(file.name(), file.content()).parse(); }

} // namespace htloops
