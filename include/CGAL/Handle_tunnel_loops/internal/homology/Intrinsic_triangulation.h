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

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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
  };

  explicit Intrinsic_triangulation(const Flat_mesh& mesh)
      : points_(mesh.points.begin(), mesh.points.end())
      , corners_(mesh.number_of_vertices())
      , first_hub_(mesh.first_hub)
      , number_of_hubs_(mesh.number_of_hubs) {
    for(Index v = 0; v < corners_.size(); ++v) {
      corners_[v] = v;
      places_.push_back({v, v, 0.});
    }
    add_faces(mesh);
  }

  /// splits edges until none is longer, or until there are so many vertices.
  void split(double longest, std::size_t number_of_vertices) {
    for(Index h = 0; h < targets_.size(); ++h)
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
    CGAL_precondition(lengths_.empty());
    Flat_mesh mesh;
    mesh.first_hub = first_hub_;
    mesh.number_of_hubs = number_of_hubs_;
    mesh.points.resize(points_.size());
    std::copy(points_.begin(), points_.end(), mesh.points.begin());
    std::vector<Index> first(points_.size(), no_index); // halfedge from a vertex
    for(Index h = 0; h < targets_.size(); ++h)
      first[source(h)] = h;
    mesh.row_begin.resize(points_.size() + 1);
    mesh.neighbor.resize(targets_.size());
    Index size = 0;
    for(Index v = 0; v < points_.size(); ++v) {
      mesh.row_begin[v] = size;
      Index h = first[v];
      do {
        mesh.neighbor[size++] = targets_[h];
        h = twins_[previous(h)];
      } while(h != first[v]);
    }
    mesh.row_begin[points_.size()] = size;
    CGAL_postcondition(size == targets_.size());
    return mesh;
  }

  /// flips edges, after all splits.
  void make_delaunay() {
    start_walks();
    std::vector<Index> open;
    for(Index h = 0; h < targets_.size(); ++h)
      if(h < twins_[h])
        open.push_back(h);
    // The angles become larger with each flip; rounding is not to go on for ever.
    for(std::size_t left = targets_.size(); !open.empty() && left > 0;) {
      const Index h = open.back();
      open.pop_back();
      if(!is_to_be_flipped(h))
        continue;
      flip(h);
      --left;
      const Index g = twins_[h];
      open.insert(open.end(), {next(h), previous(h), next(g), previous(g)});
    }
  }

  std::size_t number_of_vertices() const { return points_.size(); }

  /// by vertex, where it lies.
  const std::vector<Place>& places() const { return places_; }

  /// by vertex, a corner of all faces of the mesh on which it lies.
  const std::vector<Index>& corners() const { return corners_; }

  // Of the halfedges, numbered from 0.
  std::size_t number_of_halfedges() const { return targets_.size(); }
  Index source(Index h) const { return targets_[previous(h)]; }
  Index target(Index h) const { return targets_[h]; }
  double length(Index h) const { return lengths_[h]; }

  /// the vertices that follow the source on a walk on the subdivision, to the target.
  std::vector<Index> walk(Index h) const {
    return is_flipped_[h] != 0 ? walks_[h] : std::vector<Index>(1, targets_[h]);
  }

