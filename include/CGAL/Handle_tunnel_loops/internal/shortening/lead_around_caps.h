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

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Where loops cross caps they are led along the boundary, on one side of the hub or on the other.
class Ways_around_caps
{
public:
  explicit Ways_around_caps(const Flat_mesh& mesh)
      : mesh_(mesh) {}

  /// leads a loop without backtracks around each cap that it crosses the shorter way, so that it
  /// enters none any more. A homotopy on the surface with its caps. Linear in the number of edges
  /// that are crossed, before and after.
  void lead(Crossing_loop& loop) const {
    if(!begin_outside(loop))
      return loop.clear();
    Crossing_loop result;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      std::size_t out = i + 1;
      while(out < loop.size() && is_spoke(loop[out]))
        ++out;
      if(out == i + 1)
        result.push_back(loop[i]);
      else {
        append_way(loop[i], {loop.begin() + i + 1, loop.begin() + out}, loop[out], result);
        i = out;
      }
    }
    loop = std::move(result);
    remove_backtracks(loop);
  }

private:
  static constexpr double never = (std::numeric_limits<double>::max)();

  bool is_spoke(const Crossing& c) const { return mesh_.is_spoke(c.left, c.right); }

  // Rotates the loop so that it is not in a cap, nor comes out of one, at its beginning. There is
  // no such place if it runs around a hub.
  bool begin_outside(Crossing_loop& loop) const {
    for(std::size_t i = 0; i < loop.size(); ++i)
      if(!is_spoke(loop[i]) && !is_spoke(loop[i == 0 ? loop.size() - 1 : i - 1])) {
        std::rotate(loop.begin(), loop.begin() + i, loop.end());
        return true;
      }
    return false;
  }

  // Along vertices of the boundary, with the hub to the right or to the left.
  struct Way
  {
    std::vector<Index> vertices;
    double length = 0.;
  };

  // By one edge into a cap, across spokes, and by another edge out.
  void append_way(const Crossing& in,
                  const Crossing_loop& spokes,
                  const Crossing& out,
                  Crossing_loop& result) const {
    if(is_backtrack(in, out)) // once around the hub is no way at all
      return;
    const bool is_hub_right = mesh_.is_hub(spokes.front().right);
    const Index hub = is_hub_right ? spokes.front().right : spokes.front().left;
    const auto way_on = [&](bool has_hub_right, double longest) {
      return has_hub_right ? way(hub, in.left, out.left, true, longest)
                           : way(hub, in.right, out.right, false, longest);
    };
    const Way own = way_on(is_hub_right, never), other = way_on(!is_hub_right, own.length);
    const bool is_right = is_hub_right == (own.length <= other.length);
    const Way& best = own.length <= other.length ? own : other;
    append_beside(best.vertices, is_right ? in.right : in.left, is_right ? out.right : out.left,
                  is_right, result);
  }

  // Unless it is longer; then some part of it.
  Way way(Index hub, Index from, Index to, bool is_hub_right, double longest) const {
    Way way = {{from}, 0.};
    while(way.vertices.back() != to && way.length <= longest) {
      const Index v = way.vertices.back();
      const Ring ring = mesh_.ring(v);
      way.vertices.push_back(is_hub_right ? ring.after(hub) : ring.before(hub));
      way.length += mesh_.edge_length(v, way.vertices.back());
    }
    if(way.vertices.back() != to)
      way.length = never;
    return way;
  }

  // On the surface, with the way between the loop and the hub. It comes from one vertex of the
  // boundary and goes on to another.
  void append_beside(const std::vector<Index>& way,
                     Index from,
                     Index to,
                     bool is_hub_right,
                     Crossing_loop& result) const {
    for(std::size_t i = 0; i < way.size(); ++i) {
      const Index v = way[i], end = i + 1 == way.size() ? to : way[i + 1];
      const Ring ring = mesh_.ring(v);
      Index p = ring.position(i == 0 ? from : way[i - 1]);
      const auto step = [&] { p = is_hub_right ? ring.previous(p) : ring.next(p); };
      for(step(); ring[p] != end; step())
        result.push_back(is_hub_right ? Crossing{ring[p], v, 1.} : Crossing{v, ring[p], 0.});
    }
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
