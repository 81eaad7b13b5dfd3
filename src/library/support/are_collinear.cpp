// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/support/are_collinear.h>

#include <CGAL/Handle_tunnel_loops/internal/support/exact_vectors.h>

namespace CGAL::Handle_tunnel_loops::internal {

bool are_exactly_collinear(const Vector& a, const Vector& b, const Vector& c) {
  return is_zero(cross(exact(b) - exact(a), exact(c) - exact(a)));
}

} // namespace CGAL::Handle_tunnel_loops::internal
