// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_INPUT_FILE_H
#define HTLOOPS_INPUT_FILE_H

#include <string>

namespace htloops {

/// the whole content of a file; throws `Failure` if it cannot be read.
std::string read_whole_file(const std::string& file);

/// throws the `Failure` of a file whose content is wrong.
[[noreturn]] void fail_to_read(const std::string& file, const std::string& problem);

} // namespace htloops

#endif // HTLOOPS_INPUT_FILE_H
