// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EDGES_LOOP_IMPRINT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EDGES_LOOP_IMPRINT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/edges/Face_subdivision.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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
      throw std::invalid_argument("a loop has not as many points as places");
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
    remember_faces();
    for(Split_edge& e : edges_)
      split(e);
    for(const Divided_face& f : faces_)
      subdivisions_.emplace_back(tm_, point_, f.face, f.corners);
    for(auto& pieces : loops_)
      for(Piece& piece : pieces)
        if(piece.face != none)
          piece.chord = subdivisions_[piece.face].add_chord(vertex(piece.a), vertex(piece.b));
    std::vector<Walk> walks;
    for(const auto& pieces : loops_)
      walks.push_back(walk_of(pieces));
    for(Subdivision& subdivision : subdivisions_)
      subdivision.triangulate();
    return walks;
  }

  /// calls `f(face, origin)` for all parts of the faces that were divided; after `run()`.
  template <typename Function> void for_each_part(const Function& f) const {
    for(std::size_t i = 0; i < faces_.size(); ++i)
      for(const face_descriptor part : subdivisions_[i].faces())
        f(part, faces_[i].face);
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
    std::size_t face = none, chord = none;
  };
  struct Split_edge
  {
    halfedge_descriptor halfedge;
    vertex_descriptor source, target;
    std::map<double, Point> points;               // by ratio
    std::map<double, vertex_descriptor> vertices; // by ratio; the ends, too
  };
  struct Divided_face
  {
    face_descriptor face;
    std::vector<vertex_descriptor> corners;
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
    Piece piece = {a, b, none, none};
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
    const auto [it, is_new] = number_of_face_.emplace(f, faces_.size());
    if(is_new) {
      faces_.push_back({f, {}});
      for(const halfedge_descriptor h : halfedges_around_face(halfedge(f, tm_), tm_))
        faces_.back().corners.push_back(target(h, tm_));
    }
    return it->second;
  }

  // Faces beside an edge that is split are divided, too.
  void remember_faces() {
    for(const Split_edge& e : edges_)
      for(const halfedge_descriptor h : {e.halfedge, opposite(e.halfedge, tm_)})
        number_of(face(h, tm_));
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
        const auto& chord = subdivisions_[piece.face].chord(piece.chord);
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
  std::vector<Divided_face> faces_;
  std::map<face_descriptor, std::size_t> number_of_face_;
  std::vector<Subdivision> subdivisions_; // by number of the face
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_EDGES_LOOP_IMPRINT_H
