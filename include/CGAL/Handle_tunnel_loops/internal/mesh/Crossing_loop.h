// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CROSSING_LOOP_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CROSSING_LOOP_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the vertex ahead of a crossing, opposite to the edge.
inline Index apex_ahead(const Flat_mesh& mesh, const Crossing& c) {
  return after(mesh.ring(c.left), mesh.ring(c.right), c.left, c.right);
}

/// the ratio of a crossing on the surface.
inline double ratio_on_surface(const Flat_mesh& mesh, const Crossing& c) {
  return mesh.is_hub(c.right) ? 0. : mesh.is_hub(c.left) ? 1. : c.ratio;
}

inline Vector position(const Flat_mesh& mesh, const Crossing& c) {
  const Vector& p = mesh.points[c.left];
  return p + ratio_on_surface(mesh, c) * (mesh.points[c.right] - p);
}

/// the length in the unit of `mesh.points`.
inline double length(const Flat_mesh& mesh, const Crossing_loop& loop) {
  double sum = 0.;
  if(loop.empty())
    return sum;
  Vector previous = position(mesh, loop.back());
  for(const Crossing& c : loop) {
    const Vector p = position(mesh, c);
    sum += norm(p - previous);
    previous = p;
  }
  return sum;
}

/// the length of the left side up to each crossing, and at last all of it.
inline void
measure_left_side(const Flat_mesh& mesh, const Crossing_loop& loop, std::vector<double>& along) {
  along.resize(loop.size() + 1);
  along[0] = 0.;
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const Index u = loop[i].left, v = loop[i + 1 == loop.size() ? 0 : i + 1].left;
    along[i + 1] = along[i] + mesh.edge_length(u, v);
  }
}

/// calls `f(u, v)` for each edge of the closed walk along the left ends.
template <typename Function> void for_each_left_edge(const Crossing_loop& loop, const Function& f) {
  if(loop.empty())
    return;
  Index previous = loop.back().left;
  for(const Crossing& c : loop) {
    if(c.left != previous)
      f(previous, c.left);
    previous = c.left;
  }
}

template <typename Edge> bool is_backtrack(const Edge& a, const Edge& b) {
  return a.left == b.right && a.right == b.left;
}

/// whether each crossing and the next one are two edges of the triangle ahead, or the same edge
/// there and back: that the sequence is a loop.
inline bool are_consecutive(const Flat_mesh& mesh, const Crossing_loop& loop) {
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const Crossing &c = loop[i], &next = loop[i + 1 == loop.size() ? 0 : i + 1];
    const Ring ring = mesh.ring(c.left);
    if(ring.position(c.right) == ring.size())
      return false;
    const Index apex = ring.after(c.right);
    const bool passes_left = next.left == c.left && next.right == apex;
    const bool passes_right = next.left == apex && next.right == c.right;
    if(!passes_left && !passes_right && !is_backtrack(c, next))
      return false;
  }
  return true;
}

/// takes out where a loop comes back at its end on the way by which it began.
template <typename Edge> void remove_backtracks_at_ends(std::vector<Edge>& edges) {
  std::size_t first = 0, last = edges.size();
  while(last - first >= 2 && is_backtrack(edges[last - 1], edges[first])) {
    ++first;
    --last;
  }
  edges.erase(edges.begin() + last, edges.end());
  edges.erase(edges.begin(), edges.begin() + first);
}

/// takes out pairs of consecutive crossings of one edge in opposite directions.
inline void remove_backtracks(Crossing_loop& loop) {
  Crossing_loop reduced;
  reduced.reserve(loop.size());
  for(const Crossing& c : loop)
    if(!reduced.empty() && is_backtrack(reduced.back(), c))
      reduced.pop_back();
    else
      reduced.push_back(c);
  loop = std::move(reduced);
  remove_backtracks_at_ends(loop);
}

/// takes out, from a closed walk on the vertices, each step there and back.
inline void remove_spurs(std::vector<Index>& walk) {
  std::vector<Index> reduced;
  reduced.reserve(walk.size());
  for(Index v : walk) {
    if(!reduced.empty() && reduced.back() == v)
      continue;
    if(reduced.size() >= 2 && reduced[reduced.size() - 2] == v)
      reduced.pop_back();
    else
      reduced.push_back(v);
  }
  std::size_t first = 0, last = reduced.size();
  for(bool changed = true; changed && last - first >= 2;) {
    changed = true;
    if(reduced[first] == reduced[last - 1])
      --last;
    else if(last - first >= 3 && reduced[first + 1] == reduced[last - 1])
      ++first;
    else if(last - first >= 3 && reduced[first] == reduced[last - 2])
      --last;
    else
      changed = false;
  }
  walk.assign(reduced.begin() + first, reduced.begin() + last);
}

/// appends the crossings of a way from one edge at `v` to another, around `v` on one side of it.
/// The edges have these positions in the ring.
inline void append_way_around(
    Index v, const Ring& ring, Index from, Index to, bool has_v_right, Crossing_loop& loop) {
  const auto step = [&](Index p) { return has_v_right ? ring.previous(p) : ring.next(p); };
  for(Index p = step(from); p != to; p = step(p))
    loop.push_back(has_v_right ? Crossing{ring[p], v, 1.} : Crossing{v, ring[p], 0.});
}

