// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long the shortest closed walk along edges is that is homologous to a boundary curve, by the
// definition: ways with the coordinates of their classes, all of them.

#ifndef HTL_TEST_WALK_OF_CLASS_ORACLE_H
#define HTL_TEST_WALK_OF_CLASS_ORACLE_H

#include "Edge_walks.h"
#include "Homology_by_collapse.h"

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

/// For small connected surfaces with several boundary curves: exponential in the length.
template <typename TriangleMesh> class Walk_of_class_oracle
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Vertex = typename Traits::vertex_descriptor;
  using Class = std::vector<Integer>;
  using Walk = Edge_walk<TriangleMesh>;

public:
  explicit Walk_of_class_oracle(const TriangleMesh& tm)
      : tm_(tm)
      , homology_(tm) {
    const std::map<Vertex, Walk> tree = ways_from({*vertices(tm).begin()});
    for(const Halfedge h : halfedges(tm)) {
      Walk walk = tree.at(source(h, tm));
      walk.push_back(h);
      const Walk& back = tree.at(target(h, tm));
      for(auto it = back.rbegin(); it != back.rend(); ++it)
        walk.push_back(opposite(*it, tm));
      class_of_[h] = homology_.coordinates(walk);
    }
  }

  /// nothing if none is shorter than a length.
  std::optional<double> shortest(const Walk& curve, double length) const {
    const Class wanted = homology_.coordinates(curve);
    std::optional<double> best;
    for(const Vertex v : way_to_another(curve))
      if(const auto found = shortest_through(v, wanted, best.value_or(length)))
        best = found;
    return best;
  }

private:
  double length(Halfedge h) const {
    const auto point = get(CGAL::vertex_point, tm_);
    return std::sqrt(CGAL::to_double(
        CGAL::squared_distance(get(point, source(h, tm_)), get(point, target(h, tm_)))));
  }

  std::map<Vertex, Walk> ways_from(const std::vector<Vertex>& starts) const {
    std::map<Vertex, Walk> ways;
    std::queue<Vertex> open;
    for(const Vertex v : starts) {
      ways[v];
      open.push(v);
    }
    for(; !open.empty(); open.pop())
      for(const Halfedge h : CGAL::halfedges_around_source(open.front(), tm_))
        if(ways.count(target(h, tm_)) == 0) {
          Walk way = ways[open.front()];
          way.push_back(h);
          ways[target(h, tm_)] = way;
          open.push(target(h, tm_));
        }
    return ways;
  }

  // What is homologous to the curve crosses every way from it to another curve, once more often
  // from one side than from the other. So it has a vertex on each way along edges.
  std::vector<Vertex> way_to_another(const Walk& curve) const {
    std::vector<Vertex> starts;
    for(const Halfedge h : curve)
      starts.push_back(source(h, tm_));
    for(const auto& [v, way] : ways_from(starts))
      if(!way.empty() && is_on_boundary(v)) {
        std::vector<Vertex> result(1, v);
        for(const Halfedge h : way)
          result.push_back(source(h, tm_));
        return result;
      }
    return {};
  }

  bool is_on_boundary(Vertex v) const {
    for(const Halfedge h : CGAL::halfedges_around_source(v, tm_))
      if(is_border(h, tm_))
        return true;
    return false;
  }

  std::optional<double> shortest_through(Vertex start, const Class& wanted, double limit) const {
    using Place = std::pair<Vertex, Class>;
    std::map<Place, double> done;
    std::priority_queue<std::pair<double, Place>, std::vector<std::pair<double, Place>>,
                        std::greater<>>
        open;
    open.push({0., {start, Class(wanted.size(), 0)}});
    while(!open.empty()) {
      const auto [distance, place] = open.top();
      open.pop();
      if(!done.emplace(place, distance).second)
        continue;
      if(place == Place(start, wanted))
        return distance;
      for(const Halfedge h : CGAL::halfedges_around_source(place.first, tm_)) {
        const double sum = distance + length(h);
        if(!(sum < limit))
          continue;
        Place next(target(h, tm_), place.second);
        for(std::size_t i = 0; i < wanted.size(); ++i)
          next.second[i] += class_of_.at(h)[i];
        if(done.count(next) == 0)
          open.push({sum, next});
      }
    }
    return std::nullopt;
  }

  const TriangleMesh& tm_;
  Homology_by_collapse<TriangleMesh> homology_;
  std::map<Halfedge, Class> class_of_; // closed by ways in a tree
};

#endif // HTL_TEST_WALK_OF_CLASS_ORACLE_H
