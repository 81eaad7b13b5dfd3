// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_WAY_NETWORK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_WAY_NETWORK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Ball_network.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Cycle_trials.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The balls of free ways, as large as fits, joined along the ways, and to those around them
/// (Delaunay): where ways meet, parts of them make up others.
inline Ball_network network_of_ways(Execution execution,
                                    const Clearance& clearance,
                                    const std::vector<Cycle_trial>& ways) {
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Delaunay = Delaunay_triangulation_3<
      Kernel, Triangulation_data_structure_3<Triangulation_vertex_base_with_info_3<Index, Kernel>>>;
  constexpr double nothing_is_farther = 4.;

  Ball_network network;
  std::vector<std::array<Index, 2>> ends;
  std::vector<std::pair<Delaunay::Point, Index>> places;
  for(const Cycle_trial& way : ways)
    if(way.is_wide)
      for(std::size_t i = 0; i < way.curve.size(); ++i) {
        const Index node = static_cast<Index>(network.nodes.size());
        const Vector& p = way.curve[i].place;
        network.nodes.push_back({p, 0.});
        places.emplace_back(Delaunay::Point(p[0], p[1], p[2]), node);
        ends.push_back({node, i + 1 < way.curve.size() ? node + 1 : static_cast<Index>(node - i)});
      }
  for_each_index(
      execution, network.nodes.size(),
      [&](std::size_t i) {
        network.nodes[i].radius = clearance.at(network.nodes[i].place, nothing_is_farther);
      },
      64);
  const Delaunay delaunay(places.begin(), places.end());
  for(const auto& edge : delaunay.finite_edges())
    ends.push_back(
        {edge.first->vertex(edge.second)->info(), edge.first->vertex(edge.third)->info()});
  for(const auto& [a, b] : ends)
    if(const double radius =
           Clearance::least_between({network.nodes[a].place, network.nodes[a].radius},
                                    {network.nodes[b].place, network.nodes[b].radius});
       a != b && radius > 0.)
      network.edges.push_back({{a, b}, static_cast<float>(radius), static_cast<float>(radius)});
  return network;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_WAY_NETWORK_H
