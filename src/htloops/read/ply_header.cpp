// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/ply_header.h"

#include <utility>

namespace htloops {
namespace {

void check_version(Text_source& text) {
  const std::string_view version = text.word();
  if(version != "1.0" && !version.empty())
    text.fail("the unknown version " + in_quotes(version) + " of PLY");
}

Ply_format read_format(Text_source& text) {
  const std::string_view format = text.word();
  if(format == "ascii")
    return Ply_format::ASCII;
  if(format == "binary_little_endian")
    return Ply_format::BINARY_LITTLE_ENDIAN;
  if(format != "binary_big_endian")
    text.fail("the unknown format " + in_quotes(format));
  return Ply_format::BINARY_BIG_ENDIAN;
}

Ply_element read_element(Text_source& text) {
  Ply_element element;
  element.name = text.word();
  long long count;
  if(!text.read(count) || count < 0)
    text.fail("an element without a name and a number");
  element.count = static_cast<std::size_t>(count);
  return element;
}

Ply_property read_property(Text_source& text) {
  Ply_property property;
  property.type_name = text.word();
  if(property.type_name == "list") {
    const std::string_view count_type = text.word();
    property.count_type = ply_type(count_type);
    if(!is_integer(property.count_type))
      text.fail("a list whose length is of the type " + in_quotes(count_type) +
                ", which is no integer type");
    property.type_name = text.word();
  }
  property.type = ply_type(property.type_name);
  if(property.type == Ply_type::NONE)
    text.fail("a property of the unknown type " + in_quotes(property.type_name));
  property.name = text.word();
  return property;
}

} // namespace

Ply_type ply_type(std::string_view name) {
  static constexpr std::pair<std::string_view, Ply_type> types[] = {
      {"char", Ply_type::INT8},     {"int8", Ply_type::INT8},     {"uchar", Ply_type::UINT8},
      {"uint8", Ply_type::UINT8},   {"short", Ply_type::INT16},   {"int16", Ply_type::INT16},
      {"ushort", Ply_type::UINT16}, {"uint16", Ply_type::UINT16}, {"int", Ply_type::INT32},
      {"int32", Ply_type::INT32},   {"uint", Ply_type::UINT32},   {"uint32", Ply_type::UINT32},
      {"float", Ply_type::FLOAT},   {"float32", Ply_type::FLOAT}, {"double", Ply_type::DOUBLE},
      {"float64", Ply_type::DOUBLE}};
  for(const auto& [type_name, type] : types)
    if(type_name == name)
      return type;
  return Ply_type::NONE;
}

bool is_integer(Ply_type type) {
  return type != Ply_type::NONE && type != Ply_type::FLOAT && type != Ply_type::DOUBLE;
}

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
        text.fail("a property before any element");
      header.elements.back().properties.push_back(read_property(text));
    } else if(keyword == "end_header") {
      text.skip_line();
      return header;
    }
  }
  text.fail("the header has no end");
}

} // namespace htloops
