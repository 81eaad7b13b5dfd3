// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SHELL_COMPLETION_H
#define HTLOOPS_SHELL_COMPLETION_H

#include "commands/command_line.h"

#include <string>
#include <vector>

namespace htloops {

/// bash, zsh and fish.
std::vector<std::string> known_shells();

/// a script that makes one of these shells complete the words of the tool: commands, options, and
/// values of options that are words of a list; elsewhere names of files.
std::string shell_completion(const std::string& shell, const Told_command& tool);

} // namespace htloops

#endif // HTLOOPS_SHELL_COMPLETION_H
