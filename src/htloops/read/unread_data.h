// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_UNREAD_DATA_H
#define HTLOOPS_UNREAD_DATA_H

#include "read/input_file.h"
#include "vertex_properties.h"

#include <string>
#include <vector>

namespace htloops {

/// what a file has besides points, faces and the properties that are kept of it, in words:
/// "normals", "the vertex properties red, green, blue". Looks no further than is needed to tell;
/// knows OFF, OBJ and PLY.
std::vector<std::string> unread_data(const Input_file& file, const Vertex_properties& kept);

} // namespace htloops

#endif // HTLOOPS_UNREAD_DATA_H
