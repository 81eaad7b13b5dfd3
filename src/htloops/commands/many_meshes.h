// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MANY_MESHES_H
#define HTLOOPS_MANY_MESHES_H

#include "commands/loops_options.h"

namespace htloops {

/// finds the loops of meshes, several at once if that is asked for, and tells of each on a line of
/// its own, in the order in which they were given. Goes on after one that fails; throws `Failure`
/// with the exit code of the first such in the end.
void run_on_many_meshes(const Loops_options& options);

} // namespace htloops

#endif // HTLOOPS_MANY_MESHES_H
