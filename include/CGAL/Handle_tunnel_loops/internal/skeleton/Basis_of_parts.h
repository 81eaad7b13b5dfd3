// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_BASIS_OF_PARTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_BASIS_OF_PARTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Linked_edges.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_ways.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Tree_of_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ways_of_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Leads ways of arcs so that the cycles of their graph are a basis of the first homology group of the
solid.

Each arc that is not of a tree closes a cycle. Those that are a part of a basis stay as they are.
Where a cycle is none, as where the contours of its arc bound outside, and all arcs between its
nodes are drawn by the same balls, this arc takes the cheapest other way by which it closes one that
is.
*/
class Basis_of_parts
{
public:
  Basis_of_parts(const Ball_graph& balls,
                 const Linked_edges& linked,
                 const Tree_of_arcs& tree,
                 Ways_of_arcs& drawn)
      : balls_(balls)
      , linked_(linked)
      , tree_(tree)
      , drawn_(drawn) {}

  void close(const Part_ways& part_ways) {
    std::vector<Independent_rows> rows; // by component of the mesh
    for(Index c = 0; c < linked_.number_of_components(); ++c)
      rows.emplace_back(linked_.width(c));
    const std::vector<Row> at_node = tree_.sums_at_nodes<Row>(
        [&](Index node, Index arc) {
          return drawn_.are_ends_drawn(arc) ? row_of(drawn_.from(node, arc)) : Row();
        },
        [](const Row& a, const Row& b) { return sum(a, b); });
    std::vector<Index> others;
    for(Index arc = 0; arc < drawn_.ways.size(); ++arc)
      if(!tree_.has(arc) && drawn_.are_ends_drawn(arc) && linked_.width(component(arc)) > 0 &&
         !rows[component(arc)].add(closed(arc, drawn_.ways[arc], at_node)))
        others.push_back(arc);
    for(const Index arc : others) {
      const auto is_good = [&](const Way& way) {
        return rows[component(arc)].add(closed(arc, way, at_node));
      };
      if(Way way = part_ways.other_way(arc, linked_, is_good); !way.empty())
        drawn_.ways[arc] = std::move(way);
    }
  }

private:
  using Way = Ways_of_arcs::Way;
  using Row = std::vector<int>; ///< linking numbers; empty: none, of any component

  static Row sum(Row a, const Row& b, int factor = 1) {
    a.resize((std::max)(a.size(), b.size()), 0);
    for(std::size_t i = 0; i < b.size(); ++i)
      a[i] += factor * b[i];
    return a;
  }

  Index component(Index arc) const {
    return balls_.component[drawn_.ball_of_node[drawn_.graph.arcs[arc][0]]];
  }

  Row row_of(const Way& way) const {
    Row row(linked_.width(balls_.component[way.front()]), 0);
    linked_.add(way, 1, row);
    return row;
  }

  // Of the cycle that a way of an arc closes.
  Row closed(Index arc, const Way& way, const std::vector<Row>& at_node) const {
    const auto [lower, upper] = drawn_.graph.arcs[arc];
    return sum(sum(row_of(way), at_node[lower]), at_node[upper], -1);
  }

  const Ball_graph& balls_;
  const Linked_edges& linked_;
  const Tree_of_arcs& tree_;
  Ways_of_arcs& drawn_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_BASIS_OF_PARTS_H