/// the place, on the left side of a way by a vertex from one neighbour on, of another neighbour:
/// one for the next edge. Those on the left come before the one to which the way goes.
inline Index place_on_left(const Ring& ring, Index from, Index other) {
  const Index p = ring.position(from), q = ring.position(other);
  return (p < q ? ring.size() : 0) + p - q;
}

inline bool are_very_many_on_left(const Ring& ring, Index from, Index to) {
  return ring.size() > very_many_neighbors && place_on_left(ring, from, to) > ring.size() / 2;
}

/// pushes a closed walk on the edges a little aside: where it passes a vertex, to the right if
/// `is_pushed_right(ring, from, to)` says so of the way there, or else to the left. The walk must
/// have no spurs.
template <typename Predicate>
Crossing_loop pushed_aside(const Flat_mesh& mesh,
                           const std::vector<Index>& walk,
                           const Predicate& is_pushed_right) {
  Crossing_loop loop;
  const auto at = [&](std::size_t i) { return walk[i % walk.size()]; };
  const auto is_right_at = [&](std::size_t i) { // of the way by vertex i + 1
    return is_pushed_right(mesh.ring(at(i + 1)), at(i), at(i + 2));
  };
  bool is_right = !walk.empty() && is_right_at(walk.size() - 1);
  const bool is_right_at_end = is_right;
  for(std::size_t i = 0; i < walk.size(); ++i) {
    const Index v = walk[i], from = i == 0 ? walk.back() : walk[i - 1], to = at(i + 1);
    const Ring ring = mesh.ring(v);
    append_way_around(v, ring, ring.position(from), ring.position(to), !is_right, loop);
    const bool is_next_right = i + 1 == walk.size() ? is_right_at_end : is_right_at(i);
    if(is_next_right != is_right) // over the edge between the two
      loop.push_back(is_right ? Crossing{v, to, 0.} : Crossing{to, v, 1.});
    is_right = is_next_right;
  }
  remove_backtracks(loop);
  return loop;
}

/// pushes it to its left; where it passes a vertex of very many neighbours, to the side on which
/// there are fewer of them. This may lead into caps.
inline Crossing_loop pushed_left(const Flat_mesh& mesh, const std::vector<Index>& walk) {
  return pushed_aside(mesh, walk, are_very_many_on_left);
}

/// the same of a walk on the surface, but to the right where there is a cap on the left. The loop
/// enters no cap, and is homotopic to the walk on the surface without them.
inline Crossing_loop pushed_on_surface(const Flat_mesh& mesh, const std::vector<Index>& walk) {
  return pushed_aside(mesh, walk, [&mesh](const Ring& ring, Index from, Index to) {
    for(const Index v : ring)
      if(mesh.is_hub(v))
        return place_on_left(ring, from, v) < place_on_left(ring, from, to);
    return are_very_many_on_left(ring, from, to);
  });
}

/// a closed walk: of each edge that a loop crosses the nearer end. Two crossings are on the edges
/// of one face. What is left of less than a triangle is a point, and empty.
inline std::vector<Index> nearer_ends(const Flat_mesh& mesh, const Crossing_loop& loop) {
  std::vector<Index> walk;
  for(const Crossing& c : loop)
    walk.push_back(ratio_on_surface(mesh, c) < 0.5 ? c.left : c.right);
  remove_spurs(walk);
  return walk.size() < 3 ? std::vector<Index>() : walk;
}

/// a loop beside a closed walk on the edges; empty if that is a point.
inline Crossing_loop loop_along(const Flat_mesh& mesh, std::vector<Index> walk) {
  remove_spurs(walk);
  return walk.size() < 3 ? Crossing_loop() : pushed_left(mesh, walk);
}

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
  /// end `to_end`. An end that occurs several times is taken where the way is shortest: on that way
  /// neither end occurs again, so they are found in two rounds of the loop. Returns false where
  /// there are no such crossings.
  CGAL_HTL_HOST_DEVICE bool find(Crossing_end from_end, Index from, Crossing_end to_end, Index to) {
    first_ = last_ = no_index;
    Index begin = no_index, end = no_index; // where the ends occurred last
    for(int round = 0; round < 2; ++round)
      CGAL_HTL_NO_UNROLL
    for(Index i = 0; i < size_; ++i) {
      const bool begins = loop_[i].*from_end == from, ends = loop_[i].*to_end == to;
      begin = begins ? i : begin;
      end = ends ? i : end;
      if((begins || ends) && begin != no_index && end != no_index)
        take_if_shorter(begin, end);
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
  CGAL_HTL_HOST_DEVICE void take_if_shorter(Index i, Index j) {
    if(first_ != no_index && distance(i, j) >= distance(first_, last_))
      return;
    first_ = i;
    last_ = j;
  }

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

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_CROSSING_LOOP_H
