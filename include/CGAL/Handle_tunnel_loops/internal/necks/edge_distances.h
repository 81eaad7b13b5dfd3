// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_EDGE_DISTANCES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_EDGE_DISTANCES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Vertices by distance, roughly: those whose distances differ by less than the width of a bucket
/// come in any order. No vertex may be put further ahead than an edge is long.
class Distance_buckets
{
public:
  explicit Distance_buckets(const Flat_mesh& mesh) {
    double longest = 0., sum = 0.;
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      for(Index u : mesh.ring(v)) {
        const double length = mesh.edge_length(u, v);
        longest = (std::max)(longest, length);
        sum += length;
      }
    constexpr double most_buckets = 4096.;
    width_ = static_cast<float>(
        (std::max)(sum / static_cast<double>(mesh.neighbor.size()), longest / most_buckets));
    if(!(width_ > 0.f))
      width_ = 1.f;
    buckets_.resize(static_cast<std::size_t>(longest / width_) + 3);
  }

  void push(float distance, Index v) {
    buckets_[static_cast<std::size_t>(distance / width_) % buckets_.size()].push_back(v);
    ++size_;
  }

  bool empty() const { return size_ == 0; }

  Index pop() {
    while(buckets_[current_].empty())
      current_ = current_ + 1 == buckets_.size() ? 0 : current_ + 1;
    const Index v = buckets_[current_].back();
    buckets_[current_].pop_back();
    --size_;
    return v;
  }

private:
  float width_;
  std::vector<std::vector<Index>> buckets_;
  std::size_t current_ = 0, size_ = 0;
};

/// the distances of all vertices from the nearest of the sources, along edges. There is to be a
/// source in each component.
inline std::vector<float> edge_distances(const Flat_mesh& mesh, const std::vector<Index>& sources) {
  std::vector<float> distance(mesh.number_of_vertices(), std::numeric_limits<float>::infinity());
  std::vector<char> is_waiting(mesh.number_of_vertices(), 0);
  Distance_buckets buckets(mesh);
  const auto reach = [&](Index v, float d) {
    distance[v] = d;
    is_waiting[v] = 1;
    buckets.push(d, v);
  };
  for(Index v : sources)
    reach(v, 0.f);
  while(!buckets.empty()) {
    const Index v = buckets.pop();
    if(!std::exchange(is_waiting[v], char(0)))
      continue;
    for(Index u : mesh.ring(v)) {
      const float d = distance[v] + static_cast<float>(mesh.edge_length(v, u));
      if(d < distance[u])
        reach(u, d);
    }
  }
  return distance;
}

/// the furthest vertex of each component; the first in the caller's order of several.
inline std::vector<Index> furthest_vertices(const Flat_mesh& mesh,
                                            const std::vector<float>& distance) {
  std::vector<Index> furthest = mesh.seeds;
  for(Index v = 0; v < distance.size(); ++v) {
    Index& best = furthest[mesh.component[v]];
    if(distance[v] > distance[best] ||
       (distance[v] == distance[best] && mesh.original[v] < mesh.original[best]))
      best = v;
  }
  return furthest;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_EDGE_DISTANCES_H
