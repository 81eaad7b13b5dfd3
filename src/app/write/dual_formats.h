// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_DUAL_FORMATS_H
#define HTLOOPS_DUAL_FORMATS_H

#include "mesh_types.h"
#include "solve/cut_solver.h"

#include <string>

namespace htloops {

/// throws `Failure` if the name of a file does not tell a format that dual cuts can be written in;
/// the standard output, and a name without an end, are JSON.
void check_dual_format(const std::string& file);

/// writes the cuts, in the format that the name of the file tells: as JSON, or with the mesh and in
/// the order of its edges, as lines. In MSH each cut is a group of lines, which repeat as often as
/// the cut runs along the edge; in VTP and VTU a line knows its cut and its jump.
void write_dual_cuts(const std::string& file, const Mesh& mesh, const Dual_cuts& cuts);

} // namespace htloops

#endif // HTLOOPS_DUAL_FORMATS_H
