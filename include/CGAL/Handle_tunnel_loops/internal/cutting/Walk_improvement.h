// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_WALK_IMPROVEMENT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_WALK_IMPROVEMENT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/shortest_walk_beside.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Makes a closed walk of halfedges shorter, and simpler, in its homotopy class. There is one kind of
change: instead of passing a vertex, the walk goes around it on one side, along the edges opposite
to the vertex, which is a homotopy over the faces there.

\tparam Length a function: halfedge -> length
*/
template <typename TriangleMesh, typename Length> class Walk_improvement
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  using Walk = std::vector<halfedge_descriptor>;

  Walk_improvement(const TriangleMesh& tm, const Length& length, Walk walk)
      : tm_(tm)
      , length_(length)
      , walk_(std::move(walk)) {}

  /// takes out steps there and back, and goes around vertices where that is shorter.
  void shorten() {
    std::size_t since_change = 0;
    for(std::size_t i = 0; walk_.size() >= 2 && since_change < walk_.size();) {
      i %= walk_.size();
      if(pass_shorter(i)) {
        since_change = 0;
        i = i == 0 ? 0 : i - 1;
      } else {
        ++since_change;
        ++i;
      }
    }
  }

  /// goes around vertices that the walk has passed already, over vertices that it does not pass, by
  /// the shortest way there is, until no vertex is passed twice or no such way is left.
  void separate() {
    visits_.clear();
    for(const halfedge_descriptor h : walk_)
      ++visits_[target(h, tm_)];
    for(Detour best = best_detour(); !best.path.empty(); best = best_detour()) {
      const std::size_t next = following(best.place);
      --visits_[target(walk_[best.place], tm_)];
      for(std::size_t k = 0; k + 1 < best.path.size(); ++k)
        ++visits_[target(best.path[k], tm_)];
      replace(best.place, next, best.path);
    }
  }

  const Walk& walk() const { return walk_; }

private:
  struct Detour
  {
    std::size_t place = 0;
    double gain = -(std::numeric_limits<double>::infinity)();
    Walk path;
  };

  std::size_t following(std::size_t i) const { return i + 1 == walk_.size() ? 0 : i + 1; }

  // The way around the vertex between two halfedges, on its left; empty if it is longer than that,
  // or if there is the boundary.
  Walk left_of(halfedge_descriptor in, halfedge_descriptor out, double most, double& sum) const {
    using CGAL::is_border;
    Walk path;
    sum = 0.;
    for(halfedge_descriptor h = in;; h = opposite(next(h, tm_), tm_)) {
      if(is_border(h, tm_))
        return Walk();
      path.push_back(opposite(prev(h, tm_), tm_));
      sum += length_(path.back());
      if(sum > most)
        return Walk();
      if(next(h, tm_) == out)
        return path;
    }
  }

  Walk right_of(halfedge_descriptor in, halfedge_descriptor out, double most, double& sum) const {
    Walk path = left_of(opposite(out, tm_), opposite(in, tm_), most, sum);
    std::reverse(path.begin(), path.end());
    for(halfedge_descriptor& h : path)
      h = opposite(h, tm_);
    return path;
  }

  // The i-th halfedge and the next one become this path.
  void replace(std::size_t i, std::size_t next, const Walk& path) {
    if(next == 0) { // the last and the first
      walk_.pop_back();
      walk_.erase(walk_.begin());
      walk_.insert(walk_.end(), path.begin(), path.end());
      return;
    }
    const auto at = walk_.erase(walk_.begin() + i, walk_.begin() + next + 1);
    walk_.insert(at, path.begin(), path.end());
  }

  bool pass_shorter(std::size_t i) {
    const std::size_t next = following(i);
    const halfedge_descriptor in = walk_[i], out = walk_[next];
    if(in == opposite(out, tm_)) {
      replace(i, next, Walk());
      return true;
    }
    // So much shorter that roundings cannot lead around in circles.
    const double most = (1. - 1e-12) * (length_(in) + length_(out));
    for(const bool left : {true, false}) {
      double sum;
      const Walk path = left ? left_of(in, out, most, sum) : right_of(in, out, most, sum);
      if(!path.empty() && sum < most) {
        replace(i, next, path);
        return true;
      }
    }
    return false;
  }

  bool is_over_free_vertices(const Walk& path) const {
    for(std::size_t k = 0; k + 1 < path.size(); ++k) {
      const auto it = visits_.find(target(path[k], tm_));
      if(it != visits_.end() && it->second > 0)
        return false;
    }
    return !path.empty();
  }

  Detour best_detour() const {
    Detour best;
    const double any = (std::numeric_limits<double>::infinity)();
    for(std::size_t i = 0; i < walk_.size(); ++i) {
      if(visits_.at(target(walk_[i], tm_)) < 2)
        continue;
      const halfedge_descriptor in = walk_[i], out = walk_[following(i)];
      for(const bool left : {true, false}) {
        double sum;
        Walk path = left ? left_of(in, out, any, sum) : right_of(in, out, any, sum);
        const double gain = length_(in) + length_(out) - sum;
        if(gain > best.gain && is_over_free_vertices(path))
          best = {i, gain, std::move(path)};
      }
    }
    return best;
  }

  const TriangleMesh& tm_;
  const Length& length_;
  Walk walk_;
  std::map<vertex_descriptor, int> visits_;
};

/// turns a loop on a mesh into a closed walk on its edges, in time proportional to the loop,
/// whatever the size of the mesh: the best one by ends of the edges that it passes, improved.
template <typename Loop, typename TriangleMesh, typename VertexPointMap>
auto halfedges_of_loop(const Loop& loop, const TriangleMesh& tm, VertexPointMap point) {
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  std::vector<vertex_descriptor> ends; // by number
  for(const auto& step : loop.steps()) {
    ends.push_back(source(step.halfedge, tm));
    ends.push_back(target(step.halfedge, tm));
  }
  make_set(ends);
  const auto number = [&](vertex_descriptor v) {
    return static_cast<Index>(std::lower_bound(ends.begin(), ends.end(), v) - ends.begin());
  };
  const auto distance = [&](vertex_descriptor u, vertex_descriptor v) {
    return norm(coordinates(point, v) - coordinates(point, u));
  };
  const std::vector<Index> walk = shortest_walk_beside(
      ends_beside(loop, tm, number), [&](Index u, Index v) { return distance(ends[u], ends[v]); });
  std::vector<halfedge_descriptor> halfedges;
  for(std::size_t i = 0; i < walk.size() && walk.size() > 1; ++i) {
    const auto [h, is_edge] = halfedge(ends[walk[i]], ends[walk[(i + 1) % walk.size()]], tm);
    if(!is_edge)
      throw std::invalid_argument("consecutive places of the loop have no common face");
    halfedges.push_back(h);
  }
  const auto length = [&](halfedge_descriptor h) { return distance(source(h, tm), target(h, tm)); };
  Walk_improvement improvement(tm, length, std::move(halfedges));
  improvement.shorten();
  improvement.separate();
  return improvement.walk();
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_WALK_IMPROVEMENT_H
