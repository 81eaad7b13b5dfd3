// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/ply_header.h"

#include "failure.h"

#include <algorithm>
#include <initializer_list>
#include <sstream>

namespace htloops {
namespace {

[[noreturn]] void fail(const std::string& problem) {
  throw Failure(Exit_code::UNREADABLE_FILE, "its header " + problem);
}

// takes the first line, without its end, off the content.
std::string take_line(std::string_view& content) {
  const std::size_t end = (std::min)(content.find('\n'), content.size());
  std::string line(content.substr(0, end));
  content.remove_prefix((std::min)(end + 1, content.size()));
  return line;
}

Ply_format read_format(std::istream& words) {
  std::string format;
  words >> format;
  if(format == "ascii")
    return Ply_format::ASCII;
  if(format == "binary_little_endian")
    return Ply_format::BINARY_LITTLE_ENDIAN;
  if(format != "binary_big_endian")
    fail("has the unknown format '" + format + "'");
  return Ply_format::BINARY_BIG_ENDIAN;
}

Ply_element read_element(std::istream& words) {
  Ply_element element;
  if(!(words >> element.name >> element.count))
    fail("declares an element without a name and a number");
  return element;
}

Ply_property read_property(std::istream& words) {
  Ply_property property;
  words >> property.type;
  if(property.type == "list") {
    words >> property.count_type >> property.type;
    if(size_of_ply_type(property.count_type) == 0)
      fail("has a list whose length is of the unknown type '" + property.count_type + "'");
  }
  words >> property.name;
  if(size_of_ply_type(property.type) == 0)
    fail("has a property of the unknown type '" + property.type + "'");
  return property;
}

} // namespace

std::size_t size_of_ply_type(std::string_view type) {
  const auto is_one_of = [type](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), type) != names.end();
  };
  if(is_one_of({"char", "int8", "uchar", "uint8"}))
    return 1;
  if(is_one_of({"short", "int16", "ushort", "uint16"}))
    return 2;
  if(is_one_of({"int", "int32", "uint", "uint32", "float", "float32"}))
    return 4;
  return is_one_of({"double", "float64"}) ? 8 : 0;
}

Ply_header read_ply_header(std::string_view content) {
  Ply_header header;
  std::string_view rest = content;
  std::string keyword;
  if(!(std::istringstream(take_line(rest)) >> keyword) || keyword != "ply")
    fail("does not begin with the word ply");
  while(!rest.empty()) {
    std::istringstream words(take_line(rest));
    keyword.clear();
    words >> keyword;
    if(keyword == "format") {
      header.format = read_format(words);
    } else if(keyword == "element") {
      header.elements.push_back(read_element(words));
    } else if(keyword == "property") {
      if(header.elements.empty())
        fail("declares a property before any element");
      header.elements.back().properties.push_back(read_property(words));
    } else if(keyword == "end_header") {
      header.size = content.size() - rest.size();
      return header;
    }
  }
  fail("has no end");
}

} // namespace htloops
