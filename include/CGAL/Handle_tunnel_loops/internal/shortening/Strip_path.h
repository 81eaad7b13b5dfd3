// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_STRIP_PATH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_STRIP_PATH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Angle_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Unfolded_strip.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// takes out, from a loop without backtracks, turns around a vertex, which are no way at all. Every
/// path becomes shorter by that: after a turn it is on an edge where it was before, and nearer by
/// the edge. The edges are those of a loop or of a strip. Linear.
template <typename Edge> void remove_turns(const Flat_mesh& mesh, std::vector<Edge>& edges) {
  struct Begins // the first of the edges, one after the other, that end at a vertex
  {
    std::size_t at_left, at_right;
  };
  std::vector<Begins> begins(edges.size());
  std::size_t kept = 0; // edges
  const auto note_begins = [&] {
    begins[kept] = {kept, kept};
    if(kept > 0 && edges[kept].left == edges[kept - 1].left)
      begins[kept].at_left = begins[kept - 1].at_left;
    if(kept > 0 && edges[kept].right == edges[kept - 1].right)
      begins[kept].at_right = begins[kept - 1].at_right;
  };
  // If the last edge is the first one at a vertex again, it takes its place.
  const auto drop_turn = [&](Index v, std::size_t first) {
    if(kept - first < 3 || kept - first < mesh.ring(v).size())
      return;
    edges[first] = edges[kept];
    kept = first;
    note_begins();
  };
  for(const Edge& edge : edges) {
    edges[kept] = edge;
    note_begins();
    drop_turn(edge.left, begins[kept].at_left);
    drop_turn(edge.right, begins[kept].at_right);
    ++kept;
  }
  // All of it may be turns around one vertex.
  const bool is_turn =
      kept > 1 && (begins[kept - 1].at_left == 0 || begins[kept - 1].at_right == 0);
  edges.erase(edges.begin() + (is_turn ? 0 : kept), edges.end());
}

/*!
The shortest path through a strip of triangles, and the strip beside it in which a shorter one is
looked for next.

The strip is laid out in the plane and the path found with a funnel. A loop is held at a point of
one of its portals, a way at both of its ends. Where the path bends at a vertex and the faces on the
other side of the vertex span less than a straight angle, the strip is led around that other side;
where it goes all around the vertex, the turn is left out. All are homotopies whatever the numbers
say: rounding can cost length, not the class.
*/
class Strip_path
{
public:
  explicit Strip_path(const Flat_mesh& mesh)
      : mesh_(mesh)
      , strip_(mesh) {}

  /// takes the strip of a loop, or of a way, that crosses these edges.
  void assign(const Crossing_loop& crossings) {
    next_.clear();
    for(const Crossing& c : crossings)
      next_.push_back({c.left, c.right, 0});
  }

  /// the number of portals of the strip.
  std::size_t size() const { return next_.size(); }

  /// finds the shortest loop through the strip, held where it crosses portal `start`. Returns its
  /// length.
  double pull_loop(std::size_t start, double ratio) {
    ratio_at_start_ = ratio_at_end_ = ratio;
    strip_.assign_loop(next_, start);
    find_bends();
    return funnel_.length();
  }

  /// finds the shortest way through the strip, between points of its first and last portal. Returns
  /// its length.
  double pull_way(double first_ratio, double last_ratio) {
    ratio_at_start_ = first_ratio;
    ratio_at_end_ = last_ratio;
    strip_.assign_way(next_);
    find_bends();
    return funnel_.length();
  }

  /// the edges that the path crosses, and where.
  void set_crossings(Crossing_loop& crossings) const {
    crossings.clear();
    for(const Portal& portal : strip_)
      crossings.push_back({portal.left, portal.right, ratio_at_start_});
    const bool is_way = strip_.left().size() == strip_.size();
    if(is_way)
      crossings.back().ratio = ratio_at_end_;
    for_each_ratio(1, strip_.size() - (is_way ? 1 : 0),
                   [&](std::size_t i, double ratio) { crossings[i].ratio = ratio; });
  }

  /// where the path crosses a portal of the strip, if it does.
  double ratio_of(std::size_t i) const {
    const Portal& portal = next_[i];
    if(portal.place == 0 || portal.place >= Strip::new_at_left)
      return portal.place == 0 ? ratio_at_start_ : portal.place == Strip::new_at_left ? 0. : 1.;
    double ratio = 0.;
    for_each_ratio(portal.place, portal.place + std::size_t(1),
                   [&](std::size_t, double r) { ratio = r; });
    return ratio;
  }

