// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_INTRINSIC_TRIANGULATION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_INTRINSIC_TRIANGULATION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
A triangulation of the surface of a mesh with more vertices and better triangles, whose edges are
straight lines across its faces: known by their lengths alone (an intrinsic triangulation, Sharp,
Soliman and Crane 2019). First the longest edges are split at their midpoints; then edges are
flipped until they are Delaunay, but for rounding. It serves to measure ways, so that nothing has to
be exact.

What has to be right is the class of a way. The triangulation after the splits subdivides the faces
of the mesh: each vertex has a *corner*, a vertex of the mesh that belongs to all faces that it lies
on, so that a walk on this subdivision can be pulled to one on the edges of the mesh. And each
flipped edge has a walk on the subdivision that can be pulled to it.

Caps stay as they are: edges to their hubs are infinitely long, and neither split nor flipped.
*/
class Intrinsic_triangulation
{
public:
  /// Where a vertex lies on the mesh: on the edge from `source` to `target`, or at a vertex, which
  /// is both; in a face if there is none.
  struct Place
  {
    Index source, target;
    double ratio;

    bool is_vertex() const { return source == target; }

    /// an edge on which two places lie, if there is one.
    static Place edge_of(const Place& p, const Place& q) {
      return !p.is_vertex() ? p : !q.is_vertex() ? q : Place{p.source, q.source, 0.};
    }

    /// the ratio of the place on an edge, negative if it does not lie there.
    double ratio_on(const Place& edge) const {
      if(!is_vertex())
        return source == edge.source && target == edge.target ? ratio : -1.;
      return source == edge.source ? 0. : source == edge.target ? 1. : -1.;
    }
  };

  explicit Intrinsic_triangulation(const Flat_mesh& mesh)
      : points_(mesh.points.begin(), mesh.points.end())
      , first_hub_(mesh.first_hub)
      , number_of_hubs_(mesh.number_of_hubs) {
    for(Index v = 0; v < points_.size(); ++v) {
      corners_.push_back(v);
      places_.push_back({v, v, 0.});
    }
    add_faces(mesh);
  }

  /// splits edges until none is longer, or until there are so many vertices.
  void split(double longest, std::size_t number_of_vertices) {
    for(Index h = 0; h < halfedges_.size(); ++h)
      push(h, longest);
    while(!queue_.empty() && points_.size() < number_of_vertices) {
      const auto [length, h] = queue_.top();
      queue_.pop();
      if(length == distance(h))
        split_edge(h, longest);
    }
  }

  /// the subdivision of the mesh, after all splits: points and rings.
  Flat_mesh subdivision() const {
    CGAL_precondition_msg(lengths_.empty(), "before edges are flipped");
    Flat_mesh mesh;
    mesh.first_hub = first_hub_;
    mesh.number_of_hubs = number_of_hubs_;
    mesh.points.resize(points_.size());
    std::copy(points_.begin(), points_.end(), mesh.points.begin());
    std::vector<Index> first(points_.size(), no_index); // halfedge from a vertex
    for(Index h = 0; h < halfedges_.size(); ++h)
      first[source(h)] = h;
    mesh.row_begin.resize(points_.size() + 1);
    mesh.neighbor.resize(halfedges_.size());
    Index size = 0;
    for(Index v = 0; v < points_.size(); ++v) {
      mesh.row_begin[v] = size;
      Index h = first[v];
      do {
        mesh.neighbor[size++] = target(h);
        h = twin(previous(h));
      } while(h != first[v]);
    }
    mesh.row_begin[points_.size()] = size;
    CGAL_postcondition(size == halfedges_.size());
    return mesh;
  }

  /// flips edges, after all splits.
  void make_delaunay() {
    for(Index h = 0; h < halfedges_.size(); ++h)
      lengths_.push_back(is_spoke(h) ? std::numeric_limits<double>::infinity() : distance(h));
    std::vector<Index> open;
    for(Index h = 0; h < halfedges_.size(); ++h)
      if(h < twin(h))
        open.push_back(h);
    // The angles become larger with each flip; rounding is not to go on for ever.
    for(std::size_t left = halfedges_.size(); !open.empty() && left > 0;) {
      const Index h = open.back();
      open.pop_back();
      if(!is_to_be_flipped(h))
        continue;
      flip(h);
      --left;
      const Index g = twin(h);
      open.insert(open.end(), {next(h), previous(h), next(g), previous(g)});
    }
  }

  std::size_t number_of_vertices() const { return points_.size(); }

  /// by vertex, where it lies.
  const std::vector<Place>& places() const { return places_; }

  /// by vertex, a corner of all faces of the mesh on which it lies.
  const std::vector<Index>& corners() const { return corners_; }

