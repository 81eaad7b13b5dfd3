// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_CLOSED_WALKS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_CLOSED_WALKS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A place on an edge: `source + ratio * (target - source)`.
struct Edge_place
{
  Index source, target;
  double ratio;
};

/// Closed walks on the edges, as their vertices in order.
using Closed_walk = std::vector<Index>;

/// whether all steps of a walk are edges of the mesh as it is by now.
inline bool is_intact(const Surgery_mesh& mesh, const Closed_walk& walk) {
  for(std::size_t i = 0; i < walk.size(); ++i)
    if(mesh.halfedge(walk[i], walk[i + 1 == walk.size() ? 0 : i + 1]) == no_index)
      return false;
  return true;
}

/// The shortest closed walk that comes of a loop when each place moves to one of the ends of its
/// edge. As places that follow each other share a face, so do these ends: they are equal or joined
/// by an edge, and the walk is homotopic to the loop.
class Walk_beside_loop
{
public:
  Walk_beside_loop(const Surgery_mesh& mesh, const std::vector<Edge_place>& places)
      : mesh_(mesh)
      , places_(places) {}

  Closed_walk operator()() {
    Closed_walk best;
    double least = (std::numeric_limits<double>::infinity)();
    for(std::size_t end : {0, 1}) {
      if(!is_allowed(places_.front(), end))
        continue;
      const double length = shortest_from(end);
      if(length < least) {
        least = length;
        best = walk_to(end);
      }
    }
    remove_spurs(best);
    return best;
  }

private:
  // A place at a vertex stays there.
  static bool is_allowed(const Edge_place& p, std::size_t end) {
    return p.ratio != (end == 0 ? 1. : 0.);
  }
  static Index vertex(const Edge_place& p, std::size_t end) {
    return end == 0 ? p.source : p.target;
  }
  double distance(Index u, Index v) const {
    return std::sqrt(CGAL::squared_distance(mesh_.point(u), mesh_.point(v)));
  }

  // Dynamic programming once around, back to the end of the first edge that it begins at.
  double shortest_from(std::size_t first_end) {
    constexpr double infinite = (std::numeric_limits<double>::infinity)();
    came_from_.assign(places_.size() + 1, {0, 0});
    std::array<double, 2> lengths{infinite, infinite};
    lengths[first_end] = 0.;
    for(std::size_t i = 1; i <= places_.size(); ++i) {
      const Edge_place &a = places_[i - 1], &b = places_[i == places_.size() ? 0 : i];
      std::array<double, 2> longer{infinite, infinite};
      for(std::size_t to : {0, 1})
        for(std::size_t from : {0, 1}) {
          const double length = lengths[from] + distance(vertex(a, from), vertex(b, to));
          if(is_allowed(b, to) && length < longer[to]) {
            longer[to] = length;
            came_from_[i][to] = from;
          }
        }
      lengths = longer;
    }
    return lengths[first_end];
  }

  Closed_walk walk_to(std::size_t end) const {
    Closed_walk walk;
    for(std::size_t i = places_.size(); i > 0; --i) {
      end = came_from_[i][end];
      walk.push_back(vertex(places_[i - 1], end));
    }
    std::reverse(walk.begin(), walk.end());
    return walk;
  }

  const Surgery_mesh& mesh_;
  const std::vector<Edge_place>& places_;
  std::vector<std::array<std::size_t, 2>> came_from_;
};

/// A part of a closed walk that comes to no vertex twice: the longer part, where there are two.
inline Closed_walk simple_part(Closed_walk walk) {
  std::unordered_map<Index, std::size_t> seen;
  for(std::size_t i = 0; i < walk.size();) {
    const auto [it, is_new] = seen.insert({walk[i], i});
    if(is_new) {
      ++i;
      continue;
    }
    const std::size_t begin = it->second;
    Closed_walk inner(walk.begin() + begin, walk.begin() + i);
    walk.erase(walk.begin() + begin, walk.begin() + i);
    if(inner.size() > walk.size())
      walk.swap(inner);
    remove_spurs(walk);
    seen.clear();
    i = 0;
  }
  return walk;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_CLOSED_WALKS_H
