// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_FLIPPED_EDGES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_FLIPPED_EDGES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Angle_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Unfolded_strip.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The edges of a mesh, some of which are flipped: then they are straight lines across its faces, known
by their lengths (an intrinsic triangulation). Only what is asked for is taken from the mesh.

What an edge is, is said by integers: how many edges of the mesh it crosses (Gillespie, Sharp and
Crane 2021, Integer Coordinates for Intrinsic Geometry Processing). From these follows which ones
they are. Lengths, which are rounded, say nothing of that.
*/
class Flipped_edges
{
public:
  explicit Flipped_edges(const Flat_mesh& mesh)
      : mesh_(mesh)
      , halfedge_at_(mesh.neighbor.size(), no_index) {}

  /// the halfedge along an edge of the mesh, which must be as it was.
  Index halfedge(Index u, Index v) { return halfedge(u, mesh_.position(u, v), v); }

  static Index twin(Index h) { return h ^ 1; }
  Index target(Index h) const { return halfedges_[h].target; }
  Index source(Index h) const { return halfedges_[twin(h)].target; }
  double length(Index h) const { return edges_[h / 2].length; }

  /// the next halfedge of the face to the left, and the one before.
  Index next(Index h) {
    if(halfedges_[h].next == no_index) {
      const Index v = target(h);
      const Ring ring = mesh_.ring(v);
      const Index p = ring.previous(halfedges_[twin(h)].position), next = halfedge(v, p, ring[p]);
      halfedges_[h].next = next;
    }
    return halfedges_[h].next;
  }
  Index previous(Index h) { return next(next(h)); }

  /// the next halfedge around the source, counterclockwise.
  Index after(Index h) { return twin(previous(h)); }

  /// whether there is no cap to the left.
  bool is_on_surface(Index h) {
    return !mesh_.is_hub(source(h)) && !mesh_.is_hub(target(h)) && !mesh_.is_hub(target(next(h)));
  }

  /// adds the corner of the face to the left at the source of a halfedge. Returns whether the sum
  /// is less than straight.
  bool add_corner(Index h, Angle_sum& sum) {
    const double a = length(h), b = length(previous(h)), c = length(next(h));
    return sum.add(rounded_product(a, a) + rounded_product(b, b) - rounded_product(c, c),
                   four_areas(a, b, c));
  }

  /// whether the faces on both sides of an edge span less than a straight angle at its target, so
  /// that, if they do so at its source, it can be flipped.
  bool is_flippable(Index h) {
    Angle_sum sum;
    const Index g = twin(h), n = next(h);
    return g != n && g != previous(h) && is_on_surface(h) && is_on_surface(g) &&
           add_corner(n, sum) && add_corner(g, sum);
  }

  /// lets a halfedge lead from the corner to its right to that to its left.
  void flip(Index h) {
    const Index g = twin(h), to_c = next(h), from_c = next(to_c), to_d = next(g),
                from_d = next(to_d);
    edges_[h / 2] = {length_across(h), crossings_across(h)};
    halfedges_[h] = {target(to_c), from_c, no_index};
    halfedges_[g] = {target(to_d), from_d, no_index};
    halfedges_[from_c].next = to_d;
    halfedges_[to_d].next = h;
    halfedges_[from_d].next = to_c;
    halfedges_[to_c].next = g;
  }

  /// appends the edges of the mesh that an edge crosses.
  void append_crossings(Index h, Crossing_loop& loop) {
    const std::int64_t n = crossings(h);
    const std::size_t begin = loop.size();
    loop.resize(begin + n, {no_index, no_index, 0.5});
    find_ends(h, [&](std::int64_t i, Index v) { loop[begin + i].left = v; });
    find_ends(twin(h), [&](std::int64_t i, Index v) { loop[begin + n - 1 - i].right = v; });
  }

  /// whether an edge is one of the mesh.
  bool is_of_mesh(Index h) const { return edges_[h / 2].crossings == along; }

private:
  struct Halfedge
  {
    Index target;
    Index next = no_index;     // if it is known
    Index position = no_index; // in the ring of the source, if the edge has not been flipped
  };

  struct Edge
  {
    double length;
    std::int64_t crossings; // edges of the mesh
  };

  static constexpr std::int64_t along =
      -1; // in place of a number of crossings: an edge of the mesh

  // From u to v, its neighbour at that position.
  Index halfedge(Index u, Index position, Index v) {
    Index& h = halfedge_at_[mesh_.row_begin[u] + position];
    if(h == no_index) {
      const Index back = mesh_.position(v, u);
      h = static_cast<Index>(halfedges_.size());
      halfedge_at_[mesh_.row_begin[v] + back] = twin(h);
      halfedges_.push_back({v, no_index, position});
      halfedges_.push_back({u, no_index, back});
      edges_.push_back({mesh_.edge_length(u, v), along});
    }
    return h;
  }

  std::int64_t crossings(Index h) const {
    return (std::max)(edges_[h / 2].crossings, std::int64_t(0));
  }

