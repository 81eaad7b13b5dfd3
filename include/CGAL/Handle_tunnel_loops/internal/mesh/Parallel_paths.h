// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_PARALLEL_PATHS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_PARALLEL_PATHS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The closed walks on the edges along either side of a loop, for going from one place beside the
/// loop to another the short way.
class Parallel_paths
{
public:
  using End = Crossing_end;
  static constexpr End left = &Crossing::left, right = &Crossing::right;

  /// remembers where the loop is and how long its left side is.
  void measure(const Flat_mesh& mesh, const Crossing_loop& loop) {
    loop_ = &loop;
    measure_left_side(mesh, loop, along_);
  }

  /// appends the walk along one `side`, from the crossing of which `from` is the end `from_end` to
  /// that of which `to` is the end `to_end`: both ends of these two crossings on that side, and
  /// what is between. An end that occurs several times is taken where the walk is shortest.
  void
  append(End side, End from_end, Index from, End to_end, Index to, std::vector<Index>& walk) const {
    Shorter_arc way(loop_->data(), static_cast<Index>(loop_->size()), along_.data());
    const bool has_found = way.find(from_end, from, to_end, to);
    CGAL_assertion_msg(has_found, "a way must begin and end beside its loop");
    CGAL_USE(has_found);
    way.for_each([&](const Crossing& c) { walk.push_back(c.*side); });
  }

  /// the closed walk from the right side back along `to_right`, then along `to_left` to the left
  /// side, and along that to where it began. The ways start beside each other and end at ends of
  /// crossings.
  std::vector<Index> closed_walk(const std::vector<Index>& to_right,
                                 const std::vector<Index>& to_left) const {
    CGAL_precondition(loop_ != nullptr && !to_right.empty() && !to_left.empty());
    std::vector<Index> walk(to_right.rbegin(), to_right.rend());
    walk.insert(walk.end(), to_left.begin(), to_left.end());
    append(left, left, walk.back(), right, walk.front(), walk);
    remove_spurs(walk);
    return walk;
  }

  /// the length of the left side up to each crossing, and at last all of it.
  const std::vector<double>& along() const { return along_; }

private:
  const Crossing_loop* loop_ = nullptr;
  std::vector<double> along_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_PARALLEL_PATHS_H
