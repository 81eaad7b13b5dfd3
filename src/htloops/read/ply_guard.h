// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PLY_GUARD_H
#define HTLOOPS_PLY_GUARD_H

#include "read/input_file.h"

namespace htloops {

/// throws `Failure` if a file is no PLY file, ends before all is there that its header announces,
/// or declares what the reader of CGAL would misread without a word: types that PLY does not have,
/// vertices without coordinates. That reader also allocates whatever length a list claims to have.
void check_ply(const Input_file& file);

} // namespace htloops

#endif // HTLOOPS_PLY_GUARD_H
