// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/ply_guard.h"

#include "failure.h"
#include "read/ply_header.h"
#include "read/text_cursor.h"

#include <algorithm>

namespace htloops {
namespace {

[[noreturn]] void fail(const std::string& problem) {
  throw Failure(Exit_code::UNREADABLE_FILE, problem);
}

bool is_coordinate(const Ply_property& property, const char* name) {
  const bool is_real = property.type.find("float") == 0 || property.type.find("double") == 0;
  return property.name == name && is_real && !property.is_list();
}

bool is_vertex_list(const Ply_property& property) {
  const bool is_integer = property.type.find("int") != std::string::npos;
  return (property.name == "vertex_indices" || property.name == "vertex_index") &&
         property.is_list() && is_integer && size_of_ply_type(property.type) == 4;
}

void check_properties(const Ply_element& element) {
  const auto& properties = element.properties;
  if(properties.empty() && element.count != 0)
    fail("its header declares " + element.name + " without any property");
  if(element.name == "vertex" || element.name == "vertices") {
    for(const char* name : {"x", "y", "z"})
      if(std::none_of(properties.begin(), properties.end(),
                      [name](const Ply_property& p) { return is_coordinate(p, name); }))
        fail("its vertices have no coordinate " + std::string(name) + " of type float or double");
  } else if(element.name == "face" || element.name == "faces") {
    if(std::none_of(properties.begin(), properties.end(), is_vertex_list))
      fail("its faces have no list vertex_indices (or vertex_index) of type int or uint");
  }
}

// Walks over numbers in text form.
class Text_walker
{
public:
  explicit Text_walker(std::string_view data)
      : cursor_(data) {}

  bool skip(std::size_t count, const std::string&) {
    for(std::size_t i = 0; i < count; ++i)
      if(!cursor_.skip_to_content() || cursor_.word().empty())
        return false;
    return true;
  }

  bool read_count(const std::string&, std::size_t& count) {
    long long value;
    if(!cursor_.skip_to_content() || !cursor_.read(value) || value < 0)
      return false;
    count = static_cast<std::size_t>(value);
    return true;
  }

private:
  Text_cursor cursor_;
};

// Walks over numbers in binary form.
class Binary_walker
{
public:
  Binary_walker(std::string_view data, bool is_little_endian)
      : rest_(data)
      , is_little_endian_(is_little_endian) {}

  bool skip(std::size_t count, const std::string& type) {
    const std::size_t size = size_of_ply_type(type);
    if(count > rest_.size() / size)
      return false;
    rest_.remove_prefix(count * size);
    return true;
  }

  // A negative count is taken for a very large one: either is wrong.
  bool read_count(const std::string& type, std::size_t& count) {
    const std::string_view bytes = rest_;
    if(!skip(1, type))
      return false;
    count = 0;
    const std::size_t size = size_of_ply_type(type);
    for(std::size_t i = 0; i < size; ++i)
      count = 256 * count + static_cast<unsigned char>(bytes[is_little_endian_ ? size - 1 - i : i]);
    return true;
  }

private:
  std::string_view rest_;
  bool is_little_endian_;
};

template <typename Walker> bool skip_item(const Ply_element& element, Walker& walker) {
  for(const Ply_property& property : element.properties) {
    std::size_t count = 1;
    if(property.is_list() && !walker.read_count(property.count_type, count))
      return false;
    if(!walker.skip(count, property.type))
      return false;
  }
  return true;
}

template <typename Walker> void check_data(const Ply_header& header, Walker walker) {
  for(const Ply_element& element : header.elements)
    for(std::size_t i = 0; i < element.count; ++i)
      if(!skip_item(element, walker))
        fail("it is malformed or ends in " + element.name + " " + std::to_string(i) + " of " +
             std::to_string(element.count));
}

void check_content(std::string_view content) {
  const Ply_header header = read_ply_header(content);
  for(const Ply_element& element : header.elements)
    check_properties(element);
  content.remove_prefix(header.size);
  if(header.format == Ply_format::ASCII)
    check_data(header, Text_walker(content));
  else
    check_data(header, Binary_walker(content, header.format == Ply_format::BINARY_LITTLE_ENDIAN));
}

} // namespace

void check_ply(const Input_file& file) {
  try {
    check_content(file.content());
  } catch(const Failure& failure) {
    throw Failure(failure.code(), file.name() + ": " + failure.what());
  }
}

} // namespace htloops
