// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LOOPS_FILE_H
#define HTLOOPS_LOOPS_FILE_H

#include "app/mesh_types.h"
#include "app/read/loops_reader.h"

#include <string>
#include <vector>

namespace htloops {

/// the lines, indented, each after a line break; not too many of them.
std::string indented(const std::vector<std::string>& lines);

/// throws the `Failure` of a file of loops if there are problems.
void require_none(const std::string& loops_file, const std::vector<std::string>& problems);

/// reads loops that lie on the mesh; throws `Failure` with all that speaks against it.
Bound_loops read_loops_on(const Mesh& mesh, const std::string& loops_file);

} // namespace htloops

#endif // HTLOOPS_LOOPS_FILE_H
