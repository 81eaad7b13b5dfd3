// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_EXACT_POINT_H
#define HTLOOPS_EXACT_POINT_H

#include "mesh_types.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace htloops {

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_point = Exact::Point_3;

inline Exact_point exact_point(const Point& p) { return {p.x(), p.y(), p.z()}; }

} // namespace htloops

#endif // HTLOOPS_EXACT_POINT_H
