// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_OUTPUT_PATHS_H
#define HTLOOPS_OUTPUT_PATHS_H

#include <string>
#include <vector>

namespace htloops {

/// throws `Failure` if one of the files that a command is to write cannot be written, is named
/// twice, or is the mesh that it reads: to be found out before the work, not after it.
void check_output_paths(const std::string& mesh_file, const std::vector<std::string>& targets);

} // namespace htloops

#endif // HTLOOPS_OUTPUT_PATHS_H
