// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EDGES_FACE_SUBDIVISION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EDGES_FACE_SUBDIVISION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Divides one triangle, whose sides may have further vertices, along chords between vertices on
different sides, and then into triangles. Where a chord crosses others is decided by combinatorics
alone: it takes the way across the fewest edges there are. Only the place of a crossing is computed.
*/
template <typename TriangleMesh, typename VertexPointMap> class Face_subdivision
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;

public:
  using Path = std::vector<vertex_descriptor>;

  /// `corners` are those of the triangle, counterclockwise.
  Face_subdivision(TriangleMesh& tm,
                   VertexPointMap point,
                   face_descriptor f,
                   const std::vector<vertex_descriptor>& corners)
      : tm_(tm)
      , point_(point)
      , faces_(1, f) {
    halfedge_descriptor h = halfedge(f, tm);
    while(target(h, tm) != corners[0])
      h = next(h, tm);
    for(int side = 0; side < 3; ++side) {
      const vertex_descriptor end = corners[(side + 1) % 3];
      sides_[target(h, tm)] |= 1 << side;
      while(target(h, tm) != end) {
        h = next(h, tm);
        sides_[target(h, tm)] |= 1 << side;
      }
    }
  }

  /// divides the face from a to b; returns the number of the chord.
  std::size_t add_chord(vertex_descriptor a, vertex_descriptor b) {
    for(std::size_t i = 0; i < chords_.size(); ++i)
      if(chords_[i].front() == a && chords_[i].back() == b)
        return i;
    for(std::size_t i = 0; i < chords_.size(); ++i)
      if(chords_[i].front() == b && chords_[i].back() == a) {
        chords_.emplace_back(chords_[i].rbegin(), chords_[i].rend());
        return chords_.size() - 1;
      }
    Path path = {a};
    for(const auto& [u, v] : edges_to_cross(a, b)) {
      const vertex_descriptor x = add_crossing(a, b, u, v);
      divide(path.back(), x);
      path.push_back(x);
    }
    divide(path.back(), b);
    path.push_back(b);
    chords_.push_back(std::move(path));
    return chords_.size() - 1;
  }

  /// the vertices along a chord.
  const Path& chord(std::size_t i) const { return chords_[i]; }

  /// cuts ears off all faces, the best ones first.
  void triangulate() {
    for(std::size_t i = 0; i < faces_.size(); ++i) // it grows
      while(next(next(next(halfedge(faces_[i], tm_), tm_), tm_), tm_) != halfedge(faces_[i], tm_))
        if(!cut_best_ear(faces_[i]))
          break;
  }

  const std::vector<face_descriptor>& faces() const { return faces_; }

