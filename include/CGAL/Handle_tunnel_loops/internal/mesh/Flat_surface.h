// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_SURFACE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_SURFACE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Loop_converter.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A surface as arrays, with the caps of one with boundary, for what relates loops: that needs a
/// closed one. The coordinates are those of the caller as doubles.
class Flat_surface
{
  using Identity = boost::typed_identity_property_map<Index>;

public:
  using Mesh = Flat_graph;
  using Kernel = Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Loop = Loop_on_surface<Flat_graph, Point>;
  using Pair = Handle_tunnel_pair<Flat_graph, Point>;
  using Walk = std::vector<Flat_graph::Halfedge>;

  /// \p points are those of the vertices but for the hubs. The arrays must outlive it.
  Flat_surface(const Flat_mesh& mesh, std::vector<Point> points)
      : graph_(mesh)
      , points_(std::move(points)) {
    for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub)
      points_.push_back(middle(mesh.ring(hub)));
  }

  const Flat_graph& mesh() const { return graph_; }
  auto point() const { return boost::make_iterator_property_map(points_.begin(), Identity()); }

  /// the indices of the caller; of the hubs, larger ones.
  auto vertex_index() const {
    return boost::make_iterator_property_map(graph_.mesh().original.data(), Identity());
  }

  /// with gaps.
  struct Face_index_map
  {
    const Flat_mesh* mesh;
    friend Index get(const Face_index_map& map, Flat_graph::Halfedge f) {
      return map.mesh->row_begin[f.source] + f.place;
    }
  };
  Face_index_map face_index() const { return {&graph_.mesh()}; }

  /// the boundary curves, of which the mesh has the caps as well, with the surface to their left.
  std::vector<Walk> boundaries() const {
    std::vector<Walk> boundaries;
    const Flat_mesh& mesh = graph_.mesh();
    for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub) {
      Walk walk;
      for(Index p = mesh.ring(hub).size(); p-- > 0;)
        walk.push_back(opposite(next(Flat_graph::Halfedge{hub, p}, graph_), graph_));
      boundaries.push_back(std::move(walk));
    }
    return boundaries;
  }

  /// loops that were found on the arrays.
  std::vector<Loop> loops(Execution execution,
                          const std::vector<const Crossing_loop*>& found) const {
    const Own_vertices vertices = own_vertices();
    const Converter convert(graph_, point(), Kernel(), vertices);
    std::vector<Loop> loops(found.size());
    for_each_index(
        execution, found.size(),
        [&](std::size_t i) { loops[i] = convert(*found[i], Loop_type::HANDLE, i); }, 8);
    return loops;
  }

  /// pairs that were found on the arrays.
  std::vector<Pair> pairs(const std::vector<Flat_pair>& found) const {
    const Own_vertices vertices = own_vertices();
    const Converter convert(graph_, point(), Kernel(), vertices);
    std::vector<Pair> pairs;
    for(const Flat_pair& pair : found)
      pairs.emplace_back(convert(pair.handle, Loop_type::HANDLE, pairs.size()),
                         convert(pair.tunnel, Loop_type::TUNNEL, pairs.size()));
    return pairs;
  }

private:
  // The vertices but for the hubs, by number: themselves.
  struct Own_vertices
  {
    Index number;
    Index size() const { return number; }
    Index operator[](Index v) const { return v; }
  };
  using Converter =
      Loop_converter<Flat_graph,
                     boost::iterator_property_map<std::vector<Point>::const_iterator, Identity>,
                     Kernel,
                     Own_vertices>;

  Own_vertices own_vertices() const { return {graph_.mesh().first_hub}; }

  // Of what is decided by geometry, nothing depends on where a hub is.
  Point middle(Ring curve) const {
    double sum[3] = {0., 0., 0.};
    for(Index v : curve)
      for(int d = 0; d < 3; ++d)
        sum[d] += points_[v][d] / double(curve.size());
    return Point(sum[0], sum[1], sum[2]);
  }

  Flat_graph graph_;
  std::vector<Point> points_; // by vertex, hubs included
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_SURFACE_H
