// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PLY_HEADER_H
#define HTLOOPS_PLY_HEADER_H

#include "read/text_source.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace htloops {

enum class Ply_type { NONE, INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT, DOUBLE };

/// A number, or a list of numbers preceded by their count, of an element of a PLY file.
struct Ply_property
{
  std::string name;
  std::string type_name;
  Ply_type type = Ply_type::NONE;       ///< of the number or of the items of the list
  Ply_type count_type = Ply_type::NONE; ///< none if it is no list

  bool is_list() const { return count_type != Ply_type::NONE; }
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;

  bool has_vertices() const { return name == "vertex" || name == "vertices"; }
  bool has_faces() const { return name == "face" || name == "faces"; }
  bool has_strips() const {
    return name == "tristrips";
  } ///< of triangles, as Stanford's scans have
};

enum class Ply_format { ASCII, BINARY_LITTLE_ENDIAN, BINARY_BIG_ENDIAN };

struct Ply_header
{
  Ply_format format = Ply_format::ASCII;
  std::vector<Ply_element> elements;
};

/// the type of a name; none if PLY has no such type.
Ply_type ply_type(std::string_view name);

bool is_integer(Ply_type type);

/// reads the header of a PLY file and goes to the data. Throws `Failure` if it is malformed or
/// declares a type that PLY does not have.
Ply_header read_ply_header(Text_source& text);

} // namespace htloops

#endif // HTLOOPS_PLY_HEADER_H
