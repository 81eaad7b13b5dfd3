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

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

Soup make_torus_link(const Request& request) {
  require_least_genus(request, "torus-link", 1);
  const Torus_knot knot(request.p, request.q);
  const std::size_t strands = request.genus;
  require_faces(request, "torus-link", 100 * (request.p + request.q) * strands);
  const double angle = knot.period() / strands;
  std::vector<Soup> tubes;
  for(std::size_t i = 0; i < strands; ++i)
    tubes.push_back(closed_tube(Curve_by_length([&](double t) { return knot.point(t, i * angle); }),
                                0.4 * knot.distance(angle), request.faces / strands));
  return joined(tubes);
}

} // namespace

const Kind torus_link_kind = {
    "torus-link",
    "tubes along parallel torus knots (p, q), one for each handle, each linked with all others if "
    "there are several; any genus g from 1, from 100 (p + q) g faces",
    make_torus_link, GENUS | TORUS_KNOT};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
