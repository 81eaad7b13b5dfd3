// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_MATCH_LOOPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_MATCH_LOOPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Loop_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Flat_pair.h>

#include <CGAL/assertions.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// pairs the loops of a basis so that each pair crosses once, if that can be, or else an odd number
/// of times, which always can: a skew-symmetric matrix of determinant 1 has an odd Pfaffian, and
/// that is a sum over matchings.
inline void match_loops(const Flat_mesh& mesh, std::vector<Flat_pair>& pairs) {
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  std::vector<Crossing_loop> loops;
  for(Flat_pair& pair : pairs) {
    loops.push_back(std::move(pair.handle));
    loops.push_back(std::move(pair.tunnel));
  }
  const Loop_classes classes(mesh, loops);
  for(const bool once : {true, false}) {
    Graph graph(loops.size());
    for(Index i = 0; i < loops.size(); ++i)
      for(const auto& [j, number] : classes.row(i))
        if(i < j && (once ? number == 1 || number == -1 : number % 2 != 0))
          add_edge(i, j, graph);
    std::vector<Graph::vertex_descriptor> mates(loops.size());
    boost::edmonds_maximum_cardinality_matching(graph, mates.data());
    if(2 * boost::matching_size(graph, mates.data()) < loops.size())
      continue;
    pairs.clear();
    for(std::size_t i = 0; i < mates.size(); ++i)
      if(i < mates[i])
        pairs.push_back({std::move(loops[i]), std::move(loops[mates[i]])});
    return;
  }
  CGAL_assertion_msg(false, "the loops are a basis");
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_MATCH_LOOPS_H
