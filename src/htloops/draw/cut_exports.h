// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CUT_EXPORTS_H
#define HTLOOPS_CUT_EXPORTS_H

#include "draw/exported_lines.h"
#include "generators/generators.h"

#include <string>
#include <vector>

namespace htloops {

/// throws `Failure` if the name of a file does not tell a format in which a vertex may have copies.
void check_opened_mesh_format(const std::string& file);

/// the mesh cut open along edges: a vertex has a copy for each side. The faces are in their order;
/// so are the vertices, each with its copies behind all others.
CGAL::Handle_tunnel_loops::generators::Soup opened_mesh(const Mesh& mesh,
                                                        const std::vector<Mesh::Edge_index>& cut);

/// the edges as lines, for a picture.
Exported_lines lines_of(const Mesh& mesh, const std::vector<Mesh::Edge_index>& cut);

/// throws `Failure` unless the name of a file ends in `.selection.txt`.
void check_selection_format(const std::string& file);

/// writes the edges as a selection of CGAL's programs: a line for vertices, one for faces, and one
/// of the two ends of each edge. `CGAL::Seam_mesh::add_seams()` reads it.
void export_selection(const std::string& file,
                      const Mesh& mesh,
                      const std::vector<Mesh::Edge_index>& cut);

} // namespace htloops

#endif // HTLOOPS_CUT_EXPORTS_H
