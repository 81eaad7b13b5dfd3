// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESHES_H
#define HTLOOPS_MESHES_H

#include "draw/lines.h"
#include "generators/generators.h"
#include "solve/cut_solver.h"
#include "solve/reeb_solver.h"

#include <cstdint>
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

/// dual cuts as walks along their edges, each in the color of the loop that its cut crosses.
Exported_lines lines_of(const Mesh& mesh, const Dual_cuts& duals);

/// writes the edges as a selection of CGAL's programs: a line for vertices, one for faces, and one
/// of the two ends of each edge. `CGAL::Seam_mesh::add_seams()` reads it.
void export_selection(const std::string& file,
                      const Mesh& mesh,
                      const std::vector<Mesh::Edge_index>& cut);

/// the arcs as lines, each in the colour that the vertices of the arc have in a coloured mesh.
Exported_lines lines_of(const Reeb_answer& answer);

/// throws `Failure` if the name of a file does not tell a format of graphs: .graphml or .dot.
void check_graph_format(const std::string& file);

/// writes the nodes and the arcs with what is known of them, in the format that the name tells.
void export_graph(const std::string& file, const Reeb_answer& answer);

/// writes the mesh as PLY, each vertex with the number and the colour of its arc.
void export_coloured_mesh(const std::string& file, const Mesh& mesh, const Reeb_answer& answer);

} // namespace htloops

#endif // HTLOOPS_MESHES_H
