// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_EDGE_NAMES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_EDGE_NAMES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Ball_network.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linked_segments.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// How the edges of a graph pass through curtains, each as a number (`Linked_segments::name`): of
/// those that were asked for.
class Edge_names
{
public:
  Edge_names(const Ball_network& graph, const Linked_segments& linked)
      : graph_(graph)
      , linked_(linked)
      , names_(graph.edges.size(), unknown) {}

  /// finds those of some edges, of none twice.
  template <typename Iterator> void find(Execution execution, Iterator begin, Iterator end) {
    for_each_index(
        execution, static_cast<std::size_t>(end - begin),
        [&](std::size_t i) {
          const Index e = begin[static_cast<std::ptrdiff_t>(i)];
          if(names_[e] == unknown)
            names_[e] = linked_.name(row(e));
        },
        1024);
  }

  std::uint64_t operator[](Index edge) const { return names_[edge]; }

  /// whether an edge may pass any curtain.
  bool may_pass(Index edge) const { return names_[edge] != 0; }

  Linking_row row(Index edge) const {
    Linking_row row;
    add(graph_.edges[edge].nodes[0], graph_.edges[edge].nodes[1], row);
    return row;
  }

  /// adds to a row what is passed from one node to another.
  void add(Index a, Index b, Linking_row& row) const {
    linked_.add(graph_.nodes[a].place, graph_.nodes[b].place, row);
  }

private:
  static constexpr std::uint64_t unknown = ~std::uint64_t(0);

  const Ball_network& graph_;
  const Linked_segments& linked_;
  std::vector<std::uint64_t> names_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_EDGE_NAMES_H
