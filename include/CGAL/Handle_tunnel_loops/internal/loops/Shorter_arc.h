// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_SHORTER_ARC_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_SHORTER_ARC_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The end of a crossing that lies on one side of its loop.
using Crossing_end = Index Crossing::*;

/// The short way along a loop from one of its crossings to another, for host and device alike.
class Shorter_arc
{
public:
  /// \p along is the length of one side of the loop up to each crossing, and at last all of it.
  CGAL_HTL_HOST_DEVICE Shorter_arc(const Crossing* loop, Index size, const double* along)
      : loop_(loop)
      , size_(size)
      , along_(along) {}

  /// sets out from the crossing of which `from` is the end `from_end` to that of which `to` is the
  /// end `to_end`. An end that occurs several times is taken where the way is shortest. Returns
  /// false where there are no such crossings.
  CGAL_HTL_HOST_DEVICE bool find(Crossing_end from_end, Index from, Crossing_end to_end, Index to) {
    first_ = last_ = no_index;
    CGAL_HTL_NO_UNROLL
    for(Index i = 0; i < size_; ++i)
      if(loop_[i].*from_end == from)
        CGAL_HTL_NO_UNROLL
    for(Index j = 0; j < size_; ++j)
      if(loop_[j].*to_end == to && (first_ == no_index || distance(i, j) < distance(first_, last_)))
      {
        first_ = i;
        last_ = j;
      }
    if(first_ == no_index)
      return false;
    const double forward = along_[last_] - along_[first_] + (last_ < first_ ? along_[size_] : 0.);
    is_forward_ = forward <= along_[size_] - forward;
    return true;
  }

  /// calls `f` for the crossings on the way, the first and the last included.
  CGAL_HTL_CALLS_ANY_FUNCTION
  template <typename Function> CGAL_HTL_HOST_DEVICE void for_each(const Function& f) const {
    f(loop_[first_]);
    CGAL_HTL_NO_UNROLL
    for(Index i = first_; i != last_;) {
      i = is_forward_ ? (i + 1 == size_ ? 0 : i + 1) : (i == 0 ? size_ - 1 : i - 1);
      f(loop_[i]);
    }
  }

private:
  CGAL_HTL_HOST_DEVICE double distance(Index i, Index j) const {
    const double d = along_[i] - along_[j], one_way = d < 0. ? -d : d;
    return one_way < along_[size_] - one_way ? one_way : along_[size_] - one_way;
  }

  const Crossing* loop_;
  Index size_;
  const double* along_;
  Index first_ = no_index, last_ = no_index;
  bool is_forward_ = true;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LOOPS_SHORTER_ARC_H
