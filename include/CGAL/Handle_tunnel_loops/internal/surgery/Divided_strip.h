// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_DIVIDED_STRIP_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_DIVIDED_STRIP_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The faces along a curve, divided on both sides of it: what lies between is a narrow strip that can
be taken out, and the parts of the faces that remain have the shape that these had.

On each edge that the curve crosses there is a point on its left, towards the target of the
halfedge, and one on its right: the points 2i and 2i + 1 of the patch.
*/
class Divided_strip
{
public:
  Divided_strip(const Surgery_mesh& mesh, const Curve_off_vertices& curve)
      : mesh_(mesh)
      , curve_(curve)
      , sides_(curve.size()) {
    for(std::size_t i = 0; i < curve.size(); ++i) {
      parts_.points.push_back(Curve_off_vertices::point_beside(mesh, curve[i], curve[i].margin));
      parts_.points.push_back(Curve_off_vertices::point_beside(mesh, curve[i], -curve[i].margin));
    }
    find_sides();
    for(auto begin = sides_.begin(); begin != sides_.end();) {
      const Index face = begin->face;
      const auto end =
          std::find_if(begin, sides_.end(), [&](const Side& s) { return s.face != face; });
      divide(face, {begin, end});
      begin = end;
    }
  }

  /// the parts of the faces that remain, which are all in `curve.faces()`.
  const Patch& parts() const { return parts_; }

  /// the borders of caps: to the left of the curve, in its opposite direction, or to its right.
  std::vector<Index> rim(bool is_left) const {
    std::vector<Index> rim;
    for(std::size_t i = 0; i < curve_.size(); ++i)
      rim.push_back(is_left ? left(i) : right(i));
    if(is_left)
      std::reverse(rim.begin(), rim.end());
    return rim;
  }

private:
  static Index left(std::size_t i) { return Patch::first_own + static_cast<Index>(2 * i); }
  static Index right(std::size_t i) { return left(i) + 1; }

  // Where the curve crosses a side of a face, seen from there.
  struct Side
  {
    Index face = no_index;
    double place = 0.; ///< the number of the side, and how far along it
    std::size_t crossing = 0;
    bool leaves = false; ///< the face
  };

  // A point at the border of a face; with the sides that it is on, as bits.
  struct Border_point
  {
    Index vertex;
    unsigned on;
    std::size_t jump; ///< to the place of the border where the curve leads from here, or none
  };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  void find_sides() {
    sides_.clear();
    for(std::size_t i = 0; i < curve_.size(); ++i) {
      const Edge_crossing& c = curve_[i];
      const Index g = mesh_.twin(c.halfedge);
      sides_.push_back({Surgery_mesh::face(c.halfedge), c.halfedge % 3 + c.ratio, i, true});
      sides_.push_back({Surgery_mesh::face(g), g % 3 + (1. - c.ratio), i, false});
    }
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
      return std::tie(a.face, a.place, a.crossing) < std::tie(b.face, b.place, b.crossing);
    });
  }

  // The border of a face, from its first corner on, with two points at each crossing.
  std::vector<Border_point> border_of(Index face, const std::vector<Side>& crossings) const {
    std::vector<Border_point> border;
    auto next = crossings.begin();
    for(unsigned k = 0; k < 3; ++k) {
      border.push_back({mesh_.corners(face)[k], 1u << k | 1u << (k + 2) % 3, none});
      for(; next != crossings.end() && next->place < k + 1; ++next) {
        const std::size_t i = next->crossing;
        border.push_back({next->leaves ? right(i) : left(i), 1u << k, none});
        border.push_back({next->leaves ? left(i) : right(i), 1u << k, none});
      }
    }
    CGAL_assertion(next == crossings.end());
    return border;
  }

  // The curve leads through the face from its i-th crossing to the next one.
  void find_jumps(const std::vector<Side>& crossings, std::vector<Border_point>& border) const {
    const auto place_of = [&](Index v) {
      return static_cast<std::size_t>(
          std::find_if(border.begin(), border.end(),
                       [&](const Border_point& p) { return p.vertex == v; }) -
          border.begin());
    };
    for(const Side& side : crossings)
      if(side.leaves) {
        const std::size_t i = side.crossing, before = curve_.before(i);
        border[place_of(right(i))].jump = place_of(right(before));
        border[place_of(left(before))].jump = place_of(left(i));
      }
  }

  void divide(Index face, const std::vector<Side>& crossings) {
    std::vector<Border_point> border = border_of(face, crossings);
    find_jumps(crossings, border);
    std::vector<char> is_done(border.size(), 0);
    for(std::size_t begin = 0; begin < border.size(); ++begin) {
      std::vector<Border_point> piece;
      for(std::size_t at = begin; !is_done[at];) {
        is_done[at] = 1;
        piece.push_back(border[at]);
        at = border[at].jump != none ? border[at].jump : (at + 1) % border.size();
      }
      if(!piece.empty())
        triangulate(std::move(piece), face);
    }
  }

  // A convex polygon with points along the sides of the face. Corner after corner is cut off where
  // the new side is shortest; none along a side of the face.
  void triangulate(std::vector<Border_point> piece, Index face) {
    while(piece.size() > 3) {
      std::size_t best = none;
      double least = 0.;
      for(std::size_t i = 0; i < piece.size(); ++i) {
        const Border_point &a = piece[(i + piece.size() - 1) % piece.size()],
                           &b = piece[(i + 1) % piece.size()];
        if((a.on & b.on) != 0)
          continue;
        const double length =
            CGAL::squared_distance(parts_.point(mesh_, a.vertex), parts_.point(mesh_, b.vertex));
        if(best == none || length < least) {
          best = i;
          least = length;
        }
      }
      CGAL_assertion(best != none);
      add_part(piece[(best + piece.size() - 1) % piece.size()], piece[best],
               piece[(best + 1) % piece.size()], face);
      piece.erase(piece.begin() + static_cast<std::ptrdiff_t>(best));
    }
    CGAL_assertion(piece.size() == 3);
    add_part(piece[0], piece[1], piece[2], face);
  }

  void add_part(const Border_point& a, const Border_point& b, const Border_point& c, Index parent) {
    parts_.faces.push_back({a.vertex, b.vertex, c.vertex});
    parts_.parents.push_back(parent);
  }

  const Surgery_mesh& mesh_;
  const Curve_off_vertices& curve_;
  std::vector<Side> sides_; // by face, and in the order of its border
  Patch parts_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_DIVIDED_STRIP_H
