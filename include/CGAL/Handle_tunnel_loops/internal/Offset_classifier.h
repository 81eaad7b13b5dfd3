// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_OFFSET_CLASSIFIER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_OFFSET_CLASSIFIER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/parallel.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Tells handle loops from tunnel loops by the change of their length when they are moved outwards
/// (paper, 4.5): handle loops grow, tunnel loops shrink. What is computed is the derivative of the
/// length by the offset; it has no unit, and is 2 pi for a circle around a solid tube.
class Offset_classifier
{
public:
  template <typename Execution>
  Offset_classifier(Execution execution, const Flat_mesh& mesh)
      : mesh_(mesh) {
    orient_components(execution);
  }

  /// the derivative of the length of the loop when it is moved along the outward normals.
  double growth(const Crossing_loop& loop) const {
    if(loop.empty())
      return 0.;
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
  // A component encloses a positive volume if its faces look outwards. Volumes are summed by runs
  // of vertices of one component, in an order that does not depend on the threads.
  template <typename Execution> void orient_components(Execution execution) {
    using Volume = std::pair<Index, double>;
    const std::vector<Volume> volumes = collect<Volume>(
        execution, mesh_.number_of_vertices(), [&](std::size_t begin, std::size_t end) {
          std::vector<Volume> runs;
          for(std::size_t v = begin; v < end; ++v) {
            const Index component = mesh_.component[v];
            if(runs.empty() || runs.back().first != component)
              runs.emplace_back(component, 0.);
            runs.back().second += volume_at(static_cast<Index>(v));
          }
          return runs;
        });
    volume_.assign(mesh_.seeds.size(), 0.);
    for(const auto& [component, volume] : volumes)
      volume_[component] += volume;
  }

  // Six times the volume of the cones from the seed over the faces that v is the smallest vertex
  // of.
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
    const Ring ring = mesh_.ring(v);
    Vector sum = {0., 0., 0.};
    for(Index i = 0; i < ring.size(); ++i)
      sum = sum + cross(mesh_.points[ring[i]] - mesh_.points[v],
                        mesh_.points[ring[ring.next(i)]] - mesh_.points[v]);
    return normalized(sum);
  }

  Vector normal(const Crossing& c) const {
    return normalized((1. - c.ratio) * normal(c.left) + c.ratio * normal(c.right));
  }

  static Vector normalized(const Vector& a) {
    const double length = norm(a);
    return length > 0. ? (1. / length) * a : a;
  }

  const Flat_mesh& mesh_;
  std::vector<double> volume_; // by component; negative if the faces look inwards
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_OFFSET_CLASSIFIER_H
