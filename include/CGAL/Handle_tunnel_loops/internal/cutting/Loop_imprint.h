// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_LOOP_IMPRINT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_LOOP_IMPRINT_H

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
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

  /// remembers the corners of the triangle.
  Face_subdivision(TriangleMesh& tm, VertexPointMap point, face_descriptor f)
      : tm_(tm)
      , point_(point)
      , faces_(1, f) {
    for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, tm), tm))
      corners_.push_back(target(h, tm));
  }

  /// to be called when the sides have their further vertices.
  void find_sides() {
    halfedge_descriptor h = halfedge_to(corners_[0], faces_[0]);
    for(int side = 0; side < 3; ++side) {
      const vertex_descriptor end = corners_[(side + 1) % 3];
      sides_[target(h, tm_)] |= 1 << side;
      while(target(h, tm_) != end) {
        h = next(h, tm_);
        sides_[target(h, tm_)] |= 1 << side;
      }
    }
  }

  /// divides the face from a to b.
  void add_chord(vertex_descriptor a, vertex_descriptor b) {
    if(chords_.count({a, b}) != 0 || chords_.count({b, a}) != 0)
      return;
    Path path = {a};
    for(const auto& [u, v] : edges_to_cross(a, b)) {
      const vertex_descriptor x = add_crossing(a, b, u, v);
      divide(path.back(), x);
      path.push_back(x);
    }
    divide(path.back(), b);
    path.push_back(b);
    chords_.emplace(Edge_ends(a, b), std::move(path));
  }

  /// the vertices along the chord from a to b.
  Path chord(vertex_descriptor a, vertex_descriptor b) const {
    const auto it = chords_.find({a, b});
    if(it != chords_.end())
      return it->second;
    const Path& back = chords_.at({b, a});
    return Path(back.rbegin(), back.rend());
  }

  /// cuts ears off all faces, the best ones first.
  void triangulate() {
    for(std::size_t i = 0; i < faces_.size(); ++i) // it grows
      while(next(next(next(halfedge(faces_[i], tm_), tm_), tm_), tm_) != halfedge(faces_[i], tm_))
        if(!cut_best_ear(faces_[i]))
          break;
  }

  /// the parts, first the face that was divided.
  const std::vector<face_descriptor>& faces() const { return faces_; }

