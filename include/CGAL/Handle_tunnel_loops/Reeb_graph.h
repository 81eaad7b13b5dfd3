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
/// What a node of a Reeb graph is.
enum class Reeb_node_type {
  MINIMUM, ///< where a contour begins
  SADDLE,  ///< where two contours become one, or one becomes two
  MAXIMUM, ///< where a contour ends
  REGULAR  ///< no critical point: a place on an arc that would otherwise be parallel to another one
};

/// \ingroup PkgHandleTunnelLoopsRef
/// By what leaves of a Reeb graph are called small.
enum class Reeb_measure {
  LIMBS, ///< as `PERSISTENCE`; but leaves that are less long than thick at their base are small
  PERSISTENCE, ///< the difference of the values at their ends, over the range of the function
  LENGTH,      ///< the length of their polyline, over the diagonal of the bounding box
  AREA,        ///< the area of the surface that belongs to them, over the whole
  VERTICES     ///< the number of the vertices that belong to them, over the whole
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
  /// the vertex of the mesh that is the critical point.
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex;
  /// where the node is drawn: at the vertex if it is an extremum; if not, at the mean of the front
  /// where that is inside of the solid, else at a place nearby that is, as far as may be.
  Point point;
  /// the radius of the largest ball inside around the point, if `embed_reeb_graph()` placed it.
  double radius = 0.;
  /// the type of the critical point.
  Reeb_node_type type = Reeb_node_type::REGULAR;
  /// the value of the function at the vertex; the arrival time of the front, if that is the
  /// function.
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
  /// where the arc is drawn: the means of the front as it passes, or places nearby where these are
  /// outside of the solid, from `source(e, graph)` to `target(e, graph)` for the descriptors `e` in
  /// the range `edges(graph)`, both included.
  std::vector<Point> polyline;
  /// the vertices of the mesh that belong to the arc, by increasing value. A critical point belongs
  /// to the arc below it, or to the only one that it has, if the graph is not contracted.
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  /// the length of the polyline.
  double length = 0.;
  /// by point of the polyline, the radius of the largest ball inside around it; empty unless
  /// `embed_reeb_graph()` drew it.
  std::vector<double> radii;
  /// by segment of the polyline, whether it is known to lie strictly inside; empty unless
  /// `embed_reeb_graph()` drew it.
  std::vector<bool> is_inside;
};

/*!
\ingroup PkgHandleTunnelLoopsRef

The type of the graphs that `reeb_graph()` computes. The source of an edge is the end with the lower
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
/// The part of the whole up to which leaves of a Reeb graph are taken off, if no other is given.
constexpr double default_simplification_threshold = 0.03;

/// \ingroup PkgHandleTunnelLoopsRef
/// What a Reeb graph is to be like: the value of the named parameter `reeb_options`.
struct Reeb_options
{
  /// how the size of a leaf is measured; by default by `Reeb_measure::LIMBS` for a diffusion, and
  /// by `Reeb_measure::PERSISTENCE` for a given function.
  std::optional<Reeb_measure> measure;

  /// leaves are taken off whose size is at most this part of the whole, in [0, 1]; 0 gives the full
  /// Reeb graph.
  double threshold = default_simplification_threshold;

  /// arcs between saddles that are shorter than so many times their radius are contracted, that is,
  /// their nodes become one, with more than three arcs: where saddles come almost at once there are
  /// few arcs then, each for a part of the surface that one would name. How long an arc is, its
  /// area tells and the girth of its contours. No cycle is lost: arcs from a node to itself stay,
  /// and so do leaves. The vertices of an arc that is contracted go to arcs beside it, and the
  /// borders between arcs to where they are short, off the contours. 0 contracts nothing. 2, as
  /// long as thick, is a good value; `allow_parallel_arcs` should be set then.
  double shortest_arc = 0.;

  /// whether several arcs may join the same two nodes, or one a node to itself; if so there are no
  /// regular nodes.
  bool allow_parallel_arcs = false;
};

/// \ingroup PkgHandleTunnelLoopsRef
/// What is known of a Reeb graph that has been drawn inside.
struct Reeb_embedding
{
  /// whether all segments of the polylines lie strictly inside the component that they belong to,
  /// and meet no other. `Reeb_arc::is_inside` tells which do.
  bool inside = false;
  /// whether no two segments meet but in a common end.
  bool embedded = false;
  std::size_t number_of_segments = 0;        ///< of all polylines
  std::size_t number_of_segments_inside = 0; ///< of these
  std::size_t number_of_balls = 0;           ///< that the polylines were chosen from
  double seconds = 0.;                       ///< wall time
};

/// \ingroup PkgHandleTunnelLoopsRef
/// What a computation of a Reeb graph did.
struct Reeb_statistics
{
  std::size_t number_of_vertices = 0;
  std::size_t number_of_faces = 0;
  std::size_t number_of_components = 0;
  std::size_t number_of_boundaries = 0;     ///< boundary curves
  std::size_t genus = 0;                    ///< summed over the components
  std::size_t number_of_critical_nodes = 0; ///< before the simplification
  std::uint64_t number_of_steps = 0;        ///< edges walked over where contours part
  bool has_used_trees = false;              ///< whether the steps became too many
  /// what computed the fields of a diffusion: "host", "cuda", "cuda, then host" or "reference";
  /// empty for a given function.
  std::string backend;
  std::string fallback; ///< why the processor computed them, where a device was to if possible
  double seconds_of_adaptor = 0.;   ///< wall time of the preparation of the mesh
  double seconds_of_function = 0.;  ///< of the loops and the diffusion, or of reading values
  double seconds_of_sweep = 0.;     ///< of the Reeb graph itself
  double seconds_of_finishing = 0.; ///< of simplification and embedding

  /// the wall time of all, in seconds.
  double total_seconds() const {
    return seconds_of_adaptor + seconds_of_function + seconds_of_sweep + seconds_of_finishing;
  }
};

} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_REEB_GRAPH_H
