// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_CHAINS_OF_ARCS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_CHAINS_OF_ARCS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/draw_inside.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Edges_at.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The same graph without nodes of two arcs. Where they are is free to choose, and no part of the
surface tells: arcs that such nodes join are drawn as one, a chain, which is cut afterwards.
*/
class Chains_of_arcs
{
public:
  explicit Chains_of_arcs(const Graph_of_parts& graph)
      : all_(graph)
      , arcs_at_(graph.vertex_of_node.size(), graph.arcs)
      , chain_(graph.arcs.size(), no_index)
      , number_(graph.vertex_of_node.size(), no_index) {
    for(const bool is_node : {true, false}) { // then cycles without a node
      for(Index n = 0; n < number_.size(); ++n)
        if((arcs_at_[n].size() != 2) == is_node && (is_node || chain_[arcs_at_[n][0]] == no_index))
        {
          number_[n] = static_cast<Index>(graph_.vertex_of_node.size());
          graph_.vertex_of_node.push_back(graph.vertex_of_node[n]);
          if(!is_node)
            follow(n, arcs_at_[n][0]);
        }
      for(Index n = 0; is_node && n < number_.size(); ++n)
        if(number_[n] != no_index)
          for(const Index arc : arcs_at_[n])
            if(chain_[arc] == no_index)
              follow(n, arc);
    }
    for(const Index arc : graph.arc_of_vertex)
      graph_.arc_of_vertex.push_back(arc == no_index ? no_index : chain_[arc]);
  }

  const Graph_of_parts& graph() const { return graph_; }

  /// what has been drawn of the chains, as a drawing of the graph.
  Inner_drawing cut(Inner_drawing&& drawing) const {
    Inner_drawing result;
    result.nodes.resize(number_.size());
    result.lines.resize(chain_.size());
    for(Index n = 0; n < number_.size(); ++n)
      if(number_[n] != no_index)
        result.nodes[n] = drawing.nodes[number_[n]];
    for(std::size_t c = 0; c < chains_.size(); ++c)
      cut(chains_[c], drawing.lines[c], result);
    return result;
  }

private:
  struct Step
  {
    Index arc, begin; ///< the node that it leads away from
  };
  using Line = std::vector<Inner_ball>;

  void follow(Index node, Index arc) {
    std::vector<Step> steps;
    Index last = node;
    do {
      chain_[arc] = static_cast<Index>(chains_.size());
      const auto [lower, upper] = all_.arcs[arc];
      steps.push_back({arc, last});
      last = last == lower ? upper : lower;
      const Span<const Index> arcs = arcs_at_[last];
      arc = arcs[0] == arc ? arcs[arcs.size() - 1] : arcs[0];
    } while(number_[last] == no_index);
    graph_.arcs.push_back({number_[node], number_[last]});
    chains_.push_back(std::move(steps));
  }

  // At bends that divide it about evenly.
  void cut(const std::vector<Step>& chain, Line line, Inner_drawing& result) const {
    const std::size_t number = chain.size();
    while(line.size() <= number)
      halve_longest(line);
    std::vector<double> lengths = {0.}; // up to each point
    for(std::size_t i = 1; i < line.size(); ++i)
      lengths.push_back(lengths.back() + norm(line[i].centre - line[i - 1].centre));
    std::size_t begin = 0;
    for(std::size_t k = 0; k < number; ++k) {
      const double want = lengths.back() * double(k + 1) / double(number);
      std::size_t end = begin + 1;
      while(end + number - k < line.size() && lengths[end] + lengths[end + 1] < 2. * want)
        ++end;
      if(k + 1 == number)
        end = line.size() - 1;
      else
        result.nodes[chain[k + 1].begin] = line[end];
      Line& part = result.lines[chain[k].arc];
      part.assign(line.begin() + std::ptrdiff_t(begin), line.begin() + std::ptrdiff_t(end) + 1);
      if(all_.arcs[chain[k].arc][0] != chain[k].begin)
        std::reverse(part.begin(), part.end());
      begin = end;
    }
  }

  static void halve_longest(Line& line) {
    std::size_t longest = 1;
    const auto length = [&](std::size_t i) { return norm(line[i].centre - line[i - 1].centre); };
    for(std::size_t i = 2; i < line.size(); ++i)
      if(length(i) > length(longest))
        longest = i;
    const Vector middle = 0.5 * (line[longest - 1].centre + line[longest].centre);
    line.insert(line.begin() + std::ptrdiff_t(longest), {middle, 0.});
  }

  const Graph_of_parts& all_;
  Edges_at arcs_at_;          // by node
  std::vector<Index> chain_;  // by arc
  std::vector<Index> number_; // by node, in the graph of the chains, if it is there
  std::vector<std::vector<Step>> chains_;
  Graph_of_parts graph_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_CHAINS_OF_ARCS_H