private:
  using Edge_ends = std::pair<vertex_descriptor, vertex_descriptor>;

  Vector position(vertex_descriptor v) const { return coordinates(point_, v); }

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
        if(std::find(faces_.begin(), faces_.end(), f) != faces_.end() &&
           distance.emplace(f, distance.at(queue[q]) + 1).second)
          queue.push_back(f);
      }
    return distance;
  }

  // The edges on a way across the fewest of them from a to b. There are several ways where some of
  // the edges cross each other: the next one is that which the straight line misses least.
  std::vector<Edge_ends> edges_to_cross(vertex_descriptor a, vertex_descriptor b) const {
    const std::map<face_descriptor, std::size_t> distance = distances_to(b);
    std::vector<face_descriptor> now;
    std::size_t to_cross = faces_.size();
    for(const face_descriptor f : faces_)
      if(has(f, a)) {
        now.push_back(f);
        to_cross = (std::min)(to_cross, distance.at(f));
      }
    std::vector<Edge_ends> edges;
    for(; to_cross > 0; --to_cross) {
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
    for(auto& [ends, path] : chords_)
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
      if((sides_[u] & sides_[v]) != 0 || halfedge(u, v, tm_).second)
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
  std::vector<vertex_descriptor> corners_; // counterclockwise
  std::map<vertex_descriptor, int> sides_; // bits; none for vertices inside
  std::map<Edge_ends, Path> chords_;
};

/// Makes loops walks of edges of their mesh, whose faces are divided for that.
template <typename TriangleMesh, typename VertexPointMap> class Loop_imprint
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Subdivision = Face_subdivision<TriangleMesh, VertexPointMap>;

public:
  using Walk = std::vector<halfedge_descriptor>;

  Loop_imprint(TriangleMesh& tm, VertexPointMap point)
      : tm_(tm)
      , point_(point) {}

  /// takes a loop; throws if two of its places have no common face. The mesh is not changed yet.
  template <typename Loop> void add(const Loop& loop) {
    if(loop.steps().size() != loop.points().size())
      throw std::invalid_argument("a loop does not have as many points as places");
    std::vector<Place> places;
    for(std::size_t i = 0; i < loop.steps().size(); ++i)
      places.push_back(place_of(loop.steps()[i].halfedge, loop.steps()[i].ratio, loop.points()[i]));
    std::vector<Piece> pieces;
    for(std::size_t i = 0; i < places.size(); ++i) {
      const Place &a = places[i], &b = places[i + 1 == places.size() ? 0 : i + 1];
      if(!(a == b))
        pieces.push_back(piece_between(a, b));
    }
    loops_.push_back(std::move(pieces));
  }

  /// divides the faces; returns the walks of the loops.
  std::vector<Walk> run() {
    // Faces beside an edge that is split are divided, too.
    for(const Split_edge& e : edges_)
      for(const halfedge_descriptor h : {e.halfedge, opposite(e.halfedge, tm_)})
        number_of(face(h, tm_));
    for(Split_edge& e : edges_)
      split(e);
    for(Subdivision& subdivision : subdivisions_)
      subdivision.find_sides();
    for(const auto& pieces : loops_)
      for(const Piece& piece : pieces)
        if(piece.face != none)
          subdivisions_[piece.face].add_chord(vertex(piece.a), vertex(piece.b));
    std::vector<Walk> walks;
    for(const auto& pieces : loops_)
      walks.push_back(walk_of(pieces));
    for(Subdivision& subdivision : subdivisions_)
      subdivision.triangulate();
    return walks;
  }

  /// calls `f(face, origin)` for all parts of the faces that were divided; after `run()`.
  template <typename Function> void for_each_part(const Function& f) const {
    for(const Subdivision& subdivision : subdivisions_)
      for(const face_descriptor part : subdivision.faces())
        f(part, subdivision.faces().front());
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // A vertex; or a point of an edge, by their numbers.
  struct Place
  {
    vertex_descriptor vertex;
    std::size_t edge = none;
    double ratio = 0.;

    friend bool operator==(const Place& a, const Place& b) {
      return a.edge == b.edge && (a.edge == none ? a.vertex == b.vertex : a.ratio == b.ratio);
    }
  };
  // From one place to the next: a chord of a face, or along an edge.
  struct Piece
  {
    Place a, b;
    std::size_t face = none;
  };
  struct Split_edge
  {
    halfedge_descriptor halfedge;
    vertex_descriptor source, target;
    std::map<double, Point> points;               // by ratio
    std::map<double, vertex_descriptor> vertices; // by ratio; the ends, too
  };

  Place place_of(halfedge_descriptor h, double ratio, const Point& point) {
    Place place;
    // Not that of the edge: edges of a `Surface_mesh` remember from which halfedge they were made.
    const halfedge_descriptor canonical = (std::min)(h, opposite(h, tm_));
    if(h != canonical)
      ratio = 1. - ratio; // which may be rounded to an end
    if(ratio == 0. || ratio == 1.) {
      place.vertex = ratio == 0. ? source(canonical, tm_) : target(canonical, tm_);
      return place;
    }
    const auto [it, is_new] = number_of_edge_.emplace(canonical, edges_.size());
    if(is_new)
      edges_.push_back({canonical, source(canonical, tm_), target(canonical, tm_), {}, {}});
    place.edge = it->second;
    place.ratio = ratio;
    edges_[place.edge].points.emplace(ratio, point);
    return place;
  }

  bool is_end(vertex_descriptor v, const Split_edge& e) const {
    return v == e.source || v == e.target;
  }

  bool is_along_edge(const Place& a, const Place& b) const {
    if(a.edge != none && b.edge != none)
      return a.edge == b.edge;
    if(a.edge != none)
      return is_end(b.vertex, edges_[a.edge]);
    return b.edge != none ? is_end(a.vertex, edges_[b.edge])
                          : halfedge(a.vertex, b.vertex, tm_).second;
  }

  Piece piece_between(const Place& a, const Place& b) {
    Piece piece = {a, b, none};
    if(is_along_edge(a, b))
      return piece;
    const Place& on_edge = a.edge != none ? a : b;
    if(on_edge.edge != none) {
      const Place& other = a.edge != none ? b : a;
      const halfedge_descriptor h = edges_[on_edge.edge].halfedge;
      for(const halfedge_descriptor k : {h, opposite(h, tm_)})
        if(lies_on(other, k)) {
          piece.face = number_of(face(k, tm_));
          return piece;
        }
    }
    throw std::invalid_argument("consecutive places of a loop have no common face");
  }

  // Whether a place is on the face of a halfedge, off its edge.
  bool lies_on(const Place& place, halfedge_descriptor h) const {
    if(place.edge == none)
      return target(next(h, tm_), tm_) == place.vertex;
    const halfedge_descriptor k = edges_[place.edge].halfedge;
    return face(k, tm_) == face(h, tm_) || face(opposite(k, tm_), tm_) == face(h, tm_);
  }

  std::size_t number_of(face_descriptor f) {
    const auto [it, is_new] = number_of_face_.emplace(f, subdivisions_.size());
    if(is_new)
      subdivisions_.emplace_back(tm_, point_, f);
    return it->second;
  }

  void split(Split_edge& e) {
    e.vertices[0.] = e.source;
    e.vertices[1.] = e.target;
    for(const auto& [ratio, point] : e.points) {
      const vertex_descriptor v = target(Euler::split_edge(e.halfedge, tm_), tm_);
      put(point_, v, point);
      e.vertices[ratio] = v;
    }
  }

  vertex_descriptor vertex(const Place& place) const {
    return place.edge == none ? place.vertex : edges_[place.edge].vertices.at(place.ratio);
  }

  // Where along a split edge a place is.
  double ratio_on(const Split_edge& e, const Place& place) const {
    return place.edge != none ? place.ratio : place.vertex == e.source ? 0. : 1.;
  }

  void append_along_edge(const Piece& piece, std::vector<vertex_descriptor>& path) const {
    std::size_t number = piece.a.edge != none ? piece.a.edge : piece.b.edge;
    for(std::size_t i = 0; i < edges_.size() && number == none; ++i)
      if(is_end(piece.a.vertex, edges_[i]) && is_end(piece.b.vertex, edges_[i]))
        number = i;
    if(number == none) {
      path.push_back(piece.a.vertex);
      return;
    }
    const Split_edge& e = edges_[number];
    const double from = ratio_on(e, piece.a), to = ratio_on(e, piece.b);
    auto it = e.vertices.find(from);
    while(it->first != to) {
      path.push_back(it->second);
      from < to ? ++it : --it;
    }
  }

  Walk walk_of(const std::vector<Piece>& pieces) const {
    std::vector<vertex_descriptor> path;
    for(const Piece& piece : pieces)
      if(piece.face == none)
        append_along_edge(piece, path);
      else {
        const auto chord = subdivisions_[piece.face].chord(vertex(piece.a), vertex(piece.b));
        path.insert(path.end(), chord.begin(), chord.end() - 1);
      }
    Walk walk;
    for(std::size_t i = 0; i < path.size(); ++i)
      walk.push_back(halfedge(path[i], path[i + 1 == path.size() ? 0 : i + 1], tm_).first);
    return walk;
  }

  TriangleMesh& tm_;
  VertexPointMap point_;
  std::vector<std::vector<Piece>> loops_;
  std::vector<Split_edge> edges_;
  std::map<halfedge_descriptor, std::size_t> number_of_edge_;
  std::map<face_descriptor, std::size_t> number_of_face_;
  std::vector<Subdivision> subdivisions_; // by number of the face
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_LOOP_IMPRINT_H
