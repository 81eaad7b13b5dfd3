// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REEB_EXPORTS_H
#define HTLOOPS_REEB_EXPORTS_H

#include "draw/exported_lines.h"
#include "solve/reeb_answer.h"

#include <string>
#include <vector>

namespace htloops {

/// the arcs as lines, each in the colour that the vertices of the arc have in a coloured mesh.
Exported_lines lines_of(const Reeb_answer& answer);

/// throws `Failure` if the name of a file does not tell a format of graphs: .graphml or .dot.
void check_graph_format(const std::string& file);

/// writes the nodes and the arcs with what is known of them, in the format that the name tells.
void export_graph(const std::string& file, const Reeb_answer& answer);

/// throws `Failure` if the name of a file does not end in .ply.
void check_coloured_mesh_format(const std::string& file);

/// writes the mesh as PLY, each vertex with the number and the colour of its arc.
void export_coloured_mesh(const std::string& file, const Mesh& mesh, const Reeb_answer& answer);

} // namespace htloops

#endif // HTLOOPS_REEB_EXPORTS_H
