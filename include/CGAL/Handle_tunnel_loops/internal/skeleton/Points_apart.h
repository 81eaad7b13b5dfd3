// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_POINTS_APART_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_POINTS_APART_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Segments_apart.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Edges_at.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Moves points of edges that meet, or have no length, a little: on shapes with a plane of
/// symmetry, edges in it may meet, and so may lines that run side by side.
class Points_apart
{
public:
  using Edges = std::vector<std::array<Index, 2>>;

  /// \p wall must outlive it.
  Points_apart(Execution execution, const Wall& wall)
      : execution_(execution)
      , wall_(wall) {}

  /// \p placed gives the points the places where they are not to meet: as they are, or turned.
  template <typename Placed> void move(Flat_skeleton& flat, const Placed& placed) {
    constexpr int most_rounds = 32;
    const Edges_at edges_at(flat.points.size(), flat.edges);
    for(int round = 0; round < most_rounds; ++round) {
      const Edges edges = edges_that_meet(placed(flat));
      if(edges.empty())
        return;
      for(const auto& edge : edges)
        for(const Index p : edge)
          if(flat.is_inlet[p] == 0) {
            const Vector to = place_beside(flat, p);
            if(can_move(flat, edges_at[p], p, to))
              flat.points[p] = to;
          }
    }
  }

private:
  Edges edges_that_meet(const Flat_skeleton& flat) const {
    const Segments_apart apart(flat);
    Edges edges = apart.edges_without_length();
    for(const auto& [a, b] : apart.edges_that_meet(execution_)) {
      edges.push_back(a);
      edges.push_back(b);
    }
    return edges;
  }

  Vector place_beside(const Flat_skeleton& flat, Index p) {
    constexpr double part = 1e-3; // of the radius
    const double most = part * flat.radii[p];
    Vector place = flat.points[p];
    for(double& x : place)
      x += most * (2. * double(random_()) / double(random_.max()) - 1.);
    return place;
  }

  // Edges may be close to the surface far from their ends. At inlets they lie on a cap.
  bool
  can_move(const Flat_skeleton& flat, Span<const Index> edges, Index p, const Vector& to) const {
    return std::none_of(edges.begin(), edges.end(), [&](Index e) {
      const Index other = flat.edges[e][flat.edges[e][0] == p ? 1 : 0];
      return flat.is_inlet[other] == 0 && wall_.meets(to, flat.points[other]);
    });
  }

  Execution execution_;
  const Wall& wall_;
  std::minstd_rand random_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_POINTS_APART_H
