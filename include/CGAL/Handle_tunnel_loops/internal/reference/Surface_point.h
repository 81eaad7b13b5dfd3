// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_SURFACE_POINT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_SURFACE_POINT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/// A place on the mesh: `a + ratio * (b - a)` on an edge, or a vertex, if `a` is `b`.
struct Surface_point
{
  Index a, b;
  double ratio;

  bool is_vertex() const { return a == b; }
  bool has_end(Index v) const { return a == v || b == v; }
};

inline Surface_point vertex_point(Index v) { return {v, v, 0.}; }

inline bool are_same_vertex(const Surface_point& p, const Surface_point& q) {
  return p.is_vertex() && q.is_vertex() && p.a == q.a;
}

/// takes out, from a closed line, each step from a vertex there and back.
inline void remove_turns(std::vector<Surface_point>& line) {
  for(std::size_t i = 0; i < line.size() && line.size() > 1;) {
    const std::size_t n = line.size(), next = (i + 1) % n, over_next = (i + 2) % n;
    if(are_same_vertex(line[i], line[next])) {
      line.erase(line.begin() + static_cast<std::ptrdiff_t>(next));
      i = 0;
    } else if(n > 2 && line[next].is_vertex() && are_same_vertex(line[i], line[over_next])) {
      line.erase(line.begin() + static_cast<std::ptrdiff_t>((std::max)(next, over_next)));
      line.erase(line.begin() + static_cast<std::ptrdiff_t>((std::min)(next, over_next)));
      i = 0;
    } else
      ++i;
  }
}

/*!
Turns a closed line of places, of which consecutive ones lie in a common triangle but not on a
common edge unless at its ends, into a crossing loop. At vertices it passes on their left.
*/
class Loop_of_line
{
public:
  explicit Loop_of_line(const Flat_mesh& mesh)
      : mesh_(mesh) {}

  Crossing_loop operator()(const std::vector<Surface_point>& line) const {
    Crossing_loop loop;
    const std::size_t n = line.size();
    for(std::size_t i = 0; i < n; ++i) {
      const Surface_point &previous = line[i == 0 ? n - 1 : i - 1],
                          &next = line[i + 1 == n ? 0 : i + 1];
      if(line[i].is_vertex())
        append_around(line[i].a, previous, next, loop);
      else
        append_across(line[i], next, loop);
    }
    remove_backtracks(loop);
    return loop;
  }

private:
  void append_across(const Surface_point& p, const Surface_point& next, Crossing_loop& loop) const {
    const Index apex = p.has_end(next.a) ? next.b : next.a;
    if(mesh_.ring(p.a).after(p.b) == apex)
      loop.push_back({p.a, p.b, p.ratio});
    else
      loop.push_back({p.b, p.a, 1. - p.ratio});
  }

  // Clockwise from where the line comes from to where it goes to.
  void append_around(Index v,
                     const Surface_point& from,
                     const Surface_point& to,
                     Crossing_loop& loop) const {
    const Ring ring = mesh_.ring(v);
    const Index end = to.is_vertex() ? ring.position(to.a) : clockwise_end(ring, to);
    Index p = from.is_vertex() ? ring.previous(ring.position(from.a)) : clockwise_end(ring, from);
    CGAL_precondition(p < ring.size() && end < ring.size());
    for(; p != end; p = ring.previous(p))
      loop.push_back({ring[p], v, 1.});
  }

  // The position of the clockwise end of an edge of the ring.
  static Index clockwise_end(const Ring& ring, const Surface_point& p) {
    const Index position = ring.position(p.a);
    return ring[ring.next(position)] == p.b ? position : ring.position(p.b);
  }

  const Flat_mesh& mesh_;
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_SURFACE_POINT_H
