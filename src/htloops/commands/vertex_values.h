// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VERTEX_VALUES_H
#define HTLOOPS_VERTEX_VALUES_H

#include "app/mesh_types.h"
#include "app/read/input_file.h"
#include "app/read/soup.h"
#include "app/solve/changeable_mesh.h"
#include "commands/options.h"

#include <cstdint>
#include <string>
#include <vector>

namespace htloops {

/// the values of vertices, such as colours, that a file has and that another one has room for; none
/// if that has no name. Unless it is to be quiet, says which of the data of the file are not kept.
Vertex_properties values_to_keep(const Input_file& file,
                                 const File_facts& facts,
                                 const std::string& result_file,
                                 bool is_quiet);

/// those of vertices that were made of some of the file's.
void extend(Vertex_properties& properties, const std::vector<std::uint32_t>& origins);

} // namespace htloops

#endif // HTLOOPS_VERTEX_VALUES_H
