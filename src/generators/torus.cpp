// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "grid_surface.h"
#include "kinds.h"
#include "request_checks.h"

#include <CGAL/number_type_config.h>

#include <cmath>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

Soup make_torus(const Request& request) {
  constexpr double radius = 1., tube_radius = 0.4;
  require_genus(request, "torus", 1);
  require_faces(request, "torus", 18);

  const Grid_size size = grid_size(request.faces, radius / tube_radius);
  return grid_surface(size, [&](std::size_t i, std::size_t j) {
    const double u = 2. * CGAL_PI * i / size.along, v = 2. * CGAL_PI * j / size.around;
    const double r = radius + tube_radius * std::cos(v);
    return Vector(r * std::cos(u), r * std::sin(u), tube_radius * std::sin(v));
  });
}

} // namespace

const Kind torus_kind = {"torus", "a torus, as a regular grid; genus 1, from 18 faces", make_torus};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
