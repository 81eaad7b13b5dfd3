// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_ENCODE_SURFACE_H
#define HTL_WINDOW_ENCODE_SURFACE_H

#include "Grid.h"
#include "Streams.h"

#include <cstddef>

namespace htl_window {

/*!
A surface for a page. Vertices are numbered as they are met: the first is that of the first
triangle; then, for each vertex in the order of the numbers, the triangles around it that were not
there yet, and so the vertices that these name for the first time. If no vertex is left, the next
is one of another piece. There are these streams:

- for each vertex, how many triangles are new at it;
- for each of these its second and third corner: 0 for a vertex that is new, else by how much its
  number is less than that of the next new one;
- three streams of places, each as the difference to the corner before;
- if there are parts, for each triangle by how much its part differs from that of the one before.

Numbers are small that way: a million triangles are about four million bytes. Vertices without
triangles are left out.
*/
struct Encoded_surface
{
  std::size_t number_of_vertices;
  Packed streams;
};

Encoded_surface encode_surface(const Surface& surface, const Grid& grid);

} // namespace htl_window

#endif // HTL_WINDOW_ENCODE_SURFACE_H
