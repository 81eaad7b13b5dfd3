// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Grid_graph.h"
#include "Random.h"
#include "Tubes.h"
#include "kinds.h"
#include "mesh_of_field.h"
#include "request_checks.h"

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

/// tubes along the edges of a grid, moved by the same distance along all axes.
Soup make_grid(double moved, const Request& request, Random& random) {
  constexpr double jitter = 0.05, radius = 0.14;
  auto segments = Grid_graph(request.genus, random, jitter).segments();
  for(auto& [a, b] : segments) {
    a += Vector(moved, moved, moved);
    b += Vector(moved, moved, moved);
  }
  return mesh_of_field(Tubes(segments, radius), request, "interlaced");
}

Soup make_interlaced(const Request& request) {
  require_faces(request, "interlaced", 1000 + 400 * request.genus);
  Random random(request.seed);
  const std::size_t genus = request.genus / 2, faces = request.faces / 2;
  const Soup first = make_grid(0., {request.faces - faces, request.genus - genus}, random);
  return joined({first, make_grid(0.5, {faces, genus}, random)});
}

} // namespace

const Kind interlaced_kind = {
    "interlaced",
    "two grids of tubes, each through the holes of the other; any genus g, half of it each, from "
    "1000 + 400 g faces",
    make_interlaced};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
