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

Soup make_lattice(const Request& request) {
  require_faces(request, "lattice", 400 + 250 * request.genus);
  Random random(request.seed);
  return mesh_of_field(Tubes(Grid_graph(request.genus, random).segments()), request, "lattice");
}

} // namespace

const Kind lattice_kind = {
    "lattice",
    "tubes along the edges of a cubic grid, some of them left out at random; any genus g, from "
    "400 + 250 g faces",
    make_lattice};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