  // Of the halfedges, numbered from 0.
  std::size_t number_of_halfedges() const { return halfedges_.size(); }
  Index source(Index h) const { return target(previous(h)); }
  Index target(Index h) const { return halfedges_[h].target; }
  Index twin(Index h) const { return halfedges_[h].twin; }
  double length(Index h) const { return lengths_[h]; }

  /// appends the vertices that follow the source on a walk on the subdivision, to the target.
  void append_walk(Index h, std::vector<Index>& walk) const {
    const Index number = halfedges_[h].walk;
    if(number == no_index)
      walk.push_back(target(h));
    else
      walk.insert(walk.end(), walks_[number].begin(), walks_[number].end());
  }
  std::vector<Index> walk(Index h) const {
    std::vector<Index> walk;
    append_walk(h, walk);
    return walk;
  }

private:
  struct Halfedge
  {
    Index target, twin;
    bool is_on_edge;       // of the mesh; before flips
    Index walk = no_index; // its number, if a flip has made the edge
  };

  // Halfedges 3f, 3f + 1, 3f + 2 lead around face f.
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  void add_faces(const Flat_mesh& mesh) {
    std::vector<Index> at(mesh.neighbor.size()); // halfedges, by place in the rings
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      const Ring ring = mesh.ring(v);
      for(Index p = 0; p < ring.size(); ++p) {
        const Index a = ring[p], b = ring[ring.next(p)];
        if(a < v || b < v)
          continue;
        at[mesh.row_begin[v] + p] = static_cast<Index>(halfedges_.size());
        at[place(mesh, a, b)] = static_cast<Index>(halfedges_.size() + 1);
        at[place(mesh, b, v)] = static_cast<Index>(halfedges_.size() + 2);
        for(const Index target : {a, b, v})
          halfedges_.push_back({target, no_index, true});
      }
    }
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      for(Index p = 0; p < mesh.ring(v).size(); ++p)
        halfedges_[at[mesh.row_begin[v] + p]].twin = at[place(mesh, mesh.ring(v)[p], v)];
  }

  static std::size_t place(const Flat_mesh& mesh, Index u, Index v) {
    return mesh.row_begin[u] + mesh.ring(u).position(v);
  }

  // ---- splits

  double distance(Index h) const { return norm(points_[target(h)] - points_[source(h)]); }

  bool is_hub(Index v) const { return v - first_hub_ < number_of_hubs_; }
  bool is_spoke(Index h) const { return is_hub(target(h)) || is_hub(source(h)); }
  bool is_in_cap(Index h) const { return is_spoke(h) || is_hub(target(next(h))); }

  // One of the two halfedges stands for the edge.
  void push(Index h, double longest) {
    if(h < twin(h) && distance(h) > longest && !is_spoke(h))
      queue_.push({distance(h), h});
  }

  // The midpoint takes over the corner of an end: it lies on no face on which the end does not.
  void split_edge(Index h, double longest) {
    const Index g = twin(h), m = static_cast<Index>(points_.size());
    points_.push_back(0.5 * (points_[source(h)] + points_[target(h)]));
    corners_.push_back(corners_[source(h)]);
    places_.push_back(halfedges_[h].is_on_edge ? midpoint(places_[source(h)], places_[target(h)])
                                               : Place{no_index, no_index, 0.});
    const Index n = cut_face(h, m), k = cut_face(g, m);
    join(h, k);
    join(g, n);
    // The edges across from h and g have other halfedges now, and so perhaps other names.
    for(Index e : {h, next(h), n, next(n), g, next(g), k, next(k)})
      push((std::min)(e, twin(e)), longest);
  }

  // Of two places on one edge.
  static Place midpoint(const Place& p, const Place& q) {
    Place m = Place::edge_of(p, q);
    m.ratio = 0.5 * (p.ratio_on(m) + q.ratio_on(m));
    return m;
  }

  // Face a b c with halfedge `h` from a to b becomes a m c, and m b c is added. Returns the
  // halfedge from m to b.
  Index cut_face(Index h, Index m) {
    const Index n = static_cast<Index>(halfedges_.size()), across = next(h);
    halfedges_.push_back({target(h), no_index, halfedges_[h].is_on_edge});
    halfedges_.push_back({target(across), no_index, halfedges_[across].is_on_edge});
    halfedges_.push_back({m, no_index, false});
    halfedges_[across].is_on_edge = false;
    halfedges_[h].target = m;
    join(n + 1, twin(across));
    join(n + 2, across);
    return n;
  }

  void join(Index h, Index g) {
    halfedges_[h].twin = g;
    halfedges_[g].twin = h;
  }

  // ---- flips

  // Where the apex of a face lies, if the edge leads from the origin along the x-axis.
  std::pair<double, double> apex(Index h) const {
    const double base = length(h), from_source = length(previous(h)), from_target = length(next(h));
    const double x =
        base > 0.
            ? (from_source * from_source - from_target * from_target + base * base) / (2. * base)
            : 0.;
    return {x, std::sqrt((std::max)(0., from_source * from_source - x * x))};
  }

  // Whether the angles opposite to an edge are together larger than a straight one, by their
  // cotangents. Faces without an area say nothing, unless there is one on the other side.
  bool is_to_be_flipped(Index h) const {
    constexpr double rounding = 1e-7;
    const Index g = twin(h);
    if(is_in_cap(h) || is_in_cap(g))
      return false;
    const auto [x1, y1] = apex(h);
    const auto [x2, y2] = apex(g);
    const double base = length(h);
    if(h / 3 == g / 3 || !(y1 + y2 > rounding * base) ||
       (y1 < rounding * base && (x1 < rounding * base || x1 > (1. - rounding) * base)) ||
       (y2 < rounding * base && (x2 < rounding * base || x2 > (1. - rounding) * base)))
      return false;
    // cot = dot / (base y), both sides times the heights
    const double dot1 = x1 * (x1 - base) + y1 * y1, dot2 = x2 * (x2 - base) + y2 * y2;
    return dot1 * y2 + dot2 * y1 < -rounding * base * base * (std::max)(y1, y2);
  }

  // Faces a b c and b a d with halfedge `h` from a to b become d c a and c d b.
  void flip(Index h) {
    const Index g = twin(h);
    const Index bc = next(h), ca = previous(h), ad = next(g), db = previous(g);
    const Index c = target(bc), d = target(ad);
    const auto [x1, y1] = apex(h);
    const auto [x2, y2] = apex(g);
    const double across = rounded_length(x1 - (length(h) - x2), y1 + y2, 0.);
    const std::vector<Index> walk = joined(d, this->walk(twin(ad)), this->walk(twin(ca)));
    // The places of the other sides change; two of them may be one edge.
    const std::array<Index, 4> before = {ca, ad, db, bc}, after = {bc, ca, ad, db};
    std::array<std::pair<Halfedge, double>, 4> sides;
    for(std::size_t i = 0; i < sides.size(); ++i)
      sides[i] = {halfedges_[before[i]], length(before[i])};
    for(std::size_t i = 0; i < sides.size(); ++i) {
      auto& [side, length] = sides[i];
      const auto place = std::find(before.begin(), before.end(), side.twin);
      side.twin = place == before.end() ? side.twin : after[place - before.begin()];
      set(after[i], side, length);
    }
    set(h, {c, g, false, stored(walk, halfedges_[h].walk)}, across);
    set(g, {d, h, false, stored(reversed(walk, d), halfedges_[g].walk)}, across);
  }

  void set(Index h, const Halfedge& side, double length) {
    halfedges_[h] = side;
    join(h, side.twin);
    lengths_[h] = length;
  }

  // The number of a walk, which takes the place of another one if there is that.
  Index stored(std::vector<Index> walk, Index number) {
    if(number == no_index) {
      number = static_cast<Index>(walks_.size());
      walks_.emplace_back();
    }
    walks_[number] = std::move(walk);
    return number;
  }

  // The same vertices the other way, without the first.
  static std::vector<Index> reversed(const std::vector<Index>& walk, Index first) {
    std::vector<Index> back;
    if(!walk.empty()) {
      back.assign(walk.rbegin() + 1, walk.rend());
      back.push_back(first);
    }
    return back;
  }

  // Without steps there and back.
  static std::vector<Index>
  joined(Index first, const std::vector<Index>& a, const std::vector<Index>& b) {
    std::vector<Index> walk;
    for(const std::vector<Index>* part : {&a, &b})
      for(Index c : *part) {
        const Index before = walk.empty()       ? no_index
                             : walk.size() == 1 ? first
                                                : walk[walk.size() - 2];
        if(before == c)
          walk.pop_back();
        else
          walk.push_back(c);
      }
    return walk;
  }

  std::vector<Vector> points_;
  std::vector<Index> corners_; // by vertex
  std::vector<Place> places_;  // by vertex
  Index first_hub_, number_of_hubs_;
  std::vector<Halfedge> halfedges_;
  std::vector<double> lengths_; // by halfedge, once edges are flipped
  std::vector<std::vector<Index>> walks_;
  std::priority_queue<std::pair<double, Index>> queue_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_INTRINSIC_TRIANGULATION_H
