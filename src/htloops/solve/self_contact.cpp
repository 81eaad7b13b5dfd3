// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/self_contact.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/tags.h>

namespace htloops {

bool touches_itself(const Mesh& mesh) {
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Exact_kernel::Point_3> copy;
  CGAL::copy_face_graph(mesh, copy);
  return CGAL::Polygon_mesh_processing::does_self_intersect<CGAL::Parallel_if_available_tag>(copy);
}

} // namespace htloops
