// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_CYCLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_CYCLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_borders.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Part_ways.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ways_in_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ways_of_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Leads ways of arcs around as the cycles of their graph are.

Each arc that is not of a tree closes a cycle of it: this is to be linked with a border of the arc,
and with none of the other such arcs, if there is a way inside. There is none where the border
bounds outside.
*/
class Part_cycles
{
public:
  Part_cycles(Execution execution,
              const Solid_balls& solid,
              const Ball_graph& balls,
              const Part_balls& part_balls,
              Ways_of_arcs& drawn)
      : execution_(execution)
      , solid_(solid)
      , balls_(balls)
      , part_balls_(part_balls)
      , graph_(drawn.graph)
      , drawn_(drawn) {}

  void close(const Part_ways& part_ways) {
    const std::vector<char> is_in_tree = arcs_of_tree();
    const std::vector<Part_borders::Curve> borders = borders_of_others(is_in_tree);
    const Ways_in_classes classes(execution_, balls_, borders);
    const std::vector<Ways_in_classes::Name> names = names_of_nodes(classes, is_in_tree);
    auto pool = part_ways.workspaces();
    for_each_index(
        execution_, drawn_.ways.size(),
        [&](std::size_t i) {
          const Index arc = static_cast<Index>(i);
          const auto [lower, upper] = graph_.arcs[arc];
          if(borders[arc].empty() || drawn_.ball_of_node[lower] == no_index ||
             drawn_.ball_of_node[upper] == no_index)
            return;
          const Ways_in_classes::Name off = names[upper] - names[lower];
          const std::array<Ways_in_classes::Name, 2> wanted = {off + classes.key(arc),
                                                               off - classes.key(arc)};
          if(const auto name = classes.name(drawn_.ways[arc]);
             name != wanted[0] && name != wanted[1])
            if(const auto way = part_ways.around(arc, classes, wanted, *pool.borrow());
               !way.empty())
              drawn_.ways[arc] = way;
        },
        4);
  }

private:
  // Arcs of a tree, those of large parts first.
  std::vector<char> arcs_of_tree() const {
    std::vector<Index> order(graph_.arcs.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(), [this](Index a, Index b) {
      return part_balls_.number(a) > part_balls_.number(b);
    });
    std::vector<char> is_in_tree(order.size(), 0);
    Sets_of_indices sets(graph_.vertex_of_node.size());
    for(const Index arc : order) {
      const auto [lower, upper] = graph_.arcs[arc];
      is_in_tree[arc] = sets.find(lower) != sets.find(upper);
      sets.unite(lower, upper);
    }
    return is_in_tree;
  }

  // Curves around those that are not of the tree.
  std::vector<Part_borders::Curve> borders_of_others(const std::vector<char>& is_in_tree) const {
    std::vector<Index> part_of_vertex = graph_.arc_of_vertex;
    for(Index v = solid_.mesh().first_hub; v < part_of_vertex.size(); ++v)
      part_of_vertex[v] = part_of_vertex[solid_.mesh().ring(v)[0]];
    std::vector<char> is_other(is_in_tree.size());
    for(std::size_t a = 0; a < is_other.size(); ++a)
      is_other[a] = is_in_tree[a] == 0;
    return Part_borders(solid_.mesh(), solid_.points(), part_of_vertex)(is_other);
  }

  // Those of the ways in the tree that lead to them.
  std::vector<Ways_in_classes::Name> names_of_nodes(const Ways_in_classes& classes,
                                                    const std::vector<char>& is_in_tree) const {
    std::vector<Ways_in_classes::Name> names(graph_.vertex_of_node.size(), 0);
    std::vector<char> is_reached(names.size(), 0);
    for(Index root = 0; root < names.size(); ++root) {
      if(is_reached[root])
        continue;
      is_reached[root] = 1;
      std::vector<Index> reached = {root};
      for(std::size_t i = 0; i < reached.size(); ++i)
        for(const Index arc : drawn_.arcs_at[reached[i]]) {
          const auto [lower, upper] = graph_.arcs[arc];
          const Index other = lower == reached[i] ? upper : lower;
          if(is_in_tree[arc] == 0 || is_reached[other])
            continue;
          is_reached[other] = 1;
          names[other] = names[reached[i]] + classes.name(drawn_.from(reached[i], arc));
          reached.push_back(other);
        }
    }
    return names;
  }

  Execution execution_;
  const Solid_balls& solid_;
  const Ball_graph& balls_;
  const Part_balls& part_balls_;
  const Graph_of_parts& graph_;
  Ways_of_arcs& drawn_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_CYCLES_H
