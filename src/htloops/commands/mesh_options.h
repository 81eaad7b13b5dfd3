// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESH_OPTIONS_H
#define HTLOOPS_MESH_OPTIONS_H

#include "mend/mesh_reader.h"

#include <string>

namespace CLI {
class App;
}

namespace htloops {

/// Options of all commands that read a mesh.
struct Mesh_options
{
  std::string mesh_file;
  std::string format; ///< of the file; empty if its name tells
  Remedies remedies;
  std::string written_mesh_file;
  bool is_quiet = false;

  bool is_mesh_on_standard_output() const { return written_mesh_file == "-"; }
};

/// What the mesh of most commands is.
constexpr char mesh_kinds[] = "triangle mesh: .off .obj .ply .stl";

/// declares the mesh, which comes first, `what` it is.
void add_mesh_argument(CLI::App& command, Mesh_options& options, const std::string& what);

/// declares how its format is told if its name does not.
void add_format_option(CLI::App& command, Mesh_options& options);

/// declares what may be done to it.
void add_remedy_options(CLI::App& command, Mesh_options& options);

/// throws `Failure` if the mesh is to be written in no known format.
void check_mesh_options(const Mesh_options& options);

/// the file that has the mesh; throws `Failure` if it cannot be read.
Input_file input_of(const Mesh_options& options);

/// reads the mesh and, unless it is to be quiet, says what has been done to it.
Mended_mesh read_mended_mesh(const Mesh_options& options, const Input_file& file);
Mesh read_mesh(const Mesh_options& options);

/// writes the mesh that was read if that is asked for.
void write_read_mesh(const Mesh_options& options, const Mesh& mesh);

} // namespace htloops

#endif // HTLOOPS_MESH_OPTIONS_H
