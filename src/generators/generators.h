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

/// While an object lives, what makes or examines a mesh in this thread calls a function now and
/// then, with about the number of faces that the mesh has so far. The function may throw.
class Watch_guard
{
public:
  using Look = std::function<void(std::size_t)>;

  explicit Watch_guard(Look look);
  ~Watch_guard();
  Watch_guard(const Watch_guard&) = delete;
  Watch_guard& operator=(const Watch_guard&) = delete;

private:
  const Look look_;
  const Look* const previous_;
};

/// calls that function, if there is one.
void look_at(const Soup& soup);

/// the same after every so many steps.
inline void look_at(const Soup& soup, std::size_t step) {
  constexpr std::size_t steps_between = std::size_t(1) << 16;
  if(step % steps_between == 0)
    look_at(soup);
}

/// A request. The genus, summed over the components, is exact; the number of faces is within about
/// 20% where the kind allows it. The same request gives the same mesh.
struct Request
{
  std::size_t faces = 10000;
  std::size_t genus = 1;
  unsigned seed = 0;
  // Used by few kinds, see `Kind::options`.
  std::size_t parts = 1;
  std::size_t p = 2, q = 3;
  std::size_t frequency = 3;
  std::size_t bridges = 5, tunnels = 5; ///< not counted in the genus
  std::size_t necks = 1;                ///< between two bodies with this genus each
};

/// The options of a kind besides the number of faces and the seed, as bits.
enum Request_option : unsigned {
  GENUS = 1,
  PARTS = 2,          ///< the number of components
  TORUS_KNOT = 4,     ///< `p` and `q`: turns of a curve around a torus, the long and the short way
  WAVE_FREQUENCY = 8, ///< in waves per side of a box
  SMALL_BRIDGES = 16, ///< the numbers of bridges and tunnels, added to the genus
  NECKS = 32          ///< the number of tubes that join two bodies
};

/// A family of meshes.
struct Kind
{
  const char* name;
  const char* description; ///< the shape, and the possible requests

  /// makes the mesh; throws `std::invalid_argument` if the request cannot be met.
  std::function<Soup(const Request&)> make;

  unsigned options = GENUS; ///< of `Request_option`

  std::size_t default_faces = 10000; ///< for the tool; enough for the other defaults
  std::size_t default_genus = 1;     ///< for the tool
};

/// makes a mesh as `kind.make()` does, but throws at once if a number that the kind uses is larger
/// than the number of faces, and not small: such numbers could overflow.
Soup make(const Kind& kind, const Request& request);

/// all families.
const std::vector<Kind>& kinds();

/// the mesh with its vertices and its triangles in random order.
Soup permute_vertices(const Soup& soup, unsigned seed);

/// one mesh of all given meshes, side by side along the x axis.
Soup disjoint_union(const std::vector<Soup>& soups);

/// one mesh of all given meshes, in place.
Soup joined(const std::vector<Soup>& soups);

/// the mesh moved by a vector.
Soup translated(Soup soup, const std::array<double, 3>& by);

/// the mesh turned about the origin, so that no axis of it is along one of the coordinates.
Soup askew(Soup soup);

/// the mesh with all triangles turned over.
Soup reversed(Soup soup);

/// the number of connected components; vertices without a triangle do not count.
std::size_t number_of_components(const Soup& soup);

/// the number of boundary curves; none may pass a vertex twice.
std::size_t number_of_boundaries(const Soup& soup);

/// the genus of a surface, summed over its components.
std::size_t genus(const Soup& soup);

/// \f$ V - E + F \f$; vertices without a triangle do not count.
std::ptrdiff_t euler_characteristic(const Soup& soup);

// Surfaces with boundary: closed ones with holes.

/// Disks to remove from a closed surface, no two with a common vertex.
struct Hole_request
{
  std::size_t number = 0;
  std::size_t faces = 20; ///< of each disk, approximately; at least those around a vertex
  bool is_ragged = false; ///< as many boundary edges as faces, approximately; otherwise round
  unsigned seed = 0;
  bool may_be_fewer = false; ///< if there is not enough room
};

/// the mesh without these disks and without isolated vertices. Disks are smaller where there is not
/// enough room. Throws `std::invalid_argument` if there is room for fewer of them, unless they may
/// be fewer.
Soup with_holes(const Soup& mesh, const Hole_request& holes);

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_GENERATORS_H
