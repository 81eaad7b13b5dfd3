// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_OFFSET_CLASSIFIER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_OFFSET_CLASSIFIER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Edge_walker.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A loop with the faces along it, as far as its growth needs them.
struct Loop_with_faces
{
  /// A point of the loop on the edge from p to q, or at one of these.
  struct Step
  {
    Vector p, q;
    double ratio;
    bool is_vertex;
    std::size_t end_of_faces; ///< one past the last face that contains the point
  };

  std::vector<Step> steps;
  std::vector<std::array<Vector, 3>> faces; ///< by step
};

/// see `Offset_classifier`.
double growth_of(const Loop_with_faces& loop);
int compare_growth_of(const Loop_with_faces& a, const Loop_with_faces& b);

/// the length of a loop whose points are moved by the given way along their normals, rounded; it
/// stays where there are none.
double length_at_offset(const Loop_with_faces& loop, double offset);

/*!
Tells handle loops from tunnel loops by the change of their length when they are moved outwards
(paper, 4.5): handle loops grow, tunnel loops shrink. What is compared is the growth, the derivative
of the length by the offset along the normals: it has no unit and is 2 pi for a circle around a
solid tube.

The normal at a point is the sum of the normals of the faces that contain it, weighted by area, and
scaled to length one; the point is the one at the exact ratio on its edge. Thus the growth is a sum
of square roots of rational numbers: a segment e from a point with area vector M to one with N
contributes N e / (|N| |e|) - M e / (|M| |e|). It is computed in floating point with
a bound of the error first, and where that does not decide a comparison, the sign of the sum is
computed exactly.

Where an offset is given, loops are moved by it instead, as the paper does, and what is compared is
by how much they have become longer, rounded: if the way is longer than the surface is away from
itself, or bends, that may be another sign.
*/
template <typename TriangleMesh, typename VertexPointMap> class Offset_classifier
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  /// \p offset is in the unit of the points; if it is 0 the derivative is compared.
  Offset_classifier(const TriangleMesh& tm, VertexPointMap point, double offset = 0.)
      : tm_(tm)
      , point_(point)
      , offset_(offset) {}

  /// the derivative of the length of a loop by the way that it is moved along the normals, to which
  /// the faces look.
  template <typename Loop> double growth(const Loop& loop) const {
    return growth_of(with_faces(loop));
  }

  /// 1 if loop a grows by more than loop b, -1 if by less, 0 if by as much.
  template <typename Loop> int compare_growth(const Loop& a, const Loop& b) const {
    const Loop_with_faces x = with_faces(a), y = with_faces(b);
    if(offset_ == 0.)
      return compare_growth_of(x, y);
    const double difference = growth_at_offset(x) - growth_at_offset(y);
    return difference > 0. ? 1 : difference < 0. ? -1 : 0;
  }

private:
  double growth_at_offset(const Loop_with_faces& loop) const {
    return length_at_offset(loop, offset_) - length_at_offset(loop, 0.);
  }

  template <typename Loop> Loop_with_faces with_faces(const Loop& loop) const {
    Loop_with_faces result;
    for(const auto& step : loop.steps()) {
      const vertex_descriptor u = source(step.halfedge, tm_), v = target(step.halfedge, tm_);
      if(step.is_vertex()) {
        for(halfedge_descriptor h : halfedges_around_source(step.ratio == 1. ? v : u, tm_))
          result.faces.push_back(triangle(h));
      } else {
        result.faces.push_back(triangle(step.halfedge));
        result.faces.push_back(triangle(opposite(step.halfedge, tm_)));
      }
      result.steps.push_back({coordinates(point_, u), coordinates(point_, v), step.ratio,
                              step.is_vertex(), result.faces.size()});
    }
    return result;
  }

  // The face of h.
  std::array<Vector, 3> triangle(halfedge_descriptor h) const {
    return {coordinates(point_, source(h, tm_)), coordinates(point_, target(h, tm_)),
            coordinates(point_, target(next(h, tm_), tm_))};
  }

  const TriangleMesh& tm_;
  VertexPointMap point_;
  double offset_;
};

/// About how fast loops become longer when they are moved outwards (paper, 4.5): in floating point,
/// for choices of which each is right. `Offset_classifier` does the same exactly.
class Offset_growth
{
public:
  explicit Offset_growth(const Flat_mesh& mesh)
      : mesh_(mesh)
      , volume_(mesh.seeds.size(), 0.) {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      volume_[mesh.component[v]] += volume_at(v);
      if(mesh.ring(v).size() > many_neighbors)
        normal_of_busy_[v] = normal_at(v);
    }
  }

  /// the derivative of the length by the way along the normals.
  double operator()(const Crossing_loop& loop) const {
    CGAL_precondition(!loop.empty());
    double sum = 0.;
    Vector p = position(mesh_, loop.back()), n = normal(loop.back());
    for(const Crossing& c : loop) {
      const Vector q = position(mesh_, c), m = normal(c);
      const double distance = norm(q - p);
      if(distance > 0.)
        sum += dot(m - n, q - p) / distance;
      p = q;
      n = m;
    }
    return volume_[mesh_.component[loop.front().left]] < 0. ? -sum : sum;
  }

private:
  // Of the cones from the seed over the faces that v is the smallest vertex of, six times.
  double volume_at(Index v) const {
    const Vector& origin = mesh_.points[mesh_.seeds[mesh_.component[v]]];
    const Ring ring = mesh_.ring(v);
    double sum = 0.;
    for(Index i = 0; i < ring.size(); ++i) {
      const Index a = ring[i], b = ring[ring.next(i)];
      if(v < a && v < b)
        sum += dot(mesh_.points[v] - origin,
                   cross(mesh_.points[a] - origin, mesh_.points[b] - origin));
    }
    return sum;
  }

  Vector normal(Index v) const {
    return mesh_.ring(v).size() > many_neighbors ? normal_of_busy_.at(v) : normal_at(v);
  }

  Vector normal_at(Index v) const {
    const Ring ring = mesh_.ring(v);
    Vector sum = {0., 0., 0.};
    for(Index i = 0; i < ring.size(); ++i)
      sum = sum + cross(mesh_.points[ring[i]] - mesh_.points[v],
                        mesh_.points[ring[ring.next(i)]] - mesh_.points[v]);
    return unit(sum);
  }

  Vector normal(const Crossing& c) const {
    return unit((1. - c.ratio) * normal(c.left) + c.ratio * normal(c.right));
  }

  const Flat_mesh& mesh_;
  std::vector<double> volume_; // by component; negative if the faces look inwards
  // Of vertices with many neighbours: a loop may cross the edges of all of them.
  std::unordered_map<Index, Vector> normal_of_busy_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_OFFSET_CLASSIFIER_H
