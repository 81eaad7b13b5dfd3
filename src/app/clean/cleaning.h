// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CLEANING_H
#define HTLOOPS_CLEANING_H

#include "mend/mending.h"
#include "mesh_types.h"
#include "solve/changeable_mesh.h"
#include "solve/progress.h"
#include "solve/removal_solver.h"

#include <bitset>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

/// What is done to make a solid of a mesh, in this order.
enum class Clean_step : char {
  REPAIR,   ///< of the soup, with the remedies: triangles, an oriented manifold
  HOLES,    ///< boundary curves are closed
  ORIENT,   ///< parts are turned over that are inside out
  CHANNELS, ///< between an outer wall and an inner one are closed
  FLOATERS, ///< small parts that touch no other one go
  SHELLS,   ///< parts that lie inside of another one go
  HANDLES   ///< small ones are removed, if that is asked for
};

constexpr std::size_t number_of_clean_steps = 7;
using Clean_steps = std::bitset<number_of_clean_steps>;

/// what a step is called in options and files.
const char* name_of(Clean_step step);

struct Clean_options
{
  Clean_steps steps = Clean_steps(~0ull);
  /// around channels, at most; by default 3%, and only if the volume stays about the same
  std::optional<Relative_length> channel_length = std::nullopt;
  double floater_share = 2e-4;                               ///< of the volume; see `fates_of()`
  std::optional<std::size_t> genus = std::nullopt;           ///< that handles are removed down to
  std::optional<Relative_length> noise_below = std::nullopt; ///< handles this thin or narrow go
  bool is_sure = false;      ///< whatever handles go, and however the volume changes
  bool is_dry_run = false;   ///< nobody need be asked by `check_noise()`
  int number_of_threads = 0; ///< 0: as many as the machine has

  bool has(Clean_step step) const { return steps.test(static_cast<std::size_t>(step)); }
};

/// What a step did, and what it left that it might have done.
struct Clean_record
{
  Clean_step step;
  std::size_t count = 0; ///< of what it did
  std::vector<std::string> done = {}, left = {};
  std::size_t undecided = 0; ///< handles of which it is not known whether they were to be removed
};

/// What a mesh is.
struct Mesh_state
{
  std::size_t vertices = 0; ///< of faces
  std::size_t faces = 0;
  std::size_t parts = 0, boundaries = 0;
  std::size_t genus = 0; ///< summed over the parts
  std::size_t crossings = 0;
  double volume = 0.; ///< of the solid that it bounds, if it is closed
};

/// What became of a face.
enum class Face_fate : char { KEPT, REPLACED, FLOATER, SHELL };

/// A mesh that has been cleaned, by what it was before.
struct Cleaned_mesh : Changed_mesh
{
  std::vector<Clean_record> records; ///< of the steps that were to be done
  Mesh_state before, after;
  std::vector<Face_fate> fates;                 ///< of each face before
  std::vector<std::vector<Point>> closed_loops; ///< of channels and handles that were removed

  bool is_closed() const { return after.boundaries == 0 && after.faces > 0; }
};

/*!
Makes a closed solid of a mesh: see `Clean_step`. Points stay where they are. What would change the
volume of a piece much, and is not asked for, is left: see `Volume_change`. The result has no
crossing that the mesh did not have before. A boundary curve stays where no cap fits; then the
result is not closed, and says so. Takes three to five times as long as the loops of the mesh, more
where it crosses itself, and about 550 bytes a face.
*/
Cleaned_mesh clean(const Mesh& mesh, const Clean_options& options, Progress& progress);

} // namespace htloops

#endif // HTLOOPS_CLEANING_H
