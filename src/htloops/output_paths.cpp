// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "output_paths.h"

#include "atomic_file.h"
#include "failure.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace htloops {

void check_output_paths(const std::string& mesh_file, const std::vector<std::string>& targets) {
  for(auto target = targets.begin(); target != targets.end(); ++target) {
    std::error_code ignored; // of a file that does not exist
    if(std::filesystem::equivalent(*target, mesh_file, ignored))
      throw Failure(Exit_code::WRONG_USAGE, *target + " is the mesh; it is not overwritten");
    if(std::find(targets.begin(), target, *target) != target)
      throw Failure(Exit_code::WRONG_USAGE, *target + " is named for two outputs");
    check_writable(*target);
  }
}

} // namespace htloops
