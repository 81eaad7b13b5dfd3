// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "closed_tube.h"
#include "kinds.h"
#include "request_checks.h"

#include <cmath>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

Vector trefoil(double t) {
  return Vector(std::sin(t) + 2. * std::sin(2. * t), std::cos(t) - 2. * std::cos(2. * t),
                -std::sin(3. * t));
}

Soup make_knot(const Request& request) {
  constexpr double tube_radius = 0.45;
  require_genus(request, "knot", 1);
  require_faces(request, "knot", 150);
  return closed_tube(Curve_by_length(trefoil), tube_radius, request.faces);
}

} // namespace

const Kind knot_kind = {"knot", "a tube around a trefoil knot; genus 1, from 150 faces", make_knot};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
