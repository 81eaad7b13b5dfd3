// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_CURVE_SKELETON_H
#define CGAL_HANDLE_TUNNEL_LOOPS_CURVE_SKELETON_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Skeleton_certificate.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

The vertex bundle of `Curve_skeleton`: a node of the skeleton, or a bend between two.

It has what a vertex of the graph that `extract_mean_curvature_flow_skeleton()` fills has, under the
same names.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point_ the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point_ = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
struct Curve_skeleton_vertex
{
  /// where it is.
  Point_ point;
  /// the vertices of the mesh that belong to it. Each vertex that has a face belongs to one.
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  /// the distance to the surface: the radius of the largest ball inside around the point. At an
  /// inlet, the distance to the boundary curve.
  double radius = 0.;
  /// the number of the connected component of the mesh that it is the skeleton of, from 0.
  std::size_t component = 0;
  /// whether it is the apex of the cap of a boundary curve.
  bool is_inlet = false;
};

/*!
\ingroup PkgHandleTunnelLoopsRef

The type of the graphs that `curve_skeleton()` computes. Its edges are line segments. Nodes are
vertices of degree other than 2; each path between two of them is an arc, which
`CGAL::split_graph_into_polylines()` finds.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
using Curve_skeleton = boost::adjacency_list<boost::vecS,
                                             boost::vecS,
                                             boost::undirectedS,
                                             Curve_skeleton_vertex<TriangleMesh, Point>>;

namespace Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// What a skeleton is to be like: the value of the named parameter `skeleton_options`.
struct Skeleton_options
{
  /// limbs are left out that are shorter than about this many times the radius of their base, which
  /// is its girth over two pi; not negative. A limb that tapers, as the corner of a plate does,
  /// counts as shorter by its mean girth over that of its base. About: the line is drawn where,
  /// within 10%, it tells best between the limbs of the surface. So are those shorter than 2.5% of
  /// the diagonal of the box around it, and those that end in the ball that they begin in. Cycles
  /// never are.
  double shortest_limb = 1.2;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// What a computation of a skeleton did.
struct Skeleton_statistics
{
  std::size_t number_of_vertices = 0;   ///< of the mesh, without those that have no faces
  std::size_t number_of_faces = 0;      ///< of the mesh
  std::size_t number_of_components = 0; ///< of the mesh
  std::size_t number_of_boundaries = 0; ///< boundary curves of the mesh
  std::size_t genus = 0;                ///< sum over the components
  std::size_t number_of_balls = 0;      ///< that the skeleton was chosen from
  double seconds_of_loops = 0.;         ///< for a basis of loops, which cycles are chosen by
  double seconds_of_skeleton = 0.;      ///< for all else

  /// what has been proved of the skeleton, by the loops.
  Skeleton_certificate certificate;
};

} // namespace Handle_tunnel_loops

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_CURVE_SKELETON_H
