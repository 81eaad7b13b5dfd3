// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FLAT_MESH_BUILDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FLAT_MESH_BUILDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh_checks.h>
#include <CGAL/Handle_tunnel_loops/internal/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/space_filling_order.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Turns any `FaceListGraph` into a `Flat_mesh`, and refuses, naming the element, whatever is not a
/// closed oriented 2-manifold triangle mesh. Linear in the size of the mesh, but for the sort of
/// the vertices. Isolated vertices are left out.
template <typename TriangleMesh,
          typename VertexIndexMap,
          typename VertexPointMap,
          typename Execution>
class Flat_mesh_builder
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  Flat_mesh_builder(const TriangleMesh& tm, VertexIndexMap index, VertexPointMap point)
      : tm_(tm)
      , index_(index)
      , point_(point) {}

  Flat_mesh build() {
    collect_vertices();
    count_valences();
    read_points();
    number_vertices();
    fill_rings();
    find_components();
    return std::move(mesh_);
  }

  /// the vertex of each index of the flat mesh; to be called after `build()`.
  std::vector<vertex_descriptor> take_vertices() { return std::move(vertices_); }

private:
  std::size_t caller_index(vertex_descriptor v) const {
    return static_cast<std::size_t>(get(index_, v));
  }

  // The number of caller's indices, which may leave gaps.
  void collect_vertices() {
    std::size_t bound = 0;
    for(vertex_descriptor v : vertices(tm_))
      bound = (std::max)(bound, caller_index(v) + 1);
    valence_.assign(bound, 0);
    if(bound >= no_index)
      throw Invalid_mesh_exception(Mesh_defect::TOO_LARGE, {}, "the mesh has too many vertices");
  }

  void count_valences() {
    std::size_t number_of_halfedges = 0;
    for(halfedge_descriptor h : halfedges(tm_)) {
      if(is_border(h, tm_))
        throw_edge_defect(Mesh_defect::BOUNDARY_EDGE, caller_index(source(h, tm_)),
                          caller_index(target(h, tm_)), "the mesh is not closed, boundary edge");
      if(next(next(next(h, tm_), tm_), tm_) != h)
        throw_edge_defect(Mesh_defect::NOT_TRIANGULATED, caller_index(source(h, tm_)),
                          caller_index(target(h, tm_)), "a face is not a triangle, at its");
      ++valence_[caller_index(target(h, tm_))];
      ++number_of_halfedges;
    }
    if(number_of_halfedges == 0)
      throw Invalid_mesh_exception(Mesh_defect::EMPTY, {}, "the mesh has no face");
    if(number_of_halfedges > std::size_t(1) << 31)
      throw Invalid_mesh_exception(Mesh_defect::TOO_LARGE, {}, "the mesh has too many halfedges");
  }

  void read_points() {
    for(vertex_descriptor v : vertices(tm_)) {
      const std::size_t i = caller_index(v);
      if(valence_[i] == 0)
        continue;
      const auto& p = get(point_, v);
      const Vector x = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
      if(!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
        throw_vertex_defect(Mesh_defect::NON_FINITE_COORDINATE, i, "a coordinate is not finite");
      vertices_.push_back(v);
      points_.push_back(x);
    }
    move_into_unit_box();
  }

  void move_into_unit_box() {
    Vector low, high;
    low.fill((std::numeric_limits<double>::max)());
    high.fill(std::numeric_limits<double>::lowest());
    for(const Vector& p : points_)
      for(int d = 0; d < 3; ++d) {
        low[d] = (std::min)(low[d], p[d]);
        high[d] = (std::max)(high[d], p[d]);
      }
    // Halved before they are subtracted: the difference of the largest doubles overflows.
    double half = 0.;
    for(int d = 0; d < 3; ++d)
      half = (std::max)(half, 0.5 * high[d] - 0.5 * low[d]);
    if(half == 0.)
      half = 0.5;
    mesh_.scale = 2. * half;
    for_each_index(execution_, points_.size(), [&](std::size_t i) {
      for(int d = 0; d < 3; ++d)
        points_[i][d] = (0.5 * points_[i][d] - 0.5 * low[d]) / half;
    });
  }

  void number_vertices() {
    const std::vector<Index> order = space_filling_order(execution_, points_);
    const std::size_t n = order.size();
    flat_index_.assign(valence_.size(), no_index);
    mesh_.points.resize(n);
    mesh_.original.resize(n);
    mesh_.row_begin.resize(n + 1);
    std::vector<vertex_descriptor> sorted(n);
    for_each_index(execution_, n, [&](std::size_t i) {
      const vertex_descriptor v = vertices_[order[i]];
      const std::size_t c = caller_index(v);
      sorted[i] = v;
      mesh_.points[i] = points_[order[i]];
      mesh_.original[i] = static_cast<Index>(c);
      flat_index_[c] = static_cast<Index>(i);
    });
    vertices_ = std::move(sorted);
    std::vector<Vector>().swap(points_);

    Index begin = 0;
    for(std::size_t i = 0; i < n; ++i) {
      mesh_.row_begin[i] = begin;
      begin += valence_[mesh_.original[i]];
    }
    mesh_.row_begin[n] = begin;
    mesh_.neighbor.resize(begin);
  }

  void fill_rings() {
    First_index several_fans, parallel_edges;
    for_each_index(execution_, vertices_.size(), [&](std::size_t i) {
      const Index begin = mesh_.row_begin[i], end = mesh_.row_begin[i + 1];
      Index position = begin;
      const halfedge_descriptor first = halfedge(vertices_[i], tm_);
      halfedge_descriptor h = first;
      do {
        if(position == end)
          break;
        mesh_.neighbor[position++] = flat_index_[caller_index(source(h, tm_))];
        h = prev(opposite(h, tm_), tm_);
      } while(h != first);
      if(position != end || h != first)
        several_fans.see(i);
      else if(has_repetition(mesh_.ring(static_cast<Index>(i))))
        parallel_edges.see(i);
    });
    if(several_fans.found())
      throw_vertex_defect(Mesh_defect::NON_MANIFOLD_VERTEX, mesh_.original[several_fans.get()],
                          "the faces around a vertex form more than one fan");
    if(parallel_edges.found())
      throw_vertex_defect(Mesh_defect::PARALLEL_EDGES, mesh_.original[parallel_edges.get()],
                          "two edges join a vertex to the same neighbour");
  }

  static bool has_repetition(Ring ring) {
    if(ring.size() <= 16) {
      for(Index i = 1; i < ring.size(); ++i)
        for(Index j = 0; j < i; ++j)
          if(ring[i] == ring[j])
            return true;
      return false;
    }
    std::vector<Index> sorted(ring.begin(), ring.end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  }

  // The seed of a component is its vertex of smallest caller's index.
  void find_components() {
    const std::size_t n = mesh_.number_of_vertices();
    mesh_.component.assign(n, no_index);
    std::vector<Index> queue;
    queue.reserve(n);
    const auto visit = [&](Index v) {
      mesh_.component[v] = static_cast<Index>(mesh_.seeds.size() - 1);
      queue.push_back(v);
    };
    const auto visit_component = [&](Index first) {
      mesh_.seeds.push_back(first);
      queue.clear();
      visit(first);
      for(std::size_t q = 0; q < queue.size(); ++q)
        for(Index u : mesh_.ring(queue[q]))
          if(mesh_.component[u] == no_index)
            visit(u);
    };
    for(Index v : flat_index_)
      if(v != no_index && mesh_.component[v] == no_index)
        visit_component(v);

    // V - E + F = 2 c - 2 g, with 2 E = 3 F halfedges.
    const std::size_t handles_twice =
        2 * mesh_.seeds.size() + mesh_.number_of_faces() / 2 - mesh_.number_of_vertices();
    mesh_.genus = handles_twice / 2;
  }

  const TriangleMesh& tm_;
  VertexIndexMap index_;
  VertexPointMap point_;
  Execution execution_;
  Flat_mesh mesh_;
  std::vector<Index> valence_;    // by caller's index
  std::vector<Index> flat_index_; // by caller's index
  std::vector<vertex_descriptor> vertices_;
  std::vector<Vector> points_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FLAT_MESH_BUILDER_H
