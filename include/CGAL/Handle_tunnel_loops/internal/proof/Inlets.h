// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_INLETS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_INLETS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Where the hub of a cap lies is free to choose: at the inlet that stands for it, which other
/// programs may have rounded otherwise.
class Inlets
{
public:
  /// moves hubs to the points that stand for them.
  Inlets(const Flat_mesh& mesh, const Flat_skeleton& skeleton, std::vector<Vector>& places)
      : hubs_(skeleton.points.size(), no_index) {
    std::vector<Index> degree(skeleton.points.size(), 0);
    for(const auto& edge : skeleton.edges)
      for(Index p : edge)
        ++degree[p];
    for(Index p = 0; p < skeleton.points.size(); ++p)
      if(skeleton.is_inlet[p] && degree[p] == 1)
        hubs_[p] = hub_at(mesh, places, skeleton.points[p], skeleton.component_of[p]);
    std::vector<char> is_taken(mesh.number_of_hubs, 0); // there is one edge at a hub
    for(Index p = 0; p < skeleton.points.size(); ++p)
      if(Index& hub = hubs_[p]; hub != no_index) {
        if(char& taken = is_taken[hub - mesh.first_hub]; taken == 0) {
          taken = 1;
          places[hub] = skeleton.points[p];
        } else
          hub = no_index;
      }
  }

  /// the hub of the cap on which a point may lie; `no_index` if it may not.
  Index hub(Index point) const { return hubs_[point]; }

  /// the hub of a component that lies at a point, but for rounding; `no_index` if there is none.
  static Index hub_at(const Flat_mesh& mesh,
                      const std::vector<Vector>& places,
                      const Vector& point,
                      Index component) {
    Index nearest = no_index;
    double least = 0.;
    for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub)
      if(mesh.component[hub] == component) {
        const double d = largest(places[hub] - point);
        if(nearest == no_index || d < least) {
          nearest = hub;
          least = d;
        }
      }
    return nearest != no_index && least <= 0x1p-40 * size_of(mesh, places, nearest) ? nearest
                                                                                    : no_index;
  }

private:
  static double largest(const Vector& v) {
    return (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  }

  // What the rounding is in proportion to.
  static double size_of(const Flat_mesh& mesh, const std::vector<Vector>& places, Index hub) {
    double size = 0.;
    for(Index v : mesh.ring(hub))
      size = (std::max)(size, largest(places[v]));
    return size;
  }

  std::vector<Index> hubs_; // by point
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_INLETS_H