  // ---- lengths

  // Four times the area of a triangle, as good as its sides are (Kahan 2014, Miscalculating Area
  // and Angles of a Needle-like Triangle).
  static double four_areas(double a, double b, double c) {
    if(a < b)
      std::swap(a, b);
    if(b < c)
      std::swap(b, c);
    if(a < b)
      std::swap(a, b);
    const double square = rounded_product(rounded_product(a + (b + c), c - (a - b)),
                                          rounded_product(c + (a - b), a + (b - c)));
    return std::sqrt((std::max)(0., square));
  }

  // Where the corner to the left of an edge lies, if the edge leads from the origin along the
  // x-axis.
  Point_2 apex(Index h) {
    const double base = length(h), from_source = length(previous(h)), from_target = length(next(h));
    if(base == 0.)
      return {0., from_source};
    const double x =
        0.5 * (rounded_product(from_source - from_target, from_source + from_target) / base + base);
    return {x, 0.5 * four_areas(base, from_source, from_target) / base};
  }

  double length_across(Index h) {
    const Point_2 c = apex(h), d = apex(twin(h));
    const Point_2 from_d_to_c = {c[0] - (length(h) - d[0]), c[1] + d[1]};
    return std::sqrt(dot(from_d_to_c, from_d_to_c));
  }

  // ---- crossings

  // Of the face to the left of a halfedge, a b c: how many edges of the mesh pass by each corner,
  // and how many come from it and leave on the other side. These are those of one corner at most.
  struct Passages
  {
    std::array<std::int64_t, 3> by, from;
  };

  Passages passages(Index h) {
    const std::array<std::int64_t, 3> n = {crossings(next(h)), crossings(previous(h)),
                                           crossings(h)};
    Passages result;
    for(int i = 0; i < 3; ++i)
      result.from[i] = (std::max)(n[i] - n[(i + 1) % 3] - n[(i + 2) % 3], std::int64_t(0));
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      result.by[i] =
          (std::max)(n[j] + n[k] - n[i] - result.from[j] - result.from[k], std::int64_t(0)) / 2;
    }
    return result;
  }

  // How many edges of the mesh the other diagonal crosses: those that come by its ends, those from
  // the ends of this one, and those that cross this one from one side of it to another.
  std::int64_t crossings_across(Index h) {
    const Passages left = passages(h), right = passages(twin(h));
    const std::int64_t n = crossings(h);
    // Along this one come, on its left, those by the source, from the corner, and by the target.
    const std::int64_t from_corner_to_corner =
        (std::min)(left.by[0] + left.from[2], right.by[1] + right.from[2]) -
        (std::max)(left.by[0], right.by[1]);
    if(left.from[2] > 0 && right.from[2] > 0 && from_corner_to_corner > 0)
      return along;
    const auto common = [&](std::int64_t a, std::int64_t b) {
      return (std::max)(a + b - n, std::int64_t(0));
    };
    return left.by[2] + right.by[2] + left.from[0] + left.from[1] + right.from[0] + right.from[1] +
           common(left.by[0], right.by[0]) + common(left.by[1], right.by[1]) +
           (is_of_mesh(h) ? 1 : 0);
  }

  // Edges of the mesh that enter a face side by side.
  struct Band
  {
    Index halfedge;
    std::int64_t first, size; // of the crossings of the halfedge, from its source on
    std::int64_t number;      // of the first, where they come from
  };

  // Calls `f(i, v)` for each crossing, from the source on: to the left of the halfedge the edge of
  // the mesh leads to v. Edges are followed side by side as long as they pass the same faces.
  template <typename Function> void find_ends(Index h, const Function& f) {
    bands_.assign(1, {h, 0, crossings(h), 0});
    while(!bands_.empty()) {
      const Band band = bands_.back();
      bands_.pop_back();
      const std::array<std::int64_t, 3> by = passages(band.halfedge).by;
      const Index to_corner = next(band.halfedge), from_corner = next(to_corner);
      const std::int64_t n = crossings(band.halfedge), end = band.first + band.size,
                         first = (std::min)((std::max)(by[0], band.first), end),
                         last = (std::min)((std::max)(n - by[1], band.first), end);
      const std::int64_t shift = crossings(to_corner) - n;
      if(band.first < first)
        bands_.push_back({twin(from_corner), band.first, first - band.first, band.number});
      for(std::int64_t i = first; i < last; ++i)
        f(band.number + i - band.first, target(to_corner));
      if(last < end)
        bands_.push_back(
            {twin(to_corner), last + shift, end - last, band.number + last - band.first});
    }
  }

  const Flat_mesh& mesh_;
  std::vector<Index> halfedge_at_;  // by place in the rings of the mesh, if it is known
  std::vector<Halfedge> halfedges_; // two for each edge
  std::vector<Edge> edges_;
  std::vector<Band> bands_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_FLIPPED_EDGES_H
