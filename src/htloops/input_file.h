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

#include <cstdint>
#include <string>

namespace htloops {

/// the whole content of a file; throws `Failure` if it cannot be read.
std::string read_whole_file(const std::string& file);

/// the size of a file in bytes; throws `Failure` if it cannot be opened for reading.
std::uintmax_t size_of_file(const std::string& file);

/// the extension of a file name without its dot, in lower case.
std::string extension_of(const std::string& file);

} // namespace htloops

#endif // HTLOOPS_INPUT_FILE_H
