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
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Balls along free ways, as large as fits, and larger ones uphill from these, joined along the ways,
on the way up, and to those around them (Delaunay): where ways meet, parts of them make up others.

Ways that narrow places hindered run close to the surface elsewhere, too: uphill is where they meet.
*/
class Way_network : public Ball_network
{
public:
  /// no ball is to be wider than \p most.
  Way_network(Execution execution,
              const Clearance& clearance,
              const std::vector<Cycle_trial>& ways,
              double most) {
    std::vector<Ball_network> parts(ways.size());
    for_each_index(
        execution, ways.size(),
        [&](std::size_t i) {
          if(ways[i].is_wide)
            parts[i] = part_along(clearance, ways[i], most);
        },
        1);
    for(const Ball_network& part : parts) {
      const Index first = static_cast<Index>(nodes.size());
      nodes.insert(nodes.end(), part.nodes.begin(), part.nodes.end());
      for(const Edge& edge : part.edges)
        join(first + edge.nodes[0], first + edge.nodes[1]);
    }
    join_neighbors();
  }

private:
  // Where a way runs well within a ball that it led up to, that does instead.
  static Ball_network part_along(const Clearance& clearance, const Cycle_trial& way, double most) {
    Ball_network part;
    const auto add_node = [&](const Free_ball& ball, Index before) {
      if(before != no_index)
        part.edges.push_back({{before, static_cast<Index>(part.nodes.size())}, 0.f, 0.f});
      part.nodes.push_back({ball.place, ball.radius});
      return static_cast<Index>(part.nodes.size() - 1);
    };
    Index last = no_index, top = no_index;
    const std::vector<Vector> places = places_along(way);
    for(std::size_t i = 0; i < places.size(); ++i) {
      const Vector &place = places[i], &next = places[i + 1 < places.size() ? i + 1 : 0];
      if(top != no_index &&
         are_well_within({part.nodes[top].place, part.nodes[top].radius}, place, next)) {
        last = top;
        continue;
      }
      const Free_ball ball = {place, clearance.at(place, most)};
      top = last = add_node(ball, last);
      for(const Free_ball& larger : clearance.risen(ball, most))
        top = add_node(larger, top);
    }
    part.edges.push_back({{last, 0}, 0.f, 0.f});
    return part;
  }

  // No farther apart than balls overlap.
  static std::vector<Vector> places_along(const Cycle_trial& way) {
    std::vector<Vector> places;
    for(std::size_t i = 0; i < way.curve.size(); ++i) {
      const Vector &a = way.curve[i].place,
                   &b = way.curve[i + 1 < way.curve.size() ? i + 1 : 0].place;
      const int n = 1 + static_cast<int>(norm(b - a) / way.radius);
      for(int k = 0; k < n; ++k)
        places.push_back(point_between(a, b, double(k) / n));
    }
    return places;
  }

  void join(Index a, Index b) {
    if(const double radius = Clearance::least_between({nodes[a].place, nodes[a].radius},
                                                      {nodes[b].place, nodes[b].radius});
       a != b && radius > 0.)
      edges.push_back({{a, b}, static_cast<float>(radius), static_cast<float>(radius)});
  }

  void join_neighbors() {
    using Kernel = Exact_predicates_inexact_constructions_kernel;
    using Delaunay = Delaunay_triangulation_3<
        Kernel,
        Triangulation_data_structure_3<Triangulation_vertex_base_with_info_3<Index, Kernel>>>;
    std::vector<std::pair<Delaunay::Point, Index>> places;
    for(const Node& node : nodes)
      places.emplace_back(Delaunay::Point(node.place[0], node.place[1], node.place[2]),
                          static_cast<Index>(places.size()));
    const Delaunay delaunay(places.begin(), places.end());
    // They come in an order, and with a first end, by where cells are in memory.
    std::vector<std::pair<Index, Index>> pairs;
    for(const auto& edge : delaunay.finite_edges())
      pairs.push_back(std::minmax(
          {edge.first->vertex(edge.second)->info(), edge.first->vertex(edge.third)->info()}));
    std::sort(pairs.begin(), pairs.end());
    for(const auto& [a, b] : pairs)
      join(a, b);
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_WAY_NETWORK_H
