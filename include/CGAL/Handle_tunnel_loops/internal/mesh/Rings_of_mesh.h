// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_RINGS_OF_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_RINGS_OF_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/mesh_checks.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The rings of the vertices of a mesh, as caller's indices, each read once; `no_index` is where
/// the boundary is. That they are all the halfedges is known from their number; only if it is not,
/// the halfedges are looked at one by one.
template <typename TriangleMesh, typename VertexIndexMap> class Rings_of_mesh
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  Rings_of_mesh(const TriangleMesh& tm, VertexIndexMap index)
      : tm_(tm)
      , index_(index) {}

  /// reads the rings of these vertices. Throws if there is no triangle, or something else.
  void read(Execution execution, const std::vector<vertex_descriptor>& vertices) {
    ranges_.resize((vertices.size() + grain - 1) / grain);
    execution.for_ranges(vertices.size(), grain, [&](std::size_t begin, std::size_t end) {
      read_range(vertices.data() + begin, end - begin, ranges_[begin / grain]);
    });
    std::size_t number_of_halfedges = 0;
    bool are_triangles = true;
    for(const Range& range : ranges_) {
      number_of_halfedges += range.neighbor.size() - range.borders.size();
      are_triangles = are_triangles && range.are_triangles;
    }
    if(!are_triangles || number_of_halfedges != num_halfedges(tm_))
      check_halfedges(vertices);
    if(number_of_halfedges == 0)
      throw Invalid_mesh_exception(Mesh_defect::EMPTY, {}, "the mesh has no face");
    if(number_of_halfedges > std::size_t(1) << 31)
      throw Invalid_mesh_exception(Mesh_defect::TOO_LARGE, {}, "the mesh has too many halfedges");
  }

  /// the ring of the i-th of these vertices, counterclockwise.
  Ring operator[](std::size_t i) const {
    const Range& range = ranges_[i / grain];
    const Index begin = i % grain == 0 ? 0 : range.row_end[i % grain - 1];
    return Ring(range.neighbor.data() + begin, range.row_end[i % grain] - begin);
  }

  /// whether the faces around the i-th vertex are not one fan: its ring has the boundary twice, or
  /// more halfedges lead to it than those of its ring.
  bool has_several_fans(std::size_t i) const {
    const Ring ring = (*this)[i];
    const auto gaps = std::count(ring.begin(), ring.end(), no_index);
    return gaps > 1 || (!valence_.empty() && valence_[i] != ring.size() - gaps);
  }

  /// the halfedges without a face, in the order of the vertices to which they lead.
  std::vector<halfedge_descriptor> take_borders() {
    std::vector<halfedge_descriptor> borders;
    for(Range& range : ranges_) {
      borders.insert(borders.end(), range.borders.begin(), range.borders.end());
      range.borders.clear();
    }
    return borders;
  }

  void clear() { ranges_ = {}; }

private:
  struct Range
  {
    std::vector<Index> neighbor;
    std::vector<Index> row_end;
    std::vector<halfedge_descriptor> borders;
    bool are_triangles = true;
  };

  std::size_t caller_index(vertex_descriptor v) const {
    return static_cast<std::size_t>(get(index_, v));
  }

  void read_range(const vertex_descriptor* vertices, std::size_t n, Range& range) const {
    constexpr std::size_t likely_valence = 7;
    range.neighbor.reserve(likely_valence * n);
    range.row_end.reserve(n);
    for(std::size_t i = 0; i < n; ++i) {
      const halfedge_descriptor first = halfedge(vertices[i], tm_);
      halfedge_descriptor h = first;
      do {
        range.neighbor.push_back(static_cast<Index>(caller_index(source(h, tm_))));
        range.are_triangles = range.are_triangles && is_in_triangle(h);
        const halfedge_descriptor out = opposite(h, tm_);
        h = prev(out, tm_);
        if(is_border(out, tm_)) {
          range.neighbor.push_back(no_index);
          range.borders.push_back(h);
        }
      } while(h != first);
      range.row_end.push_back(static_cast<Index>(range.neighbor.size()));
    }
  }

  bool is_in_triangle(halfedge_descriptor h) const {
    return is_border(h, tm_) || next(next(h, tm_), tm_) == prev(h, tm_);
  }

  // Names the first halfedge that is wrong. If there is none, the rings may still have missed some,
  // at a vertex with several fans.
  void check_halfedges(const std::vector<vertex_descriptor>& vertices) {
    std::vector<Index> valence; // by caller's index
    for(halfedge_descriptor h : halfedges(tm_)) {
      const std::size_t from = caller_index(source(h, tm_)), to = caller_index(target(h, tm_));
      if(!is_in_triangle(h))
        throw_edge_defect(Mesh_defect::NOT_TRIANGULATED, from, to,
                          "a face is not a triangle, at its");
      valence.resize((std::max)(valence.size(), to + 1), 0);
      ++valence[to];
    }
    for(vertex_descriptor v : vertices)
      valence_.push_back(caller_index(v) < valence.size() ? valence[caller_index(v)] : 0);
  }

  static constexpr std::size_t grain = 16384;

  const TriangleMesh& tm_;
  VertexIndexMap index_;
  std::vector<Range> ranges_;
  std::vector<Index> valence_; // of these vertices, if in doubt
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_RINGS_OF_MESH_H
