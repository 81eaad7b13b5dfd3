// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SKELETONS_H
#define HTLOOPS_SKELETONS_H

#include "draw/lines.h"
#include "draw/surfaces.h"
#include "solve/reeb_solver.h"
#include "solve/skeleton_solver.h"
#include "write/documents.h"

#include <string>
#include <vector>

namespace htloops {

/// A kind of what is drawn of a skeleton.
struct Bone_kind
{
  const char* one;
  const char* many;
  Colour colour;
  double width; ///< as a multiple of that of an arc
};

/// by `Exported_line::kind_number`. People who do not see all colours tell these apart (Okabe and
/// Ito).
constexpr Bone_kind bone_kinds[] = {{"arc on cycles", "arcs on cycles", {200, 76, 0}, 1.5},
                                    {"other arc", "other arcs", {24, 62, 120}, 1.5},
                                    {"joint", "joints", {35, 35, 40}, 3.2},
                                    {"end", "ends", {90, 130, 185}, 2.3},
                                    {"inlet", "inlets", {0, 145, 105}, 3.}};

/// the arcs as lines.
Exported_lines lines_of(const Skeleton_answer& answer);

/// what is drawn of a skeleton: its arcs in the colours of two kinds, those on cycles and others,
/// with the radii of their points if they are to be `as_thick` as these say; and joints, ends and
/// inlets as balls.
Exported_lines bones_of(const Skeleton_answer& answer, bool as_thick);

/// the same of a Reeb graph: saddles are joints, extrema are ends.
Exported_lines bones_of(const Mesh& mesh, const Reeb_answer& answer, bool as_thick);

/// The surface around a skeleton in parts, one for each arc.
struct Skeleton_surface
{
  Arc_surface surface;
  std::vector<Colour> colours; ///< by part
};

Skeleton_surface skeleton_surface(const Mesh& mesh, const Skeleton_answer& answer);

/// throws `Failure` if the name of a file does not tell a format that a skeleton can be written in
/// as lines: one of those that have radii (.swc .vtp), or .obj .ply .polylines.txt.
void check_skeleton_lines_format(const std::string& file);

/// writes the arcs, in the format that the name of the file tells.
void export_skeleton_lines(const std::string& file, const Skeleton_answer& answer);

/// writes a skeleton in any of these formats, or as a graph, a table or JSON, as the name tells.
void save_skeleton(const std::string& file, const Skeleton_answer& answer, const Run_record& run);

/// writes the mesh as PLY, each vertex with the number and the tint of its arc, and the number of
/// the point of the skeleton that it belongs to.
void export_coloured_mesh(const std::string& file, const Mesh& mesh, const Skeleton_answer& answer);

} // namespace htloops

#endif // HTLOOPS_SKELETONS_H
