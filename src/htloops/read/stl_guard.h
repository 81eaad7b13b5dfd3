// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_STL_GUARD_H
#define HTLOOPS_STL_GUARD_H

#include "read/input_file.h"

namespace htloops {

/// throws `Failure` where the reader of CGAL would accept an STL file wrongly: it takes a file that
/// ends in the header for an empty one, and merges points with coordinates that are no numbers
/// with any other.
void check_stl(const Input_file& file);

} // namespace htloops

#endif // HTLOOPS_STL_GUARD_H
