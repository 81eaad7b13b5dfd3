// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_FACE_TREE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_FACE_TREE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Component_orientation.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

inline Box<3> box_around(const Vector& a, const Vector& b) {
  Box<3> box = {a, a};
  box.extend({b, b});
  return box;
}

/// a point of the segment from a to b, but for rounding.
inline Vector point_between(const Vector& a, const Vector& b, double ratio) {
  return (1. - ratio) * a + ratio * b;
}

/// A box that a point is in that is known but for the rounding of one between a and b.
inline Box<3> box_with_rounding(Box<3> box, const Vector& a, const Vector& b) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for(int d = 0; d < 3; ++d) {
    const double error = (std::max)(std::abs(a[d]), std::abs(b[d])) * 0x1p-50 + 8. * least;
    box.low[d] -= error;
    box.high[d] += error;
  }
  return box;
}

/// The faces of a surface with its caps, found by where they are. The arrays must outlive it.
class Face_tree
{
public:
  /// The corners of a face, counterclockwise, the one with the smallest index first.
  using Corners = std::array<Index, 3>;

  /// \p points are the places of the vertices, hubs included.
  Face_tree(Execution execution, const Flat_mesh& mesh, Span<const Vector> points)
      : points_(points)
      , faces_(faces_of(execution, mesh))
      , boxes_(execution, faces_.size(), [this](Index face) { return triangle(face); }) {
    double sum = 0.;
    const std::size_t stride = 1 + faces_.size() / 10000;
    std::size_t count = 0;
    for(std::size_t i = 0; i < faces_.size(); i += stride, ++count)
      sum += width(box_of(static_cast<Index>(i)));
    length_of_pieces_ = 4. * sum / static_cast<double>((std::max)(count, std::size_t(1)));
  }

  std::size_t size() const { return faces_.size(); }
  const Corners& corners(Index face) const { return faces_[face]; }

  Triangle triangle(Index face) const {
    const Corners& v = faces_[face];
    return {points_[v[0]], points_[v[1]], points_[v[2]]};
  }

  /// the boxes around the faces.
  const Face_boxes& boxes() const { return boxes_; }

  /// whether `f(face)` holds for any face that is near a segment: its box meets that of one of the
  /// pieces into which a long one is divided.
  template <typename Predicate>
  bool any_near(const Vector& a, const Vector& b, const Predicate& f) const {
    constexpr double most_pieces = 1024.;
    const double pieces = std::ceil(width(box_around(a, b)) / length_of_pieces_);
    const int n = pieces >= 1. ? static_cast<int>((std::min)(pieces, most_pieces)) : 1;
    for(int i = 0; i < n; ++i) {
      const Box<3> box = n == 1 ? box_around(a, b)
                                : box_with_rounding(box_around(point_between(a, b, double(i) / n),
                                                               point_between(a, b, (i + 1.) / n)),
                                                    a, b);
      if(boxes_.any_meeting(box, f))
        return true;
    }
    return false;
  }

  /// calls `f(face)` for the faces that are above the point half way between a and b, which lies on
  /// none.
  template <typename Function>
  void for_each_above(const Vector& a, const Vector& b, const Function& f) const {
    const Vector middle = point_between(a, b, 0.5);
    Box<3> ray = box_with_rounding({middle, middle}, a, b);
    ray.high[2] = std::numeric_limits<double>::infinity();
    std::vector<Index> met;
    boxes_.any_meeting(ray, [&](Index face) {
      met.push_back(face);
      return false;
    });
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    for(Index face : met)
      if(see_triangle(triangle(face), a, b) == Seen_triangle::ABOVE)
        f(face);
  }

private:
  // In the order of the vertices, which is one in space.
  static std::vector<Corners> faces_of(Execution execution, const Flat_mesh& mesh) {
    return collect<Corners>(
        execution, mesh.number_of_vertices(), [&](std::size_t begin, std::size_t end) {
          std::vector<Corners> faces;
          for(Index v = static_cast<Index>(begin); v < end; ++v) {
            const Ring ring = mesh.ring(v);
            for(Index p = 0; p < ring.size(); ++p)
              if(const Index u = ring[p], w = ring[ring.next(p)]; v < u && v < w)
                faces.push_back({v, u, w});
          }
          return faces;
        });
  }

  Box<3> box_of(Index face) const {
    const Triangle t = triangle(face);
    Box<3> box = box_around(t[0], t[1]);
    box.extend({t[2], t[2]});
    return box;
  }

  // Infinite where it is beyond all doubles.
  static double width(const Box<3>& box) {
    return (std::max)(
        {box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]});
  }

  Span<const Vector> points_;
  std::vector<Corners> faces_;
  Face_boxes boxes_;
  double length_of_pieces_ = 0.;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_FACE_TREE_H
