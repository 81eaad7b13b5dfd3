// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_BORED_BOX_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_BORED_BOX_H

#include "Field.h"
#include "Random.h"
#include "generators.h"

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// A straight hole through a box: a convex polygon inscribed in an ellipse, along an axis.
struct Bore
{
  int axis;
  Vector centre, half_size; ///< along the other two axes
  std::size_t corners;
  double phase; ///< an angle
};

/// How the faces of a box with bores are cut into triangles.
enum class Cut {
  DELAUNAY, ///< as even as they can be without further vertices
  ANY       ///< as vertices and constraints come, with slivers, as some programs export parts
};

/// the surface of a box from the origin to a corner, with bores that keep away from each other. It
/// has no more vertices than the corners of the box and the polygons: its faces are constrained
/// triangulations, and the walls of the bores have two triangles for each side.
Soup bored_box(const Vector& size, const std::vector<Bore>& bores, Cut cut);

/// one or the other.
inline Cut random_cut(Random& random) { return random.below(2) == 0 ? Cut::DELAUNAY : Cut::ANY; }

/// the number of faces of boxes with bores that have a number of corners, all together.
inline std::size_t faces_of_bored_boxes(std::size_t boxes, std::size_t bores, std::size_t corners) {
  return 12 * boxes + 4 * (bores + corners);
}

/// numbers of corners of bores, three or more, that make up for a number of faces.
std::vector<std::size_t>
choose_corners(std::size_t boxes, std::size_t bores, std::size_t faces, Random& random);

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_BORED_BOX_H
