// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Random.h"
#include "closed_tube.h"
#include "kinds.h"
#include "request_checks.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

/// One ring of a chain along the x axis: an ellipse whose plane contains the axis and is about
/// upright to those of its neighbours. Rings of these sizes pass through the next and touch none.
Curve_by_length ring_curve(std::size_t number, Random& random) {
  constexpr double distance = 1.4, most_tilt = CGAL_PI / 12.;
  const double half_width = random.uniform(0.9, 1.25);
  const double angle = (number % 2) * CGAL_PI / 2. + random.uniform(-most_tilt, most_tilt);
  const Vector centre(distance * number, 0, 0), across(0, std::cos(angle), std::sin(angle));
  return Curve_by_length([=](double t) {
    return centre + std::cos(t) * Vector(1, 0, 0) + half_width * std::sin(t) * across;
  });
}

Soup make_chain(const Request& request) {
  require_least_genus(request, "chain", 1);
  require_faces(request, "chain", 72 * request.genus);
  Random random(request.seed);
  std::vector<Soup> rings;
  for(std::size_t i = 0; i < request.genus; ++i) {
    const Curve_by_length curve = ring_curve(i, random);
    rings.push_back(closed_tube(curve, random.uniform(0.1, 0.25), request.faces / request.genus));
  }
  return joined(rings);
}

} // namespace

const Kind chain_kind = {
    "chain",
    "rings, each linked with the next, one for each handle; any genus g from 1, from 72 g faces",
    make_chain};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
