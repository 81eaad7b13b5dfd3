// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CLOSED_SURFACE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CLOSED_SURFACE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// What relates loops and certifies them needs a closed surface: here the caller's own.
template <typename TriangleMesh,
          typename VertexPointMap,
          typename VertexIndexMap,
          typename FaceIndexMap>
class Closed_surface
{
public:
  using Mesh = TriangleMesh;
  using Walk = std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor>;

  Closed_surface(const Mesh& tm,
                 VertexPointMap point,
                 VertexIndexMap vertex_index,
                 FaceIndexMap face_index)
      : tm_(tm)
      , point_(point)
      , vertex_index_(vertex_index)
      , face_index_(face_index) {}

  const Mesh& mesh() const { return tm_; }
  VertexPointMap point() const { return point_; }
  VertexIndexMap vertex_index() const { return vertex_index_; }
  FaceIndexMap face_index() const { return face_index_; }

  /// the boundary curves, of which the mesh has the caps as well, with the surface to their left.
  std::vector<Walk> boundaries() const { return {}; }

  /// the same pairs on this surface.
  template <typename PairRange> const PairRange& pairs(const PairRange& given) const {
    return given;
  }

private:
  const Mesh& tm_;
  VertexPointMap point_;
  VertexIndexMap vertex_index_;
  FaceIndexMap face_index_;
};

/// A surface with boundary once more, with its caps, as a closed mesh of the points of the caller.
template <typename TriangleMesh, typename VertexPointMap, typename VertexIndexMap>
class Capped_surface
{
public:
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Mesh = CGAL::Surface_mesh<Point>;
  using Halfedge = typename Mesh::Halfedge_index;
  using Loop = Loop_on_surface<Mesh, Point>;
  using Pair = Handle_tunnel_pair<Mesh, Point>;
  using Walk = std::vector<Halfedge>;

  /// A hub is in the middle of its curve. The caller's mesh must outlive it; the arrays need not.
  Capped_surface(const Prepared_surface<TriangleMesh, VertexPointMap>& surface,
                 VertexIndexMap index_of_caller)
      : tm_(surface.tm)
      , index_of_caller_(index_of_caller) {
    const Flat_mesh& mesh = surface.mesh;
    mesh_.reserve(static_cast<size_type>(mesh.number_of_vertices()),
                  static_cast<size_type>(mesh.neighbor.size() / 2),
                  static_cast<size_type>(mesh.number_of_faces()));
    for(const auto v : surface.vertices)
      mesh_.add_vertex(get(surface.point, v));
    for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub)
      mesh_.add_vertex(middle(mesh.ring(hub)));
    index_vertices(mesh);
    add_edges(mesh);
    add_faces(mesh);
    add_boundaries(mesh);
    std::vector<Halfedge>().swap(halfedge_at_);
    CGAL_expensive_postcondition(mesh_.is_valid() && CGAL::is_closed(mesh_));
  }

  const Mesh& mesh() const { return mesh_; }
  auto point() const { return mesh_.points(); }
  auto face_index() const { return get(CGAL::face_index, mesh_); }

  /// the indices of the caller; of the hubs, larger ones.
  auto vertex_index() const { return vertex_index_; }

  /// the boundary curves, with the surface to their left.
  const std::vector<Walk>& boundaries() const { return boundaries_; }

  /// the same pairs, given on the mesh of the caller.
  template <typename PairRange> std::vector<Pair> pairs(const PairRange& given) const {
    std::vector<Pair> result;
    for(const auto& pair : given)
      result.emplace_back(loop(pair.handle()), loop(pair.tunnel()));
    return result;
  }

