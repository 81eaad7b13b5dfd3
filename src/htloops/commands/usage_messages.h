// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_USAGE_MESSAGES_H
#define HTLOOPS_USAGE_MESSAGES_H

#include <CLI/CLI.hpp>

#include <string>

namespace htloops {

/// the command that was begun, as far as its words were understood.
const CLI::App& begun_command(const CLI::App& app);

/// what is said of the name of a file that is taken for options.
std::string words_of_dash(const std::string& file);

/// what is said of a command line that is not understood: what is wrong with it, what may have been
/// meant, and which help tells more. For `CLI::App::failure_message()`.
std::string usage_message(const CLI::App* app, const CLI::Error& error);

} // namespace htloops

#endif // HTLOOPS_USAGE_MESSAGES_H
