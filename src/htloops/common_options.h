// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_COMMON_OPTIONS_H
#define HTLOOPS_COMMON_OPTIONS_H

#include "picture_export.h"

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace htloops {

/// Options that several commands have.
void add_picture_options(CLI::App& command,
                         Picture_options& picture,
                         const std::string& what,
                         const std::string& group);

/// throws `Failure` if the picture is to be seen from no direction.
void check_picture_options(const Picture_options& picture);

void add_threads_option(CLI::App& command, int& number_of_threads, const std::string& group);

/// the vertex that a number stands for; throws `Failure` if there is none, or if it has no face.
Mesh::Vertex_index vertex_of_mesh(const Mesh& mesh, std::uint32_t number);

/// prints a text on the standard output, or, if that is taken, on the other one.
void show_text(const std::string& text, bool is_output_taken);

/// whether a direction is none.
bool is_zero(const std::vector<double>& direction);

} // namespace htloops

#endif // HTLOOPS_COMMON_OPTIONS_H
