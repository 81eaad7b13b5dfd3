// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Covered_region.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/*!
The fronts: the components of the boundary of a region (paper, section 5).

The boundary has a piece in each triangle with one or two covered vertices. These are the nodes of a
graph; they are adjacent where they share a crossed edge, and its connected components are the
fronts. Each is a simple closed curve, however coarse the mesh. (A triangle with vertices that are
covered but not linked may have more than one piece. So the nodes are the places at which the
boundary comes into a triangle.)
*/
class Fronts
{
public:
  explicit Fronts(const Covered_region& region)
      : region_(region)
      , node_(region.mesh().neighbor.size(), no_index) {
    find_nodes();
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
    Graph graph(crossings_.size());
    for(Index i = 0; i < crossings_.size(); ++i)
      boost::add_edge(i, node(region.next(crossings_[i])), graph);
    front_.resize(crossings_.size());
    number_ = static_cast<Index>(boost::connected_components(graph, front_.data()));
  }

  Index number_of_fronts() const { return number_; }

  /// all edges that are crossed.
  const std::vector<Crossing>& crossings() const { return crossings_; }

  /// the number of the front that crosses an edge.
  Index front(const Crossing& c) const { return front_[node(c)]; }

  /// the front from one of its crossings on, with the covered vertices on its left.
  Crossing_loop loop(const Crossing& start) const {
    Crossing_loop loop;
    Crossing c = start;
    do {
      loop.push_back(c);
      c = region_.next(c);
    } while(c.left != start.left || c.right != start.right);
    return loop;
  }

private:
  void find_nodes() {
    const Flat_mesh& mesh = region_.mesh();
    for(Index u = 0; u < mesh.number_of_vertices(); ++u)
      if(region_.contains(u))
        for(Index i = mesh.row_begin[u]; i < mesh.row_begin[u + 1]; ++i)
          if(!region_.are_linked(u, mesh.neighbor[i])) {
            node_[i] = static_cast<Index>(crossings_.size());
            crossings_.push_back({u, mesh.neighbor[i], 0.5});
          }
  }

  Index node(const Crossing& c) const { return node_[slot(region_.mesh(), c.left, c.right)]; }

  const Covered_region& region_;
  std::vector<Index> node_; // by slot
  std::vector<Crossing> crossings_;
  std::vector<Index> front_; // by node
  Index number_ = 0;
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FRONTS_H
