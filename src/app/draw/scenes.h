// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SCENES_H
#define HTLOOPS_SCENES_H

#include "Unit.h"
#include "clean/cleaning.h"
#include "draw/layers.h"
#include "draw/lines.h"
#include "draw/view.h"
#include "mesh_types.h"
#include "scene/scene.h"
#include "solve/answer.h"
#include "solve/reeb_solver.h"
#include "solve/removal_solver.h"
#include "solve/skeleton_solver.h"
#include "write/pair_listing.h"
#include "write/tables.h"

#include <array>
#include <string>
#include <vector>

namespace htloops {

// What is looked at in a page, and in a picture. The file of the mesh names it; a summary is told
// beside it.

/// What stands before the numbers of chosen pairs, and behind them, so that it is a command.
using Choice = std::array<std::string, 2>;

/// a mesh with the listed pairs, or the throats if they were asked for, and what was found at its
/// boundary curves.
htl_scene::Scene scene_of_loops(const View& view,
                                const std::string& mesh_file,
                                const Mesh& mesh,
                                const Answer& answer,
                                const Pair_listing& listing,
                                const std::string& summary,
                                const Choice& choice = {"--pairs ", ""});

/// a mesh with its layers at a moment.
htl_scene::Scene
scene_of_layers(const View& view, const std::string& mesh_file, const Grown_layers& layers);

/// a mesh in the parts that the arcs of its Reeb graph sweep, with the graph.
htl_scene::Scene scene_of_reeb_graph(const View& view,
                                     const std::string& mesh_file,
                                     const Mesh& mesh,
                                     const Reeb_answer& answer,
                                     const std::vector<Listed_arc>& arcs,
                                     const std::string& summary);

/// a mesh in the parts of the arcs of its curve skeleton, with the skeleton.
htl_scene::Scene scene_of_skeleton(const View& view,
                                   const std::string& mesh_file,
                                   const Mesh& mesh,
                                   const Skeleton_answer& answer,
                                   const std::string& summary);

/// a mesh with the edges along which it is cut to disks.
htl_scene::Scene scene_of_cut(const View& view,
                              const std::string& mesh_file,
                              const Mesh& mesh,
                              const Exported_lines& cut,
                              const std::string& summary);

/// a mesh with its dual cuts, each in the color of the loop that it crosses.
htl_scene::Scene scene_of_dual_cuts(const View& view,
                                    const std::string& mesh_file,
                                    const Mesh& mesh,
                                    const Exported_lines& cuts,
                                    const std::string& summary);

/// A mesh, its loops, and what became of it.
struct Removal_shown
{
  const std::string& mesh_file;
  const Choice& choice;
  const Mesh& before;
  const Pairs& pairs;
  const Pair_listing& listing; ///< of those that were to be removed, in the order of the rows
  const Removal_answer& removal;
  const std::string& summary;
  bool is_dry_run = false;
  Unit unit = Unit::NONE;
};

/// both meshes, the caps of the second one in a colour of their own, with the loops of the listed
/// pairs and what became of each. Loops that are still there are seen on both.
htl_scene::Scene scene_of_removal(const View& view, const Removal_shown& shown);

/// a mesh as it was before it was cleaned, with small parts and shells in colours, and as it is
/// afterwards, with what is new of it in another one; loops show where channels were closed and
/// handles removed.
htl_scene::Scene scene_of_cleaning(const std::string& mesh_file,
                                   const Mesh& before,
                                   const Cleaned_mesh& cleaned,
                                   const std::string& summary);

} // namespace htloops

#endif // HTLOOPS_SCENES_H
