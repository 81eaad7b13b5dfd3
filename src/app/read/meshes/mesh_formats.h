// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESH_FORMATS_H
#define HTLOOPS_MESH_FORMATS_H

#include "read/input_file.h"
#include "read/soup.h"

#include <string>
#include <string_view>
#include <vector>

namespace htloops {

/// how names of files of meshes end that are read here, ".off" first. Which ones there are depends
/// on the libraries of the build.
const std::vector<std::string>& endings_of_meshes();

/// the same for a sentence.
std::string words_of_mesh_endings();

/// whether the name of a file tells that it is a mesh; packed by gzip or not.
bool is_named_as_mesh(std::string_view file);

/// whether the name of a file ends as FreeSurfer calls its surfaces, `.white` say. They are known
/// by their content.
bool is_named_as_freesurfer(std::string_view file);

/// reads a mesh by the format that its name, or its content, tells, as `readers.h` says.
Soup read_soup(const Input_file& file);

} // namespace htloops

#endif // HTLOOPS_MESH_FORMATS_H
