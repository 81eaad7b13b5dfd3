// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VERTEX_DATA_H
#define HTLOOPS_VERTEX_DATA_H

#include "mesh_types.h"
#include "read/input_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace htloops {

/// reads as many finite numbers as there are vertices, separated by blanks or line ends; throws
/// `Failure`, naming the line or the vertex, if they are not there.
std::vector<double> read_values(const Input_file& file, std::size_t number_of_vertices);

/// reads what a mesh file that is known to be sound says of its vertices besides where they are:
/// the numbers of PLY, and the colours of OFF, named as in PLY. Of other formats, and where a list
/// stands among the numbers, nothing.
Vertex_properties read_vertex_properties(const Input_file& file);

/// what a file has besides points, faces and the properties that are kept of it, in words:
/// "normals", "the vertex properties red, green, blue". Looks no further than is needed to tell;
/// knows OFF, OBJ and PLY.
std::vector<std::string> unread_data(const Input_file& file, const Vertex_properties& kept);

} // namespace htloops

#endif // HTLOOPS_VERTEX_DATA_H
