// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_GENERATORS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_GENERATORS_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

/// \file generators.h
/// Meshes to test and measure with: closed, oriented (out of the solid where the surface is
/// embedded), each edge in two triangles, each vertex in one fan, no two edges with the same two
/// vertices, and a genus that is known because the construction gives it.

namespace CGAL::Handle_tunnel_loops::generators {

/// A triangle mesh as points and indices.
struct Soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// What is wanted. The genus, summed over the components, is met exactly, the number of faces
/// within about 20% where the kind allows it; the same request gives the same mesh.
struct Request
{
  std::size_t faces = 10000;
  std::size_t genus = 1;
  unsigned seed = 0;
  // What few kinds look at, see `Kind::options`.
  std::size_t parts = 1;
  std::size_t p = 2, q = 3;
  std::size_t frequency = 3;
  std::size_t bridges = 5, tunnels = 5; ///< what they add to the genus is not counted in it
  std::size_t necks = 1;                ///< what joins two bodies, with a genus each
};

/// What a kind looks at besides the number of faces and the seed, as bits.
enum Request_option : unsigned {
  GENUS = 1,
  PARTS = 2,          ///< the number of components
  TORUS_KNOT = 4,     ///< `p` and `q`, how often a curve goes around a torus the long and short way
  WAVE_FREQUENCY = 8, ///< in waves per side of a box
  SMALL_BRIDGES = 16, ///< how many bridges and tunnels are on top of the genus
  NECKS = 32          ///< how many tubes join two bodies
};

/// A family of meshes.
struct Kind
{
  const char* name;
  const char* description; ///< what it looks like, and the requests that can be met

  /// makes the mesh; throws `std::invalid_argument` if the request cannot be met.
  std::function<Soup(const Request&)> make;

  unsigned options = GENUS; ///< of `Request_option`

  std::size_t default_faces = 10000; ///< for the tool; enough for the other defaults
  std::size_t default_genus = 1;     ///< for the tool
};

/// makes a mesh as `kind.make()` does, and throws at once if more is asked for of something that
/// the kind looks at than there are to be faces: such numbers are too large to compute with.
Soup make(const Kind& kind, const Request& request);

/// all families.
const std::vector<Kind>& kinds();

/// the mesh with its vertices and its triangles in random order.
Soup permute_vertices(const Soup& soup, unsigned seed);

/// one mesh of all the given ones, beside each other along the x axis.
Soup disjoint_union(const std::vector<Soup>& soups);

/// one mesh of all the given ones, where they are.
Soup joined(const std::vector<Soup>& soups);

/// the mesh moved by a vector.
Soup translated(Soup soup, const std::array<double, 3>& by);

/// the mesh with all triangles turned over.
Soup reversed(Soup soup);

/// the number of connected components, leaving out vertices without a triangle.
std::size_t number_of_components(const Soup& soup);

/// the number of boundary curves, none of which comes to a vertex twice.
std::size_t number_of_boundaries(const Soup& soup);

/// the genus of a surface, summed over its components.
std::size_t genus(const Soup& soup);

/// \f$ V - E + F \f$, counting the vertices that a triangle uses.
std::ptrdiff_t euler_characteristic(const Soup& soup);

// Surfaces with boundary: closed ones with holes.

/// Discs to be taken out of a closed surface, no two with a common vertex.
struct Hole_request
{
  std::size_t number = 0;
  std::size_t faces = 20; ///< of each, about: at least those around a vertex
  bool is_ragged = false; ///< with about as many boundary edges as faces; else they are round
  unsigned seed = 0;
};

/// the mesh without these discs, and without the vertices that are left alone. There are fewer
/// discs, or smaller ones, where there is no room for more.
Soup with_holes(const Soup& mesh, const Hole_request& holes);

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_GENERATORS_H
