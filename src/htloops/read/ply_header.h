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

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace htloops {

/// A number, or a list of numbers preceded by their count, of an element of a PLY file.
struct Ply_property
{
  std::string name;
  std::string type;       ///< of the number or of the items of the list
  std::string count_type; ///< empty if it is no list

  bool is_list() const { return !count_type.empty(); }
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;
};

enum class Ply_format { ASCII, BINARY_LITTLE_ENDIAN, BINARY_BIG_ENDIAN };

struct Ply_header
{
  Ply_format format = Ply_format::ASCII;
  std::vector<Ply_element> elements;
  std::size_t size = 0; ///< in bytes: the data begin there
};

/// the size in bytes of a number of a type, 0 if PLY has no such type.
std::size_t size_of_ply_type(std::string_view type);

/// reads the header of a PLY file given its content. Throws `Failure`, without the name of the
/// file, if it is malformed or declares a type that PLY does not have.
Ply_header read_ply_header(std::string_view content);

} // namespace htloops

#endif // HTLOOPS_PLY_HEADER_H
