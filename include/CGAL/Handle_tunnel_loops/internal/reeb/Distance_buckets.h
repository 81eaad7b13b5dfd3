// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_DISTANCE_BUCKETS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_DISTANCE_BUCKETS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_DISTANCE_BUCKETS_H