  /// leads the strip of a loop around the other side where that is shorter. Returns whether it is
  /// anywhere.
  bool change_sides_of_loop() {
    const bool changed = change_sides();
    remove_backtracks_at_ends(next_);
    if(changed)
      remove_turns(mesh_, next_);
    return changed;
  }

  /// the same of a way. It does not change where it would let go of an end.
  bool change_sides_of_way() {
    const bool changed = change_sides();
    const auto is_same = [](const Portal& a, const Portal& b) {
      return a.left == b.left && a.right == b.right;
    };
    if(next_.size() >= 2 && is_same(next_.front(), strip_[0]) &&
       is_same(next_.back(), strip_[strip_.size() - 1]))
      return changed;
    next_.assign(strip_.begin(), strip_.end());
    return false;
  }

  /// a strip of no more portals is that of a short loop.
  static constexpr std::size_t short_loop = 16;

private:
  using Bend = Funnel::Bend;
  using Portal = Strip::Portal;

  // At the ends exactly: the funnel has to tell whether the path is held at a corner.
  static Point_2 between(const Point_2& l, const Point_2& r, double ratio) {
    return {rounded_product(1. - ratio, l[0]) + rounded_product(ratio, r[0]),
            rounded_product(1. - ratio, l[1]) + rounded_product(ratio, r[1])};
  }

  void find_bends() {
    const std::vector<Point_2>&left = strip_.left(), &right = strip_.right();
    const std::uint32_t n = static_cast<std::uint32_t>(left.size() - 1);
    funnel_.start({0, between(left[0], right[0], ratio_at_start_)});
    for(std::uint32_t i = 1; i < n; ++i) {
      if(i == 1 || strip_[i].left == strip_[i - 1].left)
        funnel_.narrow(Funnel::RIGHT, {i, right[i]});
      if(i == 1 || strip_[i].left != strip_[i - 1].left)
        funnel_.narrow(Funnel::LEFT, {i, left[i]});
    }
    funnel_.finish({n, between(left[n], right[n], ratio_at_end_)});
  }

  // Calls `f(i, ratio)` for the portals from `first` up to `end`, which is excluded; what it is
  // told last of a portal holds.
  template <typename Function>
  void for_each_ratio(std::size_t first, std::size_t end, const Function& f) const {
    const std::vector<Bend>& bends = funnel_.bends();
    for(std::size_t b = 0; b + 1 < bends.size(); ++b)
      for(std::size_t i = (std::max)(std::size_t(bends[b].portal), first);
          i < (std::min)(bends[b + 1].portal + std::size_t(1), end); ++i)
        f(i, crossing_ratio(i, b));
    // All the portals that end at a corner are passed exactly there.
    for(std::size_t b = 1; b + 1 < bends.size(); ++b) {
      const Fan fan = fan_of(bends[b]);
      for(std::size_t i = (std::max)(fan.first, first); i < (std::min)(fan.last + 1, end); ++i)
        f(i, fan.at_left ? 0. : 1.);
    }
  }

  // Where the path goes through a vertex but for rounding, it goes through the vertex.
  double crossing_ratio(std::size_t i, std::size_t b) const {
    const Point_2 &from = funnel_.bends()[b].point, &left = strip_.left()[i];
    const Point_2 direction = minus(funnel_.bends()[b + 1].point, from);
    const double across = cross(minus(strip_.right()[i], left), direction);
    const double ratio = across == 0. ? 0.5 : cross(minus(from, left), direction) / across;
    constexpr double rounding = 1e-12;
    return ratio < rounding ? 0. : ratio > 1. - rounding ? 1. : ratio;
  }

  // A maximal run of portals that end at one corner, at which the path bends.
  struct Fan
  {
    std::size_t first, last;
    bool at_left;
  };

  // Says what the strip of the next round is.
  bool change_sides() {
    const std::vector<Bend>& bends = funnel_.bends();
    next_.clear();
    std::size_t done = 0; // portals of the strip
    const std::size_t beside = strip_.size() > short_loop ? 1 : 0;
    for(std::size_t b = 1; b + 1 < bends.size(); ++b) {
      const Fan fan = fan_of(bends[b]);
      // The strip cannot be led around a corner that lies where it is held. Of a long one, what is
      // beside that is left for the next round.
      if(fan.first <= (std::max)(done, beside) || fan.last + 1 + beside >= strip_.size())
        continue;
      const std::size_t turns = portals_of_turns(fan);
      if(turns == 0 && !is_shorter_on_other_side(fan, bends[b - 1].point, bends[b + 1].point))
        continue;
      append_portals(done, fan.first);
      if(turns > 0)
        append_portals(fan.first + turns, fan.last + 1);
      else
        append_other_side(fan);
      done = fan.last + 1;
    }
    append_portals(done, strip_.size());
    return done > 0;
  }

