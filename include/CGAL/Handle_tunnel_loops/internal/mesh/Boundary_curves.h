// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_BOUNDARY_CURVES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_BOUNDARY_CURVES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The boundary curves of a mesh: cycles of vertices, as caller's indices, in the order in which
/// halfedges without a face follow each other. So the surface is to the right of a curve.
class Boundary_curves
{
public:
  Boundary_curves() = default;

  /// \p borders are all halfedges without a face; the curves come in their order. \p bound is
  /// above all indices. A vertex may lie on one curve, and once: the last one counts.
  template <typename TriangleMesh, typename VertexIndexMap, typename Halfedge>
  Boundary_curves(const TriangleMesh& tm,
                  VertexIndexMap index,
                  const std::vector<Halfedge>& borders,
                  std::size_t bound) {
    if(borders.empty())
      return;
    curve_at_.assign(bound, no_index);
    for(const Halfedge first : borders) {
      if(curve_at_[get(index, target(first, tm))] != no_index)
        continue;
      const Index curve = static_cast<Index>(size());
      Halfedge h = first;
      do {
        const Index v = static_cast<Index>(get(index, target(h, tm)));
        curve_at_[v] = curve;
        vertices_.push_back(v);
        h = next(h, tm);
      } while(h != first);
      begin_.push_back(static_cast<Index>(vertices_.size()));
    }
  }

  std::size_t size() const { return begin_.size() - 1; }

  /// the vertices of a curve.
  Ring operator[](std::size_t i) const {
    return Ring(vertices_.data() + begin_[i], begin_[i + 1] - begin_[i]);
  }

  /// the number of the curve on which a vertex lies.
  Index curve_at(Index v) const {
    CGAL_precondition_msg(v < curve_at_.size() && curve_at_[v] < size(), "on the boundary");
    return curve_at_[v];
  }

private:
  std::vector<Index> vertices_, begin_ = {0};
  std::vector<Index> curve_at_; // by vertex, if there is any curve
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_BOUNDARY_CURVES_H
