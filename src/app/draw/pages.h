// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PAGES_H
#define HTLOOPS_PAGES_H

#include "clean/cleaning.h"
#include "draw/lines.h"
#include "draw/view.h"
#include "mesh_types.h"
#include "solve/answer.h"
#include "solve/reeb_solver.h"
#include "solve/skeleton_solver.h"
#include "window/window.h"
#include "write/pair_listing.h"
#include "write/tables.h"

#include <string>
#include <vector>

namespace htloops {

void write_page(const std::string& file, const htl_window::Scene& scene);

/// what is shown in a page, for `write_page()`, in which a mesh can be turned, with the listed
/// pairs, and what was found at its boundary curves. `choice` is what stands before the numbers of
/// chosen pairs.
htl_window::Scene scene_of_loops(const View& view,
                                 const std::string& mesh_file,
                                 const Mesh& mesh,
                                 const Answer& answer,
                                 const Pair_listing& listing,
                                 const std::string& summary,
                                 const std::string& choice = "--pairs");

/// writes a page in which a mesh can be turned, with the parts that its arcs sweep, each with its
/// bone.
void write_reeb_page(const std::string& file,
                     const View& view,
                     const std::string& mesh_file,
                     const Mesh& mesh,
                     const Reeb_answer& answer,
                     const std::vector<Listed_arc>& arcs,
                     const std::string& summary);

/// writes a page in which a mesh can be turned with its curve skeleton, thin or as thick as it is.
void write_skeleton_page(const std::string& file,
                         const View& view,
                         const std::string& mesh_file,
                         const Mesh& mesh,
                         const Skeleton_answer& answer,
                         const std::string& summary);

/// writes a page in which a mesh can be turned with the lines along which it is cut.
void write_cut_page(const std::string& file,
                    const View& view,
                    const std::string& mesh_file,
                    const Mesh& mesh,
                    const Exported_lines& cut,
                    const std::string& summary);

/// What a page shows: a mesh, its loops, and what became of it.
struct Removal_shown
{
  const std::string& mesh_file;
  const Mesh& before;
  const Pairs& pairs;
  const Removal_report& report;
  const Mesh& after;
};

/// writes a page in which both meshes can be turned, with the loops of these pairs and what became
/// of each.
void write_removal_page(const std::string& file, const View& view, const Removal_shown& shown);

/// writes a page in which a mesh can be turned as it was before it was cleaned, with small parts
/// and shells in colours, and as it is afterwards, with what is new of it in another one; loops
/// show where channels were closed and handles removed.
void write_clean_page(const std::string& file,
                      const std::string& mesh_file,
                      const Mesh& before,
                      const Cleaned_mesh& cleaned,
                      const std::string& summary);

} // namespace htloops

#endif // HTLOOPS_PAGES_H
