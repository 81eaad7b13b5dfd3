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

#include "commands/mesh_options.h"
#include "draw/picture_export.h"
#include "draw/view.h"

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace htloops {

/// Options that the commands have that compute something on a mesh.
struct Common_options : Mesh_options
{
  std::string json_file;
  std::vector<std::string> lines_files;
  Picture_options picture;
  std::string page_file;
  std::string gltf_file;
  View view;
  int number_of_threads = 0;
};

// Each declares some of them; `what` is "the loops", say.
void add_json_option(CLI::App& command,
                     Common_options& options,
                     const std::string& what,
                     const std::string& group);
void add_lines_option(CLI::App& command,
                      Common_options& options,
                      const std::string& what,
                      const std::string& group);
void add_picture_options(CLI::App& command,
                         Common_options& options,
                         const std::string& what,
                         const std::string& group,
                         bool has_words = true);
void add_page_option(CLI::App& command,
                     Common_options& options,
                     const std::string& what,
                     const std::string& group);
void add_gltf_option(CLI::App& command,
                     Common_options& options,
                     const std::string& what,
                     const std::string& group);
void add_view_options(CLI::App& command, Common_options& options, const std::string& group);
void add_threads_option(CLI::App& command, Common_options& options, const std::string& group);

/// throws `Failure` if there are lines in no known format, or if something is to be seen from no
/// direction.
void check_common_options(const Common_options& options);

/// throws `Failure` if the name of an output says that it is something else than it is: that is a
/// mistake.
void check_name(const std::string& file, const char* what, const char* end);

/// for `CLI::Option::check()`: empty for a number without a sign, else what is wrong. Without it -5
/// would be a very large one.
std::string why_no_count(const std::string& text);

/// the same for a finite number. A range lets pass what is not a number, as it is neither below nor
/// above.
std::string why_not_finite(const std::string& text);

/// the vertex that a number stands for; throws `Failure` if there is none, or if it has no face.
Mesh::Vertex_index vertex_of_mesh(const Mesh& mesh, std::uint32_t number);

/// prints a text on the standard output, or, if that is taken, on the other one.
void show_text(const std::string& text, bool is_output_taken);

/// whether a direction is none.
bool is_zero(const std::vector<double>& direction);

} // namespace htloops

#endif // HTLOOPS_COMMON_OPTIONS_H