private:
  using size_type = typename Mesh::size_type;
  using Vertex_index = typename Mesh::Vertex_index;
  using Loop_of_caller = Loop_on_surface<TriangleMesh, Point>;

  static Vertex_index vertex(Index v) { return Vertex_index(static_cast<size_type>(v)); }

  void index_vertices(const Flat_mesh& mesh) {
    vertex_index_ =
        mesh_.template add_property_map<Vertex_index, Index>("v:index_of_caller", 0).first;
    const auto& original = mesh.original;
    flat_index_.assign(1 + *std::max_element(original.begin(), original.end()), no_index);
    for(Index v = 0; v < original.size(); ++v) {
      flat_index_[original[v]] = v;
      put(vertex_index_, vertex(v), original[v]);
    }
  }

  // As doubles: of what is decided by geometry, nothing depends on where a hub is.
  Point middle(Ring curve) const {
    double sum[3] = {0., 0., 0.};
    for(Index v : curve) {
      const Point& p = mesh_.point(vertex(v));
      sum[0] += CGAL::to_double(p.x()) / double(curve.size());
      sum[1] += CGAL::to_double(p.y()) / double(curve.size());
      sum[2] += CGAL::to_double(p.z()) / double(curve.size());
    }
    return Point(sum[0], sum[1], sum[2]);
  }

  // The edges of a vertex to larger ones have consecutive numbers, in the order of these.
  void add_edges(const Flat_mesh& mesh) {
    const Index n = static_cast<Index>(mesh.number_of_vertices());
    halfedge_at_.resize(mesh.neighbor.size());
    std::vector<Index> next_edge(n);
    std::vector<std::pair<Index, Index>> larger; // neighbours, and their places in the rings
    for(Index v = 0; v < n; ++v) {
      const Ring ring = mesh.ring(v);
      larger.clear();
      for(Index p = 0; p < ring.size(); ++p)
        if(ring[p] > v)
          larger.emplace_back(ring[p], mesh.row_begin[v] + p);
        else // whose edges to vertices before v have been met
          halfedge_at_[mesh.row_begin[v] + p] = Halfedge(2 * next_edge[ring[p]]++ + 1);
      std::sort(larger.begin(), larger.end());
      next_edge[v] = static_cast<Index>(mesh_.number_of_edges());
      for(const auto& [u, place] : larger)
        halfedge_at_[place] = mesh_.add_edge(vertex(v), vertex(u));
    }
  }

  void add_faces(const Flat_mesh& mesh) {
    const Index n = static_cast<Index>(mesh.number_of_vertices());
    const auto for_each_corner = [&](const auto& f) {
      for(Index v = 0; v < n; ++v) {
        const Ring ring = mesh.ring(v);
        for(Index p = 0; p < ring.size(); ++p)
          f(v, ring[p], ring[ring.next(p)], out(mesh, v, p),
            mesh_.opposite(out(mesh, v, ring.next(p))));
      }
    };
    for_each_corner([&](Index v, Index, Index, Halfedge from, Halfedge to) {
      mesh_.set_next(to, from);
      mesh_.set_halfedge(vertex(v), to);
    });
    for_each_corner([&](Index v, Index a, Index b, Halfedge from, Halfedge to) {
      if(a < v || b < v)
        return;
      const auto f = mesh_.add_face();
      for(Halfedge h : {from, mesh_.next(from), to})
        mesh_.set_face(h, f);
      mesh_.set_halfedge(f, from);
    });
  }

  Halfedge out(const Flat_mesh& mesh, Index v, Index p) const {
    return halfedge_at_[mesh.row_begin[v] + p];
  }

  void add_boundaries(const Flat_mesh& mesh) {
    for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub) {
      Walk walk;
      for(Index p = mesh.ring(hub).size(); p-- > 0;)
        walk.push_back(mesh_.opposite(mesh_.next(out(mesh, hub, p))));
      boundaries_.push_back(std::move(walk));
    }
  }

  Loop loop(const Loop_of_caller& given) const {
    std::vector<typename Loop::Step> steps;
    for(const auto& step : given.steps())
      steps.push_back(this->step(step));
    return Loop(std::move(steps), given.points(), given.length(), given.type(), given.pair_index());
  }

  // A step on an edge that has an end on the boundary begins at the other one: walks are moved
  // there.
  typename Loop::Step step(const typename Loop_of_caller::Step& given) const {
    if(given.halfedge == boost::graph_traits<TriangleMesh>::null_halfedge())
      return {Mesh::null_halfedge(), given.ratio};
    const auto from = source(given.halfedge, tm_), to = target(given.halfedge, tm_);
    const auto h = mesh_.halfedge(vertex(flat_index_[get(index_of_caller_, from)]),
                                  vertex(flat_index_[get(index_of_caller_, to)]));
    const bool is_on_boundary = static_cast<bool>(CGAL::is_border(from, tm_));
    if(!given.is_vertex() && is_on_boundary && 1. - given.ratio != 1.)
      return {mesh_.opposite(h), 1. - given.ratio};
    return {h, given.ratio};
  }

  const TriangleMesh& tm_;
  VertexIndexMap index_of_caller_;
  Mesh mesh_;
  typename Mesh::template Property_map<Vertex_index, Index> vertex_index_;
  std::vector<Index> flat_index_;     // by caller's index
  std::vector<Halfedge> halfedge_at_; // out of a vertex, by place in the rings; while it is built
  std::vector<Walk> boundaries_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CLOSED_SURFACE_H
