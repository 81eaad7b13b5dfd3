// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOP_RAIL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOP_RAIL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Crossing_loop.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The closed walks on the edges along either side of a loop, for going from one place beside the
/// loop to another the short way.
class Loop_rail
{
public:
  /// The end of a crossing that lies on one side of the loop.
  using End = Index Crossing::*;
  static constexpr End left = &Crossing::left, right = &Crossing::right;

  /// remembers where the loop is and how long its left side is.
  void measure(const Flat_mesh& mesh, const Crossing_loop& loop) {
    loop_ = &loop;
    along_.resize(loop.size() + 1);
    along_[0] = 0.;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const Index u = loop[i].left, v = loop[i + 1 == loop.size() ? 0 : i + 1].left;
      along_[i + 1] = along_[i] + mesh.edge_length(u, v);
    }
  }

  /// appends the walk along one `side`, from the crossing of which `from` is the end `from_end` to
  /// that of which `to` is the end `to_end`: both ends of these two crossings on that side, and
  /// what is between. An end that occurs several times is taken where the walk is shortest.
  void append(End side, End from_end, Index from, End to_end, Index to, std::vector<Index>& walk) {
    find(from_end, from, starts_);
    find(to_end, to, ends_);
    std::size_t first = starts_.front(), last = ends_.front();
    for(std::size_t i : starts_)
      for(std::size_t j : ends_)
        if(distance(i, j) < distance(first, last)) {
          first = i;
          last = j;
        }
    append_the_short_way(side, first, last, walk);
  }

private:
  void find(End end, Index v, std::vector<std::size_t>& places) const {
    places.clear();
    for(std::size_t i = 0; i < loop_->size(); ++i)
      if((*loop_)[i].*end == v)
        places.push_back(i);
  }

  double distance(std::size_t i, std::size_t j) const {
    const double d = std::abs(along_[i] - along_[j]);
    return (std::min)(d, along_.back() - d);
  }

  void
  append_the_short_way(End side, std::size_t from, std::size_t to, std::vector<Index>& walk) const {
    const std::size_t n = loop_->size();
    const double forward = along_[to] - along_[from] + (to < from ? along_.back() : 0.);
    const bool go_forward = forward <= along_.back() - forward;
    walk.push_back((*loop_)[from].*side);
    for(std::size_t i = from; i != to;) {
      i = go_forward ? (i + 1 == n ? 0 : i + 1) : (i == 0 ? n - 1 : i - 1);
      walk.push_back((*loop_)[i].*side);
    }
  }

  const Crossing_loop* loop_ = nullptr;
  std::vector<double> along_; // length of the left side up to each crossing
  std::vector<std::size_t> starts_, ends_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOP_RAIL_H
