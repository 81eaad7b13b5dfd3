// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Torus_knot.h"
#include "closed_tube.h"
#include "kinds.h"
#include "request_checks.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

// A third of the room is for the tubes, and some of the rest for the difference to their chords.
constexpr double tube_part = 0.3, error_part = 0.15;

/// of one tube, so that it has rings enough to follow its curve; see `grid_size()`.
std::size_t least_faces(const Torus_knot& knot, double room, double length) {
  const auto rings = static_cast<double>(knot.least_samples(error_part * room));
  const double aspect = length / (2. * CGAL_PI * tube_part * room);
  return static_cast<std::size_t>((std::max)(6. * rings, 2. * rings * rings / aspect)) + 6;
}

Soup make_torus_link(const Request& request) {
  require_least_genus(request, "torus-link", 1);
  const Torus_knot knot(request.p, request.q);
  const std::size_t strands = request.genus;
  const double angle = knot.period() / strands, room = knot.distance(angle);
  std::vector<Soup> tubes;
  for(std::size_t i = 0; i < strands; ++i) {
    const Curve_by_length curve([&](double t) { return knot.point(t, i * angle); });
    if(i == 0)
      require_faces(request, "torus-link", strands * least_faces(knot, room, curve.length()));
    tubes.push_back(closed_tube(curve, tube_part * room, request.faces / strands));
  }
  return joined(tubes);
}

} // namespace

const Kind torus_link_kind = {
    "torus-link",
    "tubes along parallel torus knots (p, q), one for each handle, each linked with all others if "
    "there are several; any genus g from 1, from some hundred faces for each",
    make_torus_link, GENUS | TORUS_KNOT};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
