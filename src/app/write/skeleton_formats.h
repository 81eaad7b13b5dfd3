// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SKELETON_FORMATS_H
#define HTLOOPS_SKELETON_FORMATS_H

#include "solve/skeleton_solver.h"
#include "write/files.h"

#include <string>

namespace htloops {

// Curve skeletons in formats of other programs. Coordinates and radii read back as exactly
// themselves, and points keep their numbers, but for SWC.

/// writes trees, as neurons are kept: each cycle is cut at a point that is there twice, with the
/// same coordinates. The copy is of a type of its own, and a comment names both.
void write_swc(Text_writer& out, const Skeleton_answer& answer);

/// writes a VTK PolyData with a line for each arc, as centre lines of vessels are kept.
void write_skeleton_vtp(Text_writer& out, const Skeleton_answer& answer, bool is_binary);

/// writes points, and a line for each arc.
void write_skeleton_obj(Text_writer& out, const Skeleton_answer& answer);

/// throws `Failure` if the name of a file does not tell a format of graphs: .graphml or .dot.
void check_skeleton_graph_format(const std::string& file);

/// writes points and edges with what is known of them, in the format that the name tells.
void write_skeleton_graph(const std::string& file, const Skeleton_answer& answer);

} // namespace htloops

#endif // HTLOOPS_SKELETON_FORMATS_H
