// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SKELETON_READER_H
#define HTLOOPS_SKELETON_READER_H

#include "read/input_file.h"
#include "skeleton_lines.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace htloops {

/// What a file says of a skeleton, and the size of the mesh that it was drawn in.
struct Skeleton_record
{
  Skeleton_lines lines;
  std::optional<std::array<std::size_t, 2>> mesh_size; ///< vertices and faces
};

/// whether a file has a skeleton, by its ending or, of JSON, by what it says it is.
bool is_skeleton_file(const Input_file& file);

/// the endings by which it may have one.
std::string endings_of_skeletons();

/// reads a skeleton: JSON of htloops, lines of OBJ, PolyData of VTK as text, SWC, GraphML with x, y
/// and z of nodes, and polylines of CGAL. Where a format is one of lines and not of graphs,
/// points at the same place are one. Throws `Failure` if it is none of these, or wrong.
Skeleton_record read_skeleton(const Input_file& file);

} // namespace htloops

#endif // HTLOOPS_SKELETON_READER_H
