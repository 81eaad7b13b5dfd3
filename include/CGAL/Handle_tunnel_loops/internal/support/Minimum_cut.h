// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_MINIMUM_CUT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_MINIMUM_CUT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

// Before compressed_sparse_row_graph.hpp: that has a boost::detail::get(), behind which the sets do
// not see those of property maps.
#include <boost/pending/disjoint_sets.hpp>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The cut of least weight that separates two nodes of a graph, by the theorem of Ford and
/// Fulkerson.
class Minimum_cut
{
public:
  static constexpr Index source = 0, sink = 1;

  /// adds an edge, which a cut may pass either way. The weights of those between the same nodes add
  /// up.
  void add_edge(Index u, Index v, double weight) {
    arcs_.push_back({u, v, weight});
    arcs_.push_back({v, u, weight});
  }

  /// by node, whether it is on the side of the source. Of all cuts of least weight, the one nearest
  /// to the source.
  std::vector<char> source_side(Index number_of_nodes) {
    sort_arcs();
    find_reverses(number_of_nodes);
    return tree_of_source(number_of_nodes);
  }

private:
  using Graph = boost::compressed_sparse_row_graph<boost::directedS,
                                                   boost::no_property,
                                                   boost::no_property,
                                                   boost::no_property,
                                                   Index>;

  struct Arc
  {
    Index from, to;
    double weight;
  };

  void sort_arcs() {
    std::stable_sort(arcs_.begin(), arcs_.end(), [](const Arc& a, const Arc& b) {
      return std::tie(a.from, a.to) < std::tie(b.from, b.to);
    });
    std::size_t kept = 0;
    for(const Arc& arc : arcs_)
      if(kept > 0 && arcs_[kept - 1].from == arc.from && arcs_[kept - 1].to == arc.to)
        arcs_[kept - 1].weight += arc.weight;
      else
        arcs_[kept++] = arc;
    arcs_.resize(kept);
  }

  // Arcs sorted by where they lead are, in this order, the reverses of those sorted by where they
  // come from.
  void find_reverses(Index number_of_nodes) {
    std::vector<Index> place(number_of_nodes + 1, 0);
    for(const Arc& arc : arcs_)
      ++place[arc.to + 1];
    for(std::size_t v = 1; v < place.size(); ++v)
      place[v] += place[v - 1];
    reverse_.resize(arcs_.size());
    for(Index a = 0; a < arcs_.size(); ++a)
      reverse_[place[arcs_[a].to]++] = a;
  }

  // What can be reached from the source when no more flow fits.
  std::vector<char> tree_of_source(Index number_of_nodes) const {
    std::vector<std::pair<Index, Index>> ends(arcs_.size());
    std::vector<double> weight(arcs_.size()), residual(arcs_.size());
    for(std::size_t a = 0; a < arcs_.size(); ++a) {
      ends[a] = {arcs_[a].from, arcs_[a].to};
      weight[a] = arcs_[a].weight;
    }
    Graph graph(boost::edges_are_sorted, ends.begin(), ends.end(), number_of_nodes);
    const auto edge_index = get(boost::edge_index, graph);
    const auto node_index = get(boost::vertex_index, graph);
    using Edge = boost::graph_traits<Graph>::edge_descriptor;
    const auto reverse = boost::make_function_property_map<Edge>(
        [&](const Edge& e) { return Edge(target(e, graph), reverse_[get(edge_index, e)]); });
    std::vector<Edge> previous(number_of_nodes);
    std::vector<boost::default_color_type> color(number_of_nodes);
    std::vector<Index> distance(number_of_nodes);
    boost::boykov_kolmogorov_max_flow(
        graph, boost::make_iterator_property_map(weight.begin(), edge_index),
        boost::make_iterator_property_map(residual.begin(), edge_index), reverse,
        boost::make_iterator_property_map(previous.begin(), node_index),
        boost::make_iterator_property_map(color.begin(), node_index),
        boost::make_iterator_property_map(distance.begin(), node_index), node_index, source, sink);
    std::vector<char> is_in_tree(number_of_nodes);
    for(Index v = 0; v < number_of_nodes; ++v)
      is_in_tree[v] = color[v] == boost::black_color;
    return is_in_tree;
  }

  std::vector<Arc> arcs_;
  std::vector<Index> reverse_; // by arc
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_MINIMUM_CUT_H
