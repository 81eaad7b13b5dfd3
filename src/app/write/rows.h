// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_ROWS_H
#define HTLOOPS_ROWS_H

#include "mesh_types.h"
#include "solve/answer.h"
#include "write/files.h"
#include "write/pair_listing.h"

#include <cstddef>
#include <string>
#include <vector>

namespace htloops {

/// Writes a header and a row for each listed pair, as RFC 4180 has it: the mesh, the number, the
/// lengths, the side on which each loop bounds, and where the shorter loop is. Numbers read back
/// exactly.
class Pair_csv_writer
{
public:
  explicit Pair_csv_writer(const std::string& target);

  void add(const std::string& mesh_file, const Answer& answer, const Pair_listing& listing);
  void finish() { out_.finish(); }

private:
  Text_writer out_;
};

/// writes the pairs of one mesh.
void write_pair_csv(const std::string& target,
                    const std::string& mesh_file,
                    const Answer& answer,
                    const Pair_listing& listing);

/// What is told of one mesh of several.
struct Mesh_line
{
  std::string mesh_file;
  int exit_code = 0; ///< what follows is known if it is 0
  std::string error; ///< in words; empty if there is none
  std::size_t number_of_vertices = 0, number_of_faces = 0;
  double read_seconds = 0.;
  Answer answer;
  Pair_listing listing;
};

Mesh_line answered_line(const std::string& mesh_file,
                        const Mesh& mesh,
                        double read_seconds,
                        Answer answer,
                        Pair_listing listing);
Mesh_line failed_line(const std::string& mesh_file, int exit_code, const std::string& error);

/// A file with an object of JSON on each line, one for each mesh. On the standard output each is
/// there at once.
class Mesh_lines_writer
{
public:
  explicit Mesh_lines_writer(const std::string& target)
      : out_(target) {}

  void add(const Mesh_line& line);
  void finish() { out_.finish(); }

private:
  Text_writer out_;
};

/// the names of the columns of the rows that follow, for a person.
std::string header_of_lines(const std::vector<std::string>& mesh_files);

/// a row for a mesh; as wide as the names of the files want it.
std::string row_of(const Mesh_line& line, const std::vector<std::string>& mesh_files);

} // namespace htloops

#endif // HTLOOPS_ROWS_H
