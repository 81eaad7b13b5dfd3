// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/mesh_options.h"

#include "commands/file_options.h"
#include "failure.h"
#include "write/change_table.h"
#include "write/mesh_writer.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <utility>

namespace htloops {

void add_mesh_argument(CLI::App& command, Mesh_options& options, const std::string& what) {
  command.add_option("MESH", options.mesh_file, what)
      ->option_text(" ")
      ->type_name(input_file)
      ->required();
  add_format_option(command, options);
}

void add_format_option(CLI::App& command, Mesh_options& options) {
  command
      .add_option("--format", options.format,
                  "off, obj, ply or stl, whatever the name of the mesh says; for - as a mesh,\n"
                  "which is the standard input")
      ->option_text("FORMAT")
      ->check(CLI::IsMember({"off", "obj", "ply", "stl"}))
      ->group("What to read");
}

void add_remedy_options(CLI::App& command, Mesh_options& options) {
  const char group[] = "If the mesh is not fit as it is";
  command
      .add_flag("--triangulate", options.remedies.do_triangulate,
                "make triangles of faces with more corners")
      ->group(group);
  command
      .add_flag("--repair", options.remedies.do_repair,
                "weld points, drop degenerate and duplicate faces, split edges and\n"
                "vertices with too many faces, turn faces over; says what it did")
      ->group(group);
  command
      .add_option("--write-mesh", options.written_mesh_file,
                  "the mesh as it is then, which the answer is about: .off .obj .ply .stl")
      ->option_text("FILE")
      ->type_name(output_file)
      ->group(group);
}

void check_mesh_options(const Mesh_options& options) {
  if(!options.written_mesh_file.empty())
    check_mesh_format(options.written_mesh_file);
}

Input_file input_of(const Mesh_options& options) {
  if(options.mesh_file == "-" && options.format.empty())
    throw Failure(Exit_code::WRONG_USAGE,
                  "the standard input has no name that tells its format: --format says it");
  return Input_file(options.mesh_file, options.format);
}

Mended_mesh read_mended_mesh(const Mesh_options& options, const Input_file& file) {
  Mended_mesh mended = read_mesh(file, options.remedies);
  if(options.remedies.any() && !options.is_quiet)
    std::fputs(table_of_changes(file.name(), mended.changes).c_str(), stderr);
  return mended;
}

Mesh read_mesh(const Mesh_options& options) {
  return std::move(read_mended_mesh(options, input_of(options)).mesh);
}

void write_read_mesh(const Mesh_options& options, const Mesh& mesh) {
  if(!options.written_mesh_file.empty())
    write_mesh(options.written_mesh_file, mesh);
}

} // namespace htloops
