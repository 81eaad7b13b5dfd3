// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_REEB_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_REEB_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {

/// \ingroup PkgHandleTunnelLoopsRef
/// The types of nodes of a Reeb graph.
enum class Reeb_node_type {
  MINIMUM, ///< a contour begins
  SADDLE,  ///< two contours merge, or one contour splits
  MAXIMUM, ///< a contour ends
  REGULAR  ///< not critical: divides an arc that would otherwise be parallel to another one
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The measures by which the simplification compares the leaves of a Reeb graph.
enum class Reeb_measure {
  LIMBS,       ///< as `PERSISTENCE`, but leaves shorter than the thickness at their base are small
  PERSISTENCE, ///< the difference of the values at the ends, relative to the range of the function
  LENGTH,      ///< the length of the polyline, relative to the bounding-box diagonal
  AREA,        ///< the area of the surface of the leaf, relative to the total area
  VERTICES     ///< the number of vertices of the leaf, relative to the total number
};

/*!
\ingroup PkgHandleTunnelLoopsRef

The vertex bundle of `Reeb_graph`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
struct Reeb_node
{
  /// the mesh vertex of the critical point.
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex;
  /// the position of the node. An extremum lies at its vertex. Other nodes lie at the centroid of
  /// the front if it is inside the solid, and otherwise at a nearby point that is, if possible.
  Point point;
  /// the radius of the largest ball inside around the point; set by `embed_reeb_graph()` only.
  double radius = 0.;
  /// the type of the node.
  Reeb_node_type type = Reeb_node_type::REGULAR;
  /// the value of the function at the vertex. For a diffusion, it is the arrival time of the front
  /// in steps.
  double value = 0.;
};

/*!
\ingroup PkgHandleTunnelLoopsRef

The edge bundle of `Reeb_graph`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
struct Reeb_arc
{
  /// the position of the arc in the range `edges(graph)`.
  std::size_t index = 0;
  /// the polyline of the arc: the centroids of the front as it passes, or nearby points where these
  /// are outside of the solid. It goes from `source(e, graph)` to `target(e, graph)`, both
  /// included, for the descriptors `e` in the range `edges(graph)`.
  std::vector<Point> polyline;
  /// the mesh vertices that belong to the arc, by increasing value. If the graph is not contracted,
  /// a critical point belongs to the arc below it, or to its only arc.
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  /// the length of the polyline.
  double length = 0.;
  /// for each point of the polyline, the radius of the largest ball inside around it; empty unless
  /// `embed_reeb_graph()` computed the polyline.
  std::vector<double> radii;
  /// for each segment of the polyline, whether it is certified to lie strictly inside; empty unless
  /// `embed_reeb_graph()` computed the polyline.
  std::vector<bool> is_inside;
};

/*!
\ingroup PkgHandleTunnelLoopsRef

The type of the graphs that `reeb_graph()` computes. The source of an edge is its end with the lower
value.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam Point the point type of the mesh
*/
template <typename TriangleMesh,
          typename Point = typename boost::property_traits<
              typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::value_type>
using Reeb_graph = boost::adjacency_list<boost::vecS,
                                         boost::vecS,
                                         boost::undirectedS,
                                         Reeb_node<TriangleMesh, Point>,
                                         Reeb_arc<TriangleMesh, Point>>;

namespace Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// The default value of `Reeb_options::threshold`.
constexpr double default_simplification_threshold = 0.03;

/// \ingroup PkgHandleTunnelLoopsRef
/// The options of a Reeb graph: the value of the named parameter `reeb_options`.
struct Reeb_options
{
  /// the measure of leaves. The default is `Reeb_measure::LIMBS` for a diffusion, and
  /// `Reeb_measure::PERSISTENCE` for other functions.
  std::optional<Reeb_measure> measure;

  /// the threshold of the simplification, in [0, 1]. Leaves whose measure is at most this value are
  /// removed. 0 gives the full Reeb graph.
  double threshold = default_simplification_threshold;

  /// the minimal length of an arc between saddles, as a multiple of its radius; not negative.
  /// Shorter arcs are contracted: their nodes become one node, with more than three arcs. If
  /// several saddles are close together, the graph then has few arcs, each of which represents a
  /// recognizable part of the surface. The length of an arc is derived from its area and the girth
  /// of its contours. Cycles are preserved, as arcs from a node to itself if necessary, and so are
  /// leaves. The vertices of a contracted arc are assigned to adjacent arcs, and the borders
  /// between arcs move off the contours to where they are short. 0 contracts nothing. 2 is a good
  /// value (as long as thick); set `allow_parallel_arcs` with it.
  double shortest_arc = 0.;

  /// whether several arcs may join the same two nodes, and an arc may join a node to itself. If
  /// set, the graph has no regular nodes.
  bool allow_parallel_arcs = false;

  /// whether each boundary curve is closed by a cap before the graph is computed. On the cap, the
  /// function has no extremum and no saddle of its own, unless it has several maxima on the curve.
  /// If not set, contours end at the boundary.
  bool capped = false;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The properties of an embedded Reeb graph.
struct Reeb_embedding
{
  /// whether all segments of the polylines lie strictly inside the component that they belong to,
  /// and meet no other component. `Reeb_arc::is_inside` lists them.
  bool inside = false;
  /// whether two segments meet at most in a common endpoint.
  bool embedded = false;
  std::size_t number_of_segments = 0;        ///< segments of all polylines
  std::size_t number_of_segments_inside = 0; ///< segments that are certified to lie inside
  std::size_t number_of_balls = 0;           ///< balls among which the polylines were chosen
  double seconds = 0.;                       ///< wall time in seconds
};

/// \ingroup PkgHandleTunnelLoopsRef
/// The statistics of the computation of a Reeb graph.
struct Reeb_statistics
{
  std::size_t number_of_vertices = 0;       ///< mesh vertices that have a face
  std::size_t number_of_faces = 0;          ///< mesh faces
  std::size_t number_of_components = 0;     ///< connected components of the mesh
  std::size_t number_of_boundaries = 0;     ///< boundary curves
  std::size_t genus = 0;                    ///< summed over the components
  std::size_t number_of_critical_nodes = 0; ///< nodes before the simplification
  std::uint64_t number_of_steps = 0;        ///< edges traversed where contours split
  bool has_used_trees = false; ///< whether the number of steps reached its limit, or contours end
                               ///< at a boundary
  /// the backend that computed the fields of a diffusion: "host", "cuda", "cuda, then host" or
  /// "reference"; empty for other functions.
  std::string backend;
  std::string fallback;             ///< why the processor was used although a device was requested
  double seconds_of_adaptor = 0.;   ///< wall time of the preparation of the mesh
  double seconds_of_function = 0.;  ///< wall time of loops and diffusion, or of reading values
  double seconds_of_sweep = 0.;     ///< wall time of the Reeb graph itself
  double seconds_of_finishing = 0.; ///< wall time of simplification and embedding

  /// Returns the total wall time in seconds.
  double total_seconds() const {
    return seconds_of_adaptor + seconds_of_function + seconds_of_sweep + seconds_of_finishing;
  }
};

} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_REEB_GRAPH_H
