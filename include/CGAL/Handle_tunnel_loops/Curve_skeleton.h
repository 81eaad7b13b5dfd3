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

The vertex bundle of `Curve_skeleton`: a node of the skeleton, or a bend of an arc.

It includes, under the same names, the members of the vertices of the graph that
`extract_mean_curvature_flow_skeleton()` fills.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point_ the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point_ = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
struct Curve_skeleton_vertex
{
  /// the position of the vertex.
  Point_ point;
  /// the vertices of the mesh that are assigned to it. Each mesh vertex with a face is assigned to
  /// one vertex of the skeleton.
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  /// the distance to the surface, which is the radius of the largest ball inside around the point.
  /// For an inlet, it is the distance to the boundary curve.
  double radius = 0.;
  /// the number, from 0, of the connected component of the mesh that it belongs to: the outer one
  /// of the piece of the solid in which it lies.
  std::size_t component = 0;
  /// whether the vertex is an inlet: the apex of the cap of a boundary curve.
  bool is_inlet = false;
};

/*!
\ingroup PkgHandleTunnelLoopsRef

The type of the graphs that `curve_skeleton()` computes. Its edges are line segments. The nodes of
the skeleton are the vertices of degree other than 2. Each path between two nodes is an arc;
`CGAL::split_graph_into_polylines()` extracts the arcs.

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
/// The options of a skeleton: the value of the named parameter `skeleton_options`.
struct Skeleton_options
{
  /// the minimal length of a limb as a multiple of the radius at its base, where the radius is the
  /// girth over \f$ 2\pi \f$; not negative. Shorter limbs are omitted. The length of a limb that
  /// tapers, such as a corner of a plate, is first multiplied by the ratio of its mean girth to the
  /// girth at its base. The actual threshold may differ from this value by up to 10%: it is placed
  /// where it separates the limbs of the surface best. Limbs that are shorter than 2.5% of the
  /// bounding-box diagonal are omitted as well, and so are limbs that end in the ball in which they
  /// begin. Cycles are never omitted.
  double shortest_limb = 1.2;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The statistics of the computation of a skeleton.
struct Skeleton_statistics
{
  std::size_t number_of_vertices = 0;   ///< mesh vertices that have a face
  std::size_t number_of_faces = 0;      ///< mesh faces
  std::size_t number_of_components = 0; ///< connected components of the mesh
  std::size_t number_of_boundaries = 0; ///< boundary curves of the mesh
  std::size_t genus = 0;                ///< summed over the components
  std::size_t number_of_balls = 0;      ///< balls among which the skeleton was chosen
  double seconds_of_loops = 0.;         ///< wall time of the loops that select the cycles
  double seconds_of_skeleton = 0.;      ///< wall time of all other steps

  /// the certificate of the skeleton.
  Skeleton_certificate certificate;
};

} // namespace Handle_tunnel_loops

} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_CURVE_SKELETON_H
