// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_ARC_CONTRACTION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_ARC_CONTRACTION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <CGAL/assertions.h>

#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// An arc of a graph, and how large the part of the surface is that it stands for.
struct Sized_arc
{
  Index lower, upper; ///< nodes
  double area = 0.;
  double girth = 0.; ///< the length of its contours, in the mean

  /// the length of a cylinder with that area and girth, as a multiple of its radius.
  double slenderness() const {
    constexpr double two_pi = 6.283185307179586;
    if(!(area > 0.))
      return 0.;
    return girth > 0. ? two_pi * area / (girth * girth) : (std::numeric_limits<double>::max)();
  }
};

/// Two parts of a surface that meet along so much.
struct Shared_border
{
  Index part, other;
  double length;
};

/*!
Contracts arcs of a graph that are shorter than thick: their two nodes become one, and their part of
the surface goes to the arc there with which it shares most of its border. The shortest goes first;
arcs grow meanwhile. Leaves stay, and arcs from a node to itself, as the last ones of cycles become:
hence the graph keeps its components and its cycles.
*/
class Arc_contraction
{
public:
  /// \p borders are those of parts that meet, each pair once.
  Arc_contraction(std::size_t number_of_nodes,
                  std::vector<Sized_arc> arcs,
                  const std::vector<Shared_border>& borders)
      : arcs_(std::move(arcs))
      , borders_(arcs_.size())
      , is_kept_(arcs_.size(), 1)
      , became_(arcs_.size())
      , nodes_(number_of_nodes)
      , degree_(number_of_nodes, 0)
      , girth_(number_of_nodes, 0.)
      , widest_(number_of_nodes) {
    std::iota(became_.begin(), became_.end(), Index(0));
    std::iota(widest_.begin(), widest_.end(), Index(0));
    for(const Sized_arc& arc : arcs_)
      for(const Index node : {arc.lower, arc.upper}) {
        ++degree_[node];
        girth_[node] += arc.girth;
      }
    for(const auto& [part, other, length] : borders)
      borders_[part][other] = borders_[other][part] = length;
  }

  /// contracts arcs that are less long than so many times their radius.
  void run(double shortest) {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto push = [&](Index a) {
      if(arcs_[a].slenderness() < shortest)
        queue.push({arcs_[a].slenderness(), a});
    };
    for(Index a = 0; a < arcs_.size(); ++a)
      push(a);
    while(!queue.empty()) {
      const auto [slenderness, a] = queue.top();
      queue.pop();
      if(is_kept(a) && can_go(a) && arcs_[a].slenderness() == slenderness)
        if(const Index heir = contract(a); heir != no_index)
          push(heir);
    }
  }

  bool is_kept(Index arc) const { return is_kept_[arc] != 0; }

  /// how large an arc is that is kept, with the nodes that are left.
  Sized_arc arc(Index a) const {
    Sized_arc arc = arcs_[a];
    arc.lower = node(arc.lower);
    arc.upper = node(arc.upper);
    return arc;
  }

  /// the arc that is kept to which the part of an arc belongs.
  Index owner(Index arc) {
    while(became_[arc] != arc)
      arc = became_[arc] = became_[became_[arc]];
    if(!is_kept(arc)) // it has been the only one with a part
      for(Index other = 0; became_[arc] == arc; ++other)
        if(is_kept(other) && is_at(other, nodes_.find(arcs_[arc].lower)))
          became_[arc] = other;
    return became_[arc];
  }

  /// of the nodes that a node has become one with, that where contours are longest.
  Index node(Index n) const { return widest_[nodes_.find(n)]; }

private:
  bool is_at(Index a, Index node) const {
    return nodes_.find(arcs_[a].lower) == node || nodes_.find(arcs_[a].upper) == node;
  }

  bool can_go(Index a) const {
    const auto& [lower, upper, area, girth] = arcs_[a];
    return degree_[lower] > 1 && degree_[upper] > 1 && nodes_.find(lower) != nodes_.find(upper);
  }

  // Returns the arc that has grown, if one has.
  Index contract(Index a) {
    join_nodes(arcs_[a].lower, arcs_[a].upper);
    is_kept_[a] = 0;
    const Index heir = heir_of(a);
    if(heir == no_index)
      return heir;
    became_[a] = heir;
    Sized_arc &part = arcs_[heir], &rest = arcs_[a];
    const double area = part.area + rest.area;
    if(area > 0.)
      part.girth = (part.area * part.girth + rest.area * rest.girth) / area;
    part.area = area;
    borders_[heir].erase(a);
    borders_[a].erase(heir);
    for(const auto& [other, length] : borders_[a]) {
      borders_[other].erase(a);
      borders_[heir][other] += length;
      borders_[other][heir] += length;
    }
    borders_[a].clear();
    return heir;
  }

  void join_nodes(Index a, Index b) {
    const Index widest = girth_[node(a)] < girth_[node(b)] ? node(b) : node(a);
    nodes_.unite(a, b);
    widest_[nodes_.find(a)] = widest;
  }

  // An arc at the same node, by the length of the common border; none, if there is no border.
  Index heir_of(Index a) const {
    const Index at = nodes_.find(arcs_[a].lower);
    Index heir = no_index;
    std::pair<bool, double> best = {false, 0.};
    for(const auto& [other, length] : borders_[a])
      if(const std::pair<bool, double> value = {is_at(other, at), length};
         heir == no_index || best < value)
      {
        heir = other;
        best = value;
      }
    return heir;
  }

  std::vector<Sized_arc> arcs_;
  std::vector<std::map<Index, double>> borders_; // by arc, with others
  std::vector<char> is_kept_;                    // by arc
  std::vector<Index> became_;                    // by arc
  Sets_of_indices nodes_;
  std::vector<Index> degree_; // by node, at first
  std::vector<double> girth_; // by node, of its arcs at first
  std::vector<Index> widest_; // by node that represents others
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_ARC_CONTRACTION_H
