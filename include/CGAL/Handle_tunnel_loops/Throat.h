// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_THROAT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_THROAT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_type_config.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops {

/*!
\ingroup PkgHandleTunnelLoopsRef

A throat of a surface: a closed geodesic that is shorter than all neighboring loops. See
`CGAL::throats()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point_ the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point_ = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
struct Throat
{
  /// The type of the loop.
  using Loop = Loop_on_surface<TriangleMesh, Point_>;
  /// The vertex descriptor of the mesh.
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// the loop; its `pair_index()` is the position in the output. It has the type
  /// `Loop_type::TUNNEL` if it bounds outside and not inside, and `Loop_type::HANDLE` otherwise.
  Loop loop;

  /// an estimate of the amount by which the loop must become longer before it can slide away to a
  /// shorter loop or to a point, or split into shorter loops; infinite if it cannot. See
  /// `CGAL::throats()`.
  double prominence = 0.;

  /// whether the loop separates its component, that is, it is null-homologous.
  bool is_separating = false;

  /// whether it crosses no handle loop, counted with sign. It then bounds inside if the handle
  /// loops do.
  bool bounds_inside = false;

  /// whether it crosses no tunnel loop, counted with sign. It then bounds outside if the tunnel
  /// loops do.
  bool bounds_outside = false;

  /// the pair with a loop of the same class up to orientation: its handle loop or its tunnel loop,
  /// according to the type of `loop`.
  std::optional<std::size_t> pair;

  /// the vertices of `through_vertices` whose loops led to this throat.
  std::vector<Vertex_descriptor> through;

  /// Returns the diameter of a circle of the length of the loop.
  double diameter() const { return loop.length() / CGAL_PI; }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_THROAT_H