  void append_portals(std::size_t first, std::size_t end) {
    while(first < end && !next_.empty() && is_backtrack(next_.back(), strip_[first])) {
      next_.pop_back();
      ++first;
    }
    next_.insert(next_.end(), strip_.begin() + first, strip_.begin() + end);
  }

  void append(const Portal& portal) {
    if(!next_.empty() && is_backtrack(next_.back(), portal))
      next_.pop_back();
    else
      next_.push_back(portal);
  }

  Index end_of(std::size_t i, bool at_left) const {
    return at_left ? strip_[i].left : strip_[i].right;
  }

  // The positions, in the ring of the corner, of the vertices that the strip passes before and
  // after the fan: those on its other side are from the one to the other.
  std::pair<Index, Index> other_side(const Fan& fan, const Ring& ring) const {
    const Index first = ring.position(end_of(fan.first - 1, fan.at_left)),
                last = ring.position(end_of(fan.last + 1, fan.at_left));
    CGAL_assertion(first < ring.size() && last < ring.size());
    return {first, last};
  }

  Fan fan_of(const Bend& bend) const {
    const bool at_left = strip_.left()[bend.portal] == bend.point;
    const Index corner = end_of(bend.portal, at_left);
    CGAL_assertion_msg(at_left || strip_.right()[bend.portal] == bend.point,
                       "a path bends at an end of a portal");
    const auto ends_there = [&](std::size_t i) { return end_of(i, at_left) == corner; };
    Fan fan = {bend.portal, bend.portal, at_left};
    while(fan.first > 0 && ends_there(fan.first - 1))
      --fan.first;
    while(fan.last + 1 < strip_.size() && ends_there(fan.last + 1))
      ++fan.last;
    return fan;
  }

  // Whole turns around the corner: the path goes through it, and does not need them.
  std::size_t portals_of_turns(const Fan& fan) const {
    const std::size_t turn = mesh_.ring(end_of(fan.first, fan.at_left)).size();
    return (fan.last + 1 - fan.first) / turn * turn;
  }

  static bool add_angle(const Point_2& a, const Point_2& b, Angle_sum& sum) {
    return sum.add(dot(a, b), std::abs(cross(a, b)));
  }

  bool add_corner(Index v, Index a, Index b, Angle_sum& sum) const {
    const Vector p = mesh_.points[a] - mesh_.points[v], q = mesh_.points[b] - mesh_.points[v];
    return sum.add(dot(p, q), norm(cross(p, q)));
  }

  // Whether the faces on the other side of the corner, from the way in to the way out, span less
  // than a straight angle.
  bool is_shorter_on_other_side(const Fan& fan, const Point_2& before, const Point_2& after) const {
    const std::vector<Point_2>& ends = fan.at_left ? strip_.left() : strip_.right();
    const Point_2 corner = ends[fan.first];
    Angle_sum sum;
    if(!add_angle(minus(before, corner), minus(ends[fan.first - 1], corner), sum))
      return false;
    const Index v = end_of(fan.first, fan.at_left);
    const Ring ring = mesh_.ring(v);
    const auto [first, last] = other_side(fan, ring);
    for(Index p = first; p != last;) {
      const Index q = fan.at_left ? ring.previous(p) : ring.next(p);
      if(mesh_.is_hub(ring[q]) || !add_corner(v, ring[p], ring[q], sum))
        return false;
      p = q;
    }
    return add_angle(minus(ends[fan.last + 1], corner), minus(after, corner), sum);
  }

  // The strip comes from the triangle before the fan and goes to the one after it; between them it
  // now passes the spokes that it did not pass.
  void append_other_side(const Fan& fan) {
    const Index corner = end_of(fan.first, fan.at_left);
    const Ring ring = mesh_.ring(corner);
    const auto [first, last] = other_side(fan, ring);
    for(Index p = first;; p = fan.at_left ? ring.previous(p) : ring.next(p)) {
      append(fan.at_left ? Portal{ring[p], corner, Strip::new_at_right}
                         : Portal{corner, ring[p], Strip::new_at_left});
      if(p == last)
        break;
    }
  }

  const Flat_mesh& mesh_;
  Strip strip_;
  Funnel funnel_;
  double ratio_at_start_ = 0., ratio_at_end_ = 0.; // where the path is held
  std::vector<Portal> next_;                       // the strip of the next round
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_STRIP_PATH_H
