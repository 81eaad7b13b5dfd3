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

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

Soup make_foam(const Request& request) {
  constexpr double jitter = 0.22, least_radius = 0.1, most_radius = 0.2;
  require_faces(request, "foam", 600 + 600 * request.genus);
  Random random(request.seed);
  const auto segments = Grid_graph(request.genus, random, jitter).segments();
  std::vector<double> radii;
  for(std::size_t i = 0; i < segments.size(); ++i)
    radii.push_back(random.uniform(least_radius, most_radius));
  return mesh_of_field(Tubes(segments, radii), request, "foam");
}

} // namespace

const Kind foam_kind = {
    "foam",
    "struts of random radii along the edges of a grid whose nodes are moved at random; any genus "
    "g, from 600 + 600 g faces",
    make_foam};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
