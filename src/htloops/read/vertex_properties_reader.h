// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VERTEX_PROPERTIES_READER_H
#define HTLOOPS_VERTEX_PROPERTIES_READER_H

#include "read/input_file.h"
#include "vertex_properties.h"

namespace htloops {

/// reads what a mesh file that is known to be sound says of its vertices besides where they are:
/// the numbers of PLY, and the colours of OFF, named as in PLY. Of other formats, and where a list
/// stands among the numbers, nothing.
Vertex_properties read_vertex_properties(const Input_file& file);

} // namespace htloops

#endif // HTLOOPS_VERTEX_PROPERTIES_READER_H
