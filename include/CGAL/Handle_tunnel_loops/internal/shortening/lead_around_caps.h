// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_LEAD_AROUND_CAPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_LEAD_AROUND_CAPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Where loops cross caps they run along the boundary, on one side of the hub or on the other.
class Ways_around_caps
{
public:
  explicit Ways_around_caps(const Flat_mesh& mesh)
      : mesh_(mesh) {}

  /// leads a loop around each cap that it crosses the shorter way. A homotopy on the surface with
  /// its caps. Linear in the number of edges that are crossed, before and after.
  void lead(Crossing_loop& loop) const {
    const auto is_spoke = [this](const Crossing& c) { return mesh_.is_spoke(c.left, c.right); };
    const auto start = std::find_if_not(loop.begin(), loop.end(), is_spoke);
    if(start == loop.end()) // around one hub
      return loop.clear();
    std::rotate(loop.begin(), start, loop.end());
    Crossing_loop result;
    for(std::size_t i = 0; i < loop.size();) {
      std::size_t end = i + 1;
      while(end < loop.size() && is_spoke(loop[end]))
        ++end;
      result.push_back(loop[i]);
      if(end > i + 1)
        add_shorter_way(loop, i, end, result);
      i = end;
    }
    loop = std::move(result);
    remove_backtracks(loop);
  }

private:
  // From crossing `before`, by which the loop comes into a cap, to `after`, by which it leaves it.
  void add_shorter_way(const Crossing_loop& loop,
                       std::size_t before,
                       std::size_t after,
                       Crossing_loop& result) const {
    const Crossing &in = loop[before], &out = loop[after == loop.size() ? 0 : after];
    const bool is_hub_right = mesh_.is_hub(loop[before + 1].right);
    double length = 0.;
    for(std::size_t i = before + 2; i < after; ++i)
      length += is_hub_right ? mesh_.edge_length(loop[i - 1].left, loop[i].left)
                             : mesh_.edge_length(loop[i - 1].right, loop[i].right);
    const Index hub = is_hub_right ? loop[before + 1].right : loop[before + 1].left;
    const Crossing_loop other = is_hub_right ? way(hub, in.right, out.right, false, length)
                                             : way(hub, in.left, out.left, true, length);
    if(other.empty())
      result.insert(result.end(), loop.begin() + before + 1, loop.begin() + after);
    else
      result.insert(result.end(), other.begin(), other.end());
  }

  // Along the boundary, with the hub to the right or to the left; empty if it is not shorter.
  Crossing_loop way(Index hub, Index from, Index to, bool is_hub_right, double longest) const {
    Crossing_loop crossings;
    double length = 0.;
    for(Index v = from; length < longest;) {
      crossings.push_back(is_hub_right ? Crossing{v, hub, 0.} : Crossing{hub, v, 1.});
      if(v == to)
        return crossings;
      const Index next = is_hub_right ? mesh_.ring(v).after(hub) : mesh_.ring(v).before(hub);
      length += mesh_.edge_length(v, next);
      v = next;
    }
    return {};
  }

  const Flat_mesh& mesh_;
};

inline void lead_around_caps(const Flat_mesh& mesh, Crossing_loop& loop) {
  if(mesh.number_of_hubs > 0)
    Ways_around_caps(mesh).lead(loop);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_LEAD_AROUND_CAPS_H
