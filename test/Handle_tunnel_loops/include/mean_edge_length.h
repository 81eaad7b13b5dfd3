// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_TEST_MEAN_EDGE_LENGTH_H
#define HTL_TEST_MEAN_EDGE_LENGTH_H

#include <CGAL/squared_distance_3.h>

#include <cmath>

/// of a `CGAL::Surface_mesh`.
template <typename Mesh> double mean_edge_length(const Mesh& mesh) {
  double sum = 0.;
  for(const auto e : mesh.edges())
    sum += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / static_cast<double>(mesh.number_of_edges());
}

#endif // HTL_TEST_MEAN_EDGE_LENGTH_H
