// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_NON_FINITE_POINTS_H
#define HTLOOPS_NON_FINITE_POINTS_H

#include "read/input_file.h"

#include <string>

namespace htloops {

/// throws the `Failure` of a mesh with a vertex, or a face, that has such a coordinate.
[[noreturn]] void fail_with_non_finite(const Input_file& file, const std::string& element);

/// looks for the first coordinate that is infinite or not a number, and throws that `Failure`, in a
/// file of text that CGAL could not read: it knows no such numbers, and so does not tell them from
/// what is no number at all. Knows OBJ, PLY, STL and TS.
void check_points_are_finite(const Input_file& file, const std::string& extension);

} // namespace htloops

#endif // HTLOOPS_NON_FINITE_POINTS_H
