// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SYSTEM_CONSOLE_H
#define HTLOOPS_SYSTEM_CONSOLE_H

#include <cstdio>
#include <string>
#include <vector>

namespace htloops {

/// whether a person looks at the stream.
bool is_terminal(std::FILE* stream);

/// sees to it that no file that is opened takes the place of a standard stream that is closed,
/// where it would get what is printed; and that what is printed is not changed on its way.
void prepare_standard_streams();

/// the words behind the name of the program, in UTF-8.
std::vector<std::string> words_of_command_line(int argc, char** argv);

} // namespace htloops

#endif // HTLOOPS_SYSTEM_CONSOLE_H