private:
  using Edge_ends = std::pair<vertex_descriptor, vertex_descriptor>;

  Vector position(vertex_descriptor v) const { return coordinates(point_, v); }

  int sides(vertex_descriptor v) const {
    const auto it = sides_.find(v);
    return it == sides_.end() ? 0 : it->second;
  }

  // The halfedge of a face that leads to a vertex, or none.
  halfedge_descriptor halfedge_to(vertex_descriptor v, face_descriptor f) const {
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, tm_), tm_))
      if(target(h, tm_) == v)
        return h;
    return Graph_traits::null_halfedge();
  }
  bool has(face_descriptor f, vertex_descriptor v) const {
    return halfedge_to(v, f) != Graph_traits::null_halfedge();
  }

  bool is_part(face_descriptor f) const {
    return std::find(faces_.begin(), faces_.end(), f) != faces_.end();
  }

  // For each face, how many edges there are at least to cross from there to a vertex.
  std::map<face_descriptor, std::size_t> distances_to(vertex_descriptor b) const {
    std::map<face_descriptor, std::size_t> distance;
    std::vector<face_descriptor> queue;
    for(const face_descriptor f : faces_)
      if(has(f, b)) {
        distance[f] = 0;
        queue.push_back(f);
      }
    for(std::size_t q = 0; q < queue.size(); ++q)
      for(const halfedge_descriptor h : halfedges_around_face(halfedge(queue[q], tm_), tm_)) {
        const face_descriptor f = face(opposite(h, tm_), tm_);
        if(is_part(f) && distance.emplace(f, distance.at(queue[q]) + 1).second)
          queue.push_back(f);
      }
    return distance;
  }

  // The edges on a way across the fewest of them from a to b. There are several ways where some of
  // the edges cross each other: the next one is that which the straight line misses least.
  std::vector<Edge_ends> edges_to_cross(vertex_descriptor a, vertex_descriptor b) const {
    const std::map<face_descriptor, std::size_t> distance = distances_to(b);
    std::vector<face_descriptor> at_a;
    std::size_t to_cross = faces_.size();
    for(const face_descriptor f : faces_)
      if(has(f, a)) {
        at_a.push_back(f);
        to_cross = (std::min)(to_cross, distance.at(f));
      }
    std::vector<Edge_ends> edges;
    for(std::vector<face_descriptor> now = at_a; to_cross > 0; --to_cross) {
      halfedge_descriptor exit = Graph_traits::null_halfedge();
      double least = (std::numeric_limits<double>::infinity)();
      for(const face_descriptor f : now)
        for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, tm_), tm_)) {
          const auto it = distance.find(face(opposite(h, tm_), tm_));
          if(distance.at(f) != to_cross || it == distance.end() || it->second + 1 != to_cross)
            continue;
          const double t = place_of_crossing(a, b, source(h, tm_), target(h, tm_));
          const double missed_by = (std::max)(-t, t - 1.);
          if(exit == Graph_traits::null_halfedge() || missed_by < least) {
            least = missed_by;
            exit = h;
          }
        }
      edges.emplace_back(source(exit, tm_), target(exit, tm_));
      now.assign(1, face(opposite(exit, tm_), tm_));
    }
    return edges;
  }

  // Where on the line through u and v that through a and b comes nearest to it: 0 at u, 1 at v.
  double place_of_crossing(vertex_descriptor a,
                           vertex_descriptor b,
                           vertex_descriptor u,
                           vertex_descriptor v) const {
    const Vector p = position(a), d = position(b) - p, q = position(u), e = position(v) - q;
    const Vector n = internal::cross(d, e);
    const double square = dot(n, n);
    return square > 0. ? dot(internal::cross(p - q, d), n) / -square : 0.5;
  }

  // A new vertex on the edge u - v, where the line from a to b comes nearest to it.
  vertex_descriptor
  add_crossing(vertex_descriptor a, vertex_descriptor b, vertex_descriptor u, vertex_descriptor v) {
    const double t = (std::min)((std::max)(place_of_crossing(a, b, u, v), 1e-3), 1. - 1e-3);
    const Vector q = position(u), e = position(v) - q;
    const halfedge_descriptor h = Euler::split_edge(halfedge(u, v, tm_).first, tm_);
    const vertex_descriptor x = target(h, tm_);
    const Vector place = q + t * e;
    put(point_, x, Point(place[0], place[1], place[2]));
    for(Path& path : chords_)
      for(std::size_t i = 0; i + 1 < path.size(); ++i)
        if((path[i] == u && path[i + 1] == v) || (path[i] == v && path[i + 1] == u))
          path.insert(path.begin() + i + 1, x);
    return x;
  }

  void divide(vertex_descriptor a, vertex_descriptor b) {
    for(std::size_t i = 0; i < faces_.size(); ++i) {
      const halfedge_descriptor to_a = halfedge_to(a, faces_[i]), to_b = halfedge_to(b, faces_[i]);
      if(to_a != Graph_traits::null_halfedge() && to_b != Graph_traits::null_halfedge()) {
        divide_face(to_a, to_b);
        return;
      }
    }
    CGAL_assertion_msg(false, "a chord leads through faces");
  }

  void divide_face(halfedge_descriptor to_a, halfedge_descriptor to_b) {
    if(next(to_a, tm_) == to_b || next(to_b, tm_) == to_a)
      return; // along an edge
    const halfedge_descriptor h = Euler::split_face(to_a, to_b, tm_);
    faces_.push_back(face(opposite(h, tm_), tm_));
  }

  // The two ends of an edge must not be on one side of the triangle, nor be joined already.
  bool cut_best_ear(face_descriptor f) {
    double best = -1.;
    halfedge_descriptor ear = Graph_traits::null_halfedge(); // leads to its tip
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, tm_), tm_)) {
      const vertex_descriptor u = source(h, tm_), v = target(next(h, tm_), tm_);
      if((sides(u) & sides(v)) != 0 || halfedge(u, v, tm_).second)
        continue;
      const Vector tip = position(target(h, tm_));
      const Vector a = position(u) - tip, b = position(v) - tip, c = b - a;
      const double edges = dot(a, a) + dot(b, b) + dot(c, c);
      const double quality = edges > 0. ? norm(internal::cross(a, b)) / edges : 0.;
      if(quality > best) {
        best = quality;
        ear = h;
      }
    }
    if(ear == Graph_traits::null_halfedge())
      return false;
    divide_face(prev(ear, tm_), next(ear, tm_));
    return true;
  }

  TriangleMesh& tm_;
  VertexPointMap point_;
  std::vector<face_descriptor> faces_;
  std::map<vertex_descriptor, int> sides_; // bits; none for vertices inside
  std::vector<Path> chords_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EDGES_FACE_SUBDIVISION_H
