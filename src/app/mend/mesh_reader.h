// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESH_READER_H
#define HTLOOPS_MESH_READER_H

#include "mend/mending.h"
#include "mesh_types.h"
#include "read/input_file.h"
#include "read/soup_diagnosis.h"

#include <cstdint>
#include <string>
#include <vector>

namespace htloops {

/// reads a mesh. Where a format parts vertices, as glTF does where normals differ, those at the
/// same place along open edges become one, and points that no face has are left out.
Soup read_whole_soup(const Input_file& file);

/// A mesh that was read, and what has been done to it.
struct Mended_mesh
{
  Mesh mesh;
  std::vector<Change> changes;
  std::vector<std::uint32_t> origins; ///< of each vertex that is not in the file, one that is
  Face_cuts cuts;
  File_facts facts;
};

/// reads a mesh and applies remedies; its vertices keep the numbers that they have in the file, new
/// ones come after them. Throws `Failure` if the file cannot be read, or with all that is wrong
/// with the mesh and the option that helps.
Mended_mesh read_mesh(Input_file file, const Remedies& remedies);

/// the same of a mesh that is to be fit as it is.
Mesh read_mesh(Input_file file);

/// which options would make a refused soup fit, found out by trying: "--repair fixes this"; or that
/// none would. `given` are the remedies that have been applied to no avail.
std::string
words_on_remedy(const Soup& soup, const std::vector<Defect>& defects, const Remedies& given);

} // namespace htloops

#endif // HTLOOPS_MESH_READER_H
