// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FILE_OPTIONS_H
#define HTLOOPS_FILE_OPTIONS_H

namespace CLI {
class App;
}

namespace htloops {

// The type, for `CLI::Option::type_name()`, of every option or argument that names a file.
constexpr char input_file[] = "input file";
constexpr char output_file[] = "output file";

/// throws `Failure` if an output of the commands that were asked for cannot be written, or would
/// overwrite an input or another output.
void check_files(const CLI::App& app);

} // namespace htloops

#endif // HTLOOPS_FILE_OPTIONS_H
