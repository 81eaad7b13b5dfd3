// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_MESH_BUILDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_MESH_BUILDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What is read of a caller's mesh, vertex by vertex, in its own order. Vertices without faces are
/// left out.
struct Mesh_as_read
{
  static constexpr std::size_t grain = 16384; ///< vertices of a range

  /// The rings of a range of vertices, counterclockwise, as caller's indices. `no_index` stands for
  /// the boundary.
  struct Range
  {
    std::vector<Index> neighbor;
    std::vector<Index> row_end;
    std::size_t number_of_borders = 0;
    bool are_triangles = true;
  };

  std::vector<Range> ranges;
  std::vector<Index> index;            ///< the caller's
  Uninitialized_vector<Vector> points; ///< may not be finite
  std::size_t index_bound = 0;         ///< above the caller's indices
  std::size_t number_of_halfedges = 0; ///< that the mesh says it has, without a face or with one

  Ring ring(std::size_t i) const {
    const Range& range = ranges[i / grain];
    const Index begin = i % grain == 0 ? 0 : range.row_end[i % grain - 1];
    return Ring(range.neighbor.data() + begin, range.row_end[i % grain] - begin);
  }
};

/// A halfedge as it is looked at if something seems to be wrong: its ends, and whether a face is to
/// its left that is not a triangle.
struct Suspect_halfedge
{
  std::size_t source, target;
  bool is_triangle;
};

/// throws `Invalid_mesh_exception` if there are more vertices than indices for them.
void check_index_bound(std::size_t bound);

/// whether the rings are no proof that all faces are triangles and that they hold all halfedges.
bool is_suspect(const Mesh_as_read& read);

/// turns it into a `Flat_mesh`, and refuses, naming the element, whatever is not an oriented
/// 2-manifold triangle mesh. \p order receives, by index there, the place of the vertex in what was
/// read. Linear in the size of the mesh. \p halfedges are all of the mesh if it is suspect.
Flat_mesh build_flat_mesh(Execution execution,
                          Mesh_as_read&& read,
                          const std::vector<Suspect_halfedge>& halfedges,
                          Uninitialized_vector<Index>& order);

/// Turns any `FaceListGraph` into a `Flat_mesh`. The mesh is walked once and in its own order,
/// which its halfedges are likely to follow.
template <typename TriangleMesh, typename VertexIndexMap, typename VertexPointMap>
class Flat_mesh_builder
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x())>;

public:
  Flat_mesh_builder(Execution execution,
                    const TriangleMesh& tm,
                    VertexIndexMap index,
                    VertexPointMap point)
      : execution_(execution)
      , tm_(tm)
      , index_(index)
      , point_(point) {}

  Flat_mesh build() {
    Mesh_as_read read = read_vertices();
    std::vector<Suspect_halfedge> suspects;
    if(is_suspect(read))
      for(halfedge_descriptor h : halfedges(tm_))
        suspects.push_back(
            {caller_index(source(h, tm_)), caller_index(target(h, tm_)), is_in_triangle(h)});
    Uninitialized_vector<Index> order;
    Flat_mesh mesh = build_flat_mesh(execution_, std::move(read), suspects, order);
    std::vector<vertex_descriptor> sorted(order.size());
    for_each_index(execution_, order.size(),
                   [&](std::size_t i) { sorted[i] = vertices_[order[i]]; });
    vertices_ = std::move(sorted);
    return mesh;
  }

  /// the vertex of each index of the flat mesh but for the hubs, which come last; to be called
  /// after `build()`.
  std::vector<vertex_descriptor> take_vertices() { return std::move(vertices_); }

private:
  std::size_t caller_index(vertex_descriptor v) const {
    return static_cast<std::size_t>(get(index_, v));
  }

  bool is_in_triangle(halfedge_descriptor h) const {
    return is_border(h, tm_) || next(next(h, tm_), tm_) == prev(h, tm_);
  }

  // Caller's indices may leave gaps.
  Mesh_as_read read_vertices() {
    Mesh_as_read read;
    read.number_of_halfedges = num_halfedges(tm_);
    vertices_.reserve(num_vertices(tm_));
    for(vertex_descriptor v : vertices(tm_)) {
      read.index_bound = (std::max)(read.index_bound, caller_index(v) + 1);
      if(halfedge(v, tm_) != Graph_traits::null_halfedge())
        vertices_.push_back(v);
    }
    check_index_bound(read.index_bound);
    const std::size_t n = vertices_.size();
    read.ranges.resize((n + Mesh_as_read::grain - 1) / Mesh_as_read::grain);
    read.index.resize(n);
    execution_.for_ranges(n, Mesh_as_read::grain, [&](std::size_t begin, std::size_t end) {
      read_rings(begin, end, read);
    });
    read.points.resize(n);
    // Exact numbers may share what they are computed from, and know nothing of threads.
    for_each_index(
        std::is_floating_point<Coordinate>::value ? execution_ : Execution(), n,
        [&](std::size_t i) {
          const auto& p = get(point_, vertices_[i]);
          read.points[i] = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
        });
    return read;
  }

  void read_rings(std::size_t begin, std::size_t end, Mesh_as_read& read) const {
    constexpr std::size_t likely_valence = 7;
    Mesh_as_read::Range& range = read.ranges[begin / Mesh_as_read::grain];
    range.neighbor.reserve(likely_valence * (end - begin));
    range.row_end.reserve(end - begin);
    for(std::size_t i = begin; i < end; ++i) {
      read.index[i] = static_cast<Index>(caller_index(vertices_[i]));
      const halfedge_descriptor first = halfedge(vertices_[i], tm_);
      halfedge_descriptor h = first;
      do {
        range.neighbor.push_back(static_cast<Index>(caller_index(source(h, tm_))));
        range.are_triangles = range.are_triangles && is_in_triangle(h);
        const halfedge_descriptor out = opposite(h, tm_);
        h = prev(out, tm_);
        if(is_border(out, tm_)) {
          range.neighbor.push_back(no_index);
          ++range.number_of_borders;
        }
      } while(h != first);
      range.row_end.push_back(static_cast<Index>(range.neighbor.size()));
    }
  }

  Execution execution_;
  const TriangleMesh& tm_;
  VertexIndexMap index_;
  VertexPointMap point_;
  std::vector<vertex_descriptor> vertices_; // in the order of the mesh, then sorted
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_MESH_BUILDER_H