private:
  // Halfedges 3f, 3f + 1, 3f + 2 lead around face f.
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

  void add_faces(const Flat_mesh& mesh) {
    std::vector<Index> halfedges(mesh.neighbor.size()); // by place in the rings
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      const Ring ring = mesh.ring(v);
      for(Index p = 0; p < ring.size(); ++p) {
        const Index a = ring[p], b = ring[ring.next(p)];
        if(a < v || b < v)
          continue;
        halfedges[mesh.row_begin[v] + p] = static_cast<Index>(targets_.size());
        halfedges[place(mesh, a, b)] = static_cast<Index>(targets_.size() + 1);
        halfedges[place(mesh, b, v)] = static_cast<Index>(targets_.size() + 2);
        targets_.insert(targets_.end(), {a, b, v});
        is_on_edge_.insert(is_on_edge_.end(), {1, 1, 1});
      }
    }
    twins_.resize(targets_.size());
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      for(Index p = 0; p < mesh.ring(v).size(); ++p)
        twins_[halfedges[mesh.row_begin[v] + p]] = halfedges[place(mesh, mesh.ring(v)[p], v)];
  }

  static std::size_t place(const Flat_mesh& mesh, Index u, Index v) {
    return mesh.row_begin[u] + mesh.ring(u).position(v);
  }

  // ---- splits

  double distance(Index h) const { return norm(points_[targets_[h]] - points_[source(h)]); }

  bool is_hub(Index v) const { return v - first_hub_ < number_of_hubs_; }
  bool is_spoke(Index h) const { return is_hub(targets_[h]) || is_hub(source(h)); }
  bool is_in_cap(Index h) const { return is_spoke(h) || is_hub(targets_[next(h)]); }

  // One of the two halfedges stands for the edge.
  void push(Index h, double longest) {
    if(h < twins_[h] && distance(h) > longest && !is_spoke(h))
      queue_.push({distance(h), h});
  }

  // The midpoint takes over the corner of an end: it lies on no face on which the end does not.
  void split_edge(Index h, double longest) {
    const Index g = twins_[h], m = static_cast<Index>(points_.size());
    points_.push_back(0.5 * (points_[source(h)] + points_[targets_[h]]));
    corners_.push_back(corners_[source(h)]);
    places_.push_back(is_on_edge_[h] ? midpoint(places_[source(h)], places_[targets_[h]])
                                     : Place{no_index, no_index, 0.});
    const Index n = cut_face(h, m), k = cut_face(g, m);
    join(h, k);
    join(g, n);
    // The edges across from h and g have other halfedges now, and so perhaps other names.
    for(Index e : {h, next(h), n, next(n), g, next(g), k, next(k)})
      push((std::min)(e, twins_[e]), longest);
  }

  // Of two places on one edge.
  static Place midpoint(const Place& p, const Place& q) {
    Place m = p.source != p.target ? p : q.source != q.target ? q : Place{p.source, q.source, 0.};
    const auto ratio = [&m](const Place& at) {
      return at.source != at.target ? at.ratio : at.source == m.source ? 0. : 1.;
    };
    m.ratio = 0.5 * (ratio(p) + ratio(q));
    return m;
  }

  // Face a b c with halfedge `h` from a to b becomes a m c, and m b c is added. Returns the
  // halfedge from m to b.
  Index cut_face(Index h, Index m) {
    const Index n = static_cast<Index>(targets_.size()), across = next(h);
    const Index b = targets_[h], c = targets_[across];
    targets_.insert(targets_.end(), {b, c, m});
    twins_.insert(twins_.end(), {no_index, no_index, no_index});
    is_on_edge_.insert(is_on_edge_.end(), {is_on_edge_[h], is_on_edge_[across], 0});
    is_on_edge_[across] = 0;
    targets_[h] = m;
    join(n + 1, twins_[across]);
    join(n + 2, across);
    return n;
  }

  void join(Index h, Index g) {
    twins_[h] = g;
    twins_[g] = h;
  }

  // ---- flips

  void start_walks() {
    walks_.resize(targets_.size());
    is_flipped_.assign(targets_.size(), 0);
    for(Index h = 0; h < targets_.size(); ++h)
      lengths_.push_back(is_spoke(h) ? std::numeric_limits<double>::infinity() : distance(h));
  }

  // Where the apex of a face lies, if the edge leads from the origin along the x-axis.
  std::pair<double, double> apex(Index h) const {
    const double base = lengths_[h], from_source = lengths_[previous(h)],
                 from_target = lengths_[next(h)];
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
    const Index g = twins_[h];
    if(is_in_cap(h) || is_in_cap(g))
      return false;
    const auto [x1, y1] = apex(h);
    const auto [x2, y2] = apex(g);
    const double base = lengths_[h];
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
    const Index g = twins_[h];
    const Index bc = next(h), ca = previous(h), ad = next(g), db = previous(g);
    const auto [x1, y1] = apex(h);
    const auto [x2, y2] = apex(g);
    const double across = std::hypot(x1 - (lengths_[h] - x2), y1 + y2);
    const std::vector<Index> walk = joined(targets_[ad], reversed(ad), reversed(ca)); // d to a to c
    struct Outer
    {
      Index target, twin;
      double length;
      char is_flipped;
      std::vector<Index> walk;
    };
    const auto side = [&](Index e) {
      return Outer{targets_[e], twins_[e], lengths_[e], is_flipped_[e], std::move(walks_[e])};
    };
    const auto set = [&](Index e, Outer s) {
      targets_[e] = s.target;
      lengths_[e] = s.length;
      is_flipped_[e] = s.is_flipped;
      walks_[e] = std::move(s.walk);
      join(e, s.twin);
    };
    const Index c = targets_[bc], d = targets_[ad];
    std::vector<Index> back = reversed_walk(walk, d);
    const Outer of_bc = side(bc), of_ca = side(ca), of_ad = side(ad), of_db = side(db);
    targets_[h] = c;
    targets_[g] = d;
    lengths_[h] = lengths_[g] = across;
    is_flipped_[h] = is_flipped_[g] = 1;
    walks_[h] = walk;
    walks_[g] = std::move(back);
    // The places of the other sides change; two of them may be one edge.
    const auto moved = [&](Outer s, Index from_bc, Index from_ca, Index from_ad, Index from_db) {
      s.twin = s.twin == bc   ? from_bc
               : s.twin == ca ? from_ca
               : s.twin == ad ? from_ad
               : s.twin == db ? from_db
                              : s.twin;
      return s;
    };
    const Index h1 = next(h), h2 = previous(h), g1 = next(g), g2 = previous(g);
    set(h1, moved(of_ca, g2, h1, h2, g1));
    set(h2, moved(of_ad, g2, h1, h2, g1));
    set(g1, moved(of_db, g2, h1, h2, g1));
    set(g2, moved(of_bc, g2, h1, h2, g1));
  }

  std::vector<Index> reversed(Index h) const { return walk(twins_[h]); }

  // The same vertices the other way, without the first.
  static std::vector<Index> reversed_walk(const std::vector<Index>& walk, Index first) {
    std::vector<Index> back;
    for(std::size_t i = walk.size(); i-- > 1;)
      back.push_back(walk[i - 1]);
    if(!walk.empty())
      back.push_back(first);
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
  std::vector<Index> targets_, twins_;    // by halfedge
  std::vector<char> is_on_edge_;          // by halfedge, of the mesh; before flips
  std::vector<double> lengths_;           // by halfedge, once they are flipped
  std::vector<char> is_flipped_;          // by halfedge, of the edges that flips have made
  std::vector<std::vector<Index>> walks_; // by halfedge, of these
  std::priority_queue<std::pair<double, Index>> queue_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_INTRINSIC_TRIANGULATION_H
