// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LINE_FILES_H
#define HTLOOPS_LINE_FILES_H

#include "write/growing_file.h"
#include "write/rows.h"

#include <optional>
#include <set>
#include <string>

namespace htloops {

/// A file that tells of each mesh on a line or several, and of which meshes it has told. A mesh is
/// known by the text that stands for its name there.
struct Line_file
{
  Growing_file file;
  std::set<std::string> meshes = {};
};

/// What is told of meshes, one after the other: rows of CSV, objects of JSON, or both. Whatever
/// ends the program, the files have all of a mesh or nothing.
class Line_files
{
public:
  /// without a name there is no such file.
  Line_files(const std::string& csv_file, const std::string& jsonl_file, Row_kind kind);

  /// goes on with what the files have, after what was cut off. Throws `Failure` if they tell of
  /// something else.
  void resume();

  /// whether all is told of a mesh.
  bool has(const std::string& mesh_file) const;

  /// tells of a mesh where nothing is told of it.
  void add(const Mesh_line& line);

private:
  Row_kind kind_;
  std::optional<Line_file> rows_, objects_;
};

} // namespace htloops

#endif // HTLOOPS_LINE_FILES_H
