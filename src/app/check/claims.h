// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CLAIMS_H
#define HTLOOPS_CLAIMS_H

#include "check/document_comparison.h"
#include "mend/mesh_reader.h"
#include "read/input_file.h"
#include "read/skeleton_reader.h"
#include "solve/answer.h"
#include "solve/progress.h"

#include <CGAL/Handle_tunnel_loops/Skeleton_certificate.h>

#include <string>
#include <vector>

namespace htloops {

/// What a file of loops says that is not so, the worst first, and what has not been looked at. The
/// rest means nothing if something is not so.
struct Checked_loops
{
  std::vector<std::string> problems;
  Certificate certificate;
  std::vector<std::size_t> components; ///< that the pairs are on
  bool is_boundary_of_solid = true;
  std::map<std::string, std::set<std::string>> not_compared;
};

/// proves again what can be proved of the loops in a file, and compares all else that it says with
/// what is so of these loops on this mesh. Measures, costs and bores are computed again, if the
/// file has some. Throws `Failure` if the file cannot be read.
Checked_loops check_loops(const Input_file& file, const Mended_mesh& mended, Progress& progress);

/// The same of a skeleton.
struct Checked_skeleton
{
  std::vector<std::string> problems;
  std::string taken_alone; ///< components that are no cavities of others, in lines
  Skeleton_lines lines;
  std::size_t genus = 0;
  std::map<std::string, std::set<std::string>> not_compared;
};

/// proves again what can be proved of the skeleton in a file, with loops that are found for this,
/// and compares all else that it says, if it is a document.
Checked_skeleton check_skeleton(const Input_file& file, const Mesh& mesh, Progress& progress);

} // namespace htloops

#endif // HTLOOPS_CLAIMS_H
