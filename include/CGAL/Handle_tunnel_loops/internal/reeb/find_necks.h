// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FIND_NECKS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FIND_NECKS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A neck of a flat mesh, in its unit.
struct Flat_neck
{
  Crossing_loop loop;
  double length;
};

/// What a neck is.
struct Neck_limits
{
  double maximal_length; ///< in the unit of the mesh
  double minimal_share;  ///< of the area of the component, for each of the pieces
};

/// finds necks: see `find_necks()`.
std::vector<Flat_neck>
find_flat_necks(Execution execution, const Flat_mesh& mesh, const Neck_limits& limits);

/*!
finds necks of a closed surface: loops shorter than `maximal_length`, in the mesh's unit, that
separate their component into two pieces. No basis of the homology holds any of them.

The necks are simple and disjoint: each passes an edge at most once, and no two of them pass edges
with a common end. The walk along the left ends of the edges that a neck passes, or the one along
the right ends, visits no vertex twice. Cut along all of them, each component falls into one piece
more than it has necks, and each piece has at least `minimal_share` of the area of the component.
Necks are of type HANDLE and ordered by their lengths; their pair indices are their positions. The
result does not depend on the number of threads.

That a neck separates is certain, as it is counted. That all necks are found is not: a neck whose
surroundings branch within its own length may be missed, and so may one on a side of which, of no
genus, the surface is nowhere a fifth wider before it comes to an end.

\throws Invalid_mesh_exception if `tm` is not a closed, oriented 2-manifold triangle mesh with
  finite coordinates
*/
template <typename TriangleMesh,
          typename VertexPointMap,
          typename VertexIndexMap,
          typename GeomTraits>
std::vector<
    Loop_on_surface<TriangleMesh, typename boost::property_traits<VertexPointMap>::value_type>>
find_necks(Execution execution,
           const TriangleMesh& tm,
           VertexPointMap point,
           VertexIndexMap index,
           const GeomTraits& traits,
           double maximal_length,
           double minimal_share) {
  const Prepared_surface surface(execution, tm, index, point);
  const auto convert = surface.converter(traits);
  std::vector<
      Loop_on_surface<TriangleMesh, typename boost::property_traits<VertexPointMap>::value_type>>
      necks;
  for(const Flat_neck& neck : find_flat_necks(
          execution, surface.mesh, {maximal_length / 2. / surface.mesh.half_scale, minimal_share}))
    necks.push_back(convert(neck.loop, Loop_type::HANDLE, necks.size()));
  return necks;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_FIND_NECKS_H
