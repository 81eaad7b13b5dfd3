// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "kinds.h"

#include "Shape.h"

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = [] {
    std::vector<Kind> kinds = {sphere_kind,  torus_kind,  knot_kind,       multi_torus_kind,
                               lattice_kind, gyroid_kind, sponge_kind,     plates_kind,
                               bars_kind,    chain_kind,  torus_link_kind, ladder_kind,
                               shell_kind,   foam_kind,   interlaced_kind, waves_kind,
                               scan_kind,    twins_kind,  hollow_kind,     random_kind};
    const std::vector<Kind> shapes = kinds_of_shapes();
    kinds.insert(kinds.end(), shapes.begin(), shapes.end());
    return kinds;
  }();
  return all;
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
