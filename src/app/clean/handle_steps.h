// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_HANDLE_STEPS_H
#define HTLOOPS_HANDLE_STEPS_H

#include "clean/cleaning.h"
#include "mesh_types.h"
#include "solve/progress.h"
#include "solve/removal_solver.h"

#include <optional>

namespace htloops {

/// What came of a step that needs loops.
struct Handle_step
{
  Clean_record record;
  std::optional<Removal_answer> answer = std::nullopt; ///< if the mesh is another one now
};

/// closes channels up to a length around, if that is asked for or no large hollow is filled. If
/// there are none, a wider limit is tried, and told.
Handle_step close_channels(
    const Mesh& mesh, const Pairs& pairs, double most, const Clean_options& options, Progress&);

/// removes handles down to a genus, or those of which the thickness or the clear width is less than
/// a length, where percentages are of the given diagonal; if neither is asked for, tells how many
/// there are.
Handle_step remove_small_handles(const Mesh& mesh,
                                 const Pairs& pairs,
                                 double diagonal,
                                 const Clean_options& options,
                                 Progress& progress);

} // namespace htloops

#endif // HTLOOPS_HANDLE_STEPS_H
