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

A closed geodesic that is shorter than all loops next to it, as `CGAL::throats()` finds them.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point_ the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point_ = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
struct Throat
{
  using Loop = Loop_on_surface<TriangleMesh, Point_>;
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// the loop, numbered by `pair_index()` as it comes out. It is of type `Loop_type::TUNNEL` if it
  /// bounds outside and not inside, and else of type `Loop_type::HANDLE`.
  Loop loop;

  /// an estimate of how much longer the loop must become before it slips away, to a shorter one or
  /// to a point, or parts into shorter ones; infinite if it does not. See `CGAL::throats()`.
  double prominence = 0.;

  /// whether the surface falls apart along it: it is null-homologous.
  bool is_separating = false;

  /// whether it crosses no handle loop, counted with sign: then it bounds inside, if these do.
  bool bounds_inside = false;

  /// whether it crosses no tunnel loop, counted with sign: then it bounds outside, if these do.
  bool bounds_outside = false;

  /// the pair with a loop of the same class, up to the sense: its handle or its tunnel loop, as the
  /// type of `loop` says.
  std::optional<std::size_t> pair;

  /// of the vertices asked for, those from a loop through which it comes.
  std::vector<Vertex_descriptor> through;

  /// that of a circle as long as the loop.
  double diameter() const { return loop.length() / CGAL_PI; }
};

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_THROAT_H
