// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/ply_reader.h"

#include "read/input_file.h"
#include "read/ply_numbers.h"
#include "read/soup_words.h"

#include <algorithm>
#include <array>

namespace htloops {
namespace {

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
         property.is_list() && is_integer(property.type);
}

std::size_t number_of_vertices(const Ply_header& header) {
  std::size_t count = 0;
  for(const Ply_element& element : header.elements)
    count += element.has_vertices() ? element.count : 0;
  return count;
}

template <typename Numbers> class Ply_parser
{
public:
  Ply_parser(const std::string& file, std::size_t size, const Ply_header& header, Numbers numbers)
      : file_(file)
      , size_(size)
      , header_(header)
      , numbers_(numbers)
      , number_of_points_(number_of_vertices(header)) {}

  Soup parse() {
    for(const Ply_element& element : header_.elements) {
      if(element.properties.empty() && element.count != 0)
        fail_to_read(file_, "its header declares " + element.name + " without any property");
      if(element.has_vertices())
        read_points(element);
      else if(element.has_faces())
        read_faces(element);
      else
        read_items(element, nowhere, [] {});
    }
    return std::move(soup_);
  }

private:
  // No more than what the file has room for, whatever its header says.
  template <typename Elements> void reserve(Elements& elements, std::size_t announced) const {
    constexpr std::size_t smallest_element = 4;
    elements.reserve((std::min)(announced, size_ / smallest_element));
  }

  void read_points(const Ply_element& element) {
    std::array<std::size_t, 3> coordinates;
    for(std::size_t i = 0; i < 3; ++i) {
      const std::string name(1, "xyz"[i]);
      coordinates[i] = find_property(
          element, [&](const Ply_property& p) { return p.name == name && !p.is_list(); });
      if(coordinates[i] == nowhere)
        fail_to_read(file_, "its vertices have no coordinate " + name);
    }
    reserve(soup_.points, element.count);
    read_items(element, nowhere, [&] {
      soup_.points.emplace_back(values_[coordinates[0]], values_[coordinates[1]],
                                values_[coordinates[2]]);
    });
  }

  void read_faces(const Ply_element& element) {
    const std::size_t corners = find_property(element, is_vertex_list);
    if(corners == nowhere)
      fail_to_read(file_,
                   "its faces have no list vertex_indices (or vertex_index) of an integer type");
    reserve(soup_.faces, element.count);
    read_items(element, corners, [&] { soup_.faces.push_back(face_); });
  }

  // The numbers of an item are left in values_, the list of its corners, if it has one, in face_.
  template <typename Keep>
  void read_items(const Ply_element& element, std::size_t corners, Keep keep) {
    values_.resize(element.properties.size());
    for(item_ = 0; item_ < element.count; ++item_) {
      numbers_.begin_element();
      for(std::size_t i = 0; i < element.properties.size(); ++i) {
        const Ply_property& property = element.properties[i];
        values_[i] =
            read(element, property, property.is_list() ? property.count_type : property.type);
        if(property.is_list())
          read_list(element, property, values_[i], i == corners);
      }
      if(!numbers_.end_element())
        numbers_.fail(name_of_item(element) + " has more on its line than the header declares");
      keep();
    }
  }

  void read_list(const Ply_element& element,
                 const Ply_property& property,
                 double count,
                 bool has_corners) {
    if(count < 0.)
      numbers_.fail("the length of " + property.name + " of " + name_of_item(element) +
                    " is negative");
    if(has_corners)
      face_.resize(static_cast<std::size_t>(count));
    for(std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const double value = read(element, property, property.type);
      if(has_corners)
        soup_.set_corner(face_, i, vertex(value));
    }
  }

  double read(const Ply_element& element, const Ply_property& property, Ply_type type) {
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
  const std::size_t size_;
  const Ply_header& header_;
  Numbers numbers_;
  const std::size_t number_of_points_;
  Soup soup_;
  std::size_t item_ = 0;
  std::vector<double> values_;
  Soup_face face_;
};

} // namespace

Soup read_ply(const std::string& file, std::string_view content) {
  Text_source text(file, content);
  const Ply_header header = read_ply_header(text);
  return with_ply_numbers(file, content, text, header.format, [&](auto numbers) {
    return Ply_parser<decltype(numbers)>(file, content.size(), header, numbers).parse();
  });
}

} // namespace htloops
