// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_LOOP_TIGHTENING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_LOOP_TIGHTENING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Angle_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Flip_shortening.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Unfolded_strip.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
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

/// Along vertices of the boundary, with the hub to the right or to the left.
struct Way_around_cap
{
  std::vector<Index> vertices;
  double length = 0.;
};

/// the way between two vertices of a boundary curve unless it is longer; then some part of it.
inline Way_around_cap way_around_cap(
    const Flat_mesh& mesh, Index hub, Index from, Index to, bool is_hub_right, double longest) {
  Way_around_cap way = {{from}, 0.};
  while(way.vertices.back() != to && way.length <= longest) {
    const Index v = way.vertices.back();
    const Ring ring = mesh.ring(v);
    way.vertices.push_back(is_hub_right ? ring.after(hub) : ring.before(hub));
    way.length += mesh.edge_length(v, way.vertices.back());
  }
  if(way.vertices.back() != to)
    way.length = (std::numeric_limits<double>::max)();
  return way;
}

/// appends a loop on the surface, with a way between it and the hub. It comes from one vertex of
/// the boundary and goes on to another.
inline void append_beside(const Flat_mesh& mesh,
                          const std::vector<Index>& way,
                          Index from,
                          Index to,
                          bool is_hub_right,
                          Crossing_loop& result) {
  for(std::size_t i = 0; i < way.size(); ++i) {
    const Index v = way[i], end = i + 1 == way.size() ? to : way[i + 1];
    const Ring ring = mesh.ring(v);
    Index p = ring.position(i == 0 ? from : way[i - 1]);
    const auto step = [&] { p = is_hub_right ? ring.previous(p) : ring.next(p); };
    for(step(); ring[p] != end; step())
      result.push_back(is_hub_right ? Crossing{ring[p], v, 1.} : Crossing{v, ring[p], 0.});
  }
}

/// appends the shorter way around a cap, in the place of that by one edge into it, across spokes of
/// which `spoke` is the first, and by another edge out.
inline void append_way_around_cap(const Flat_mesh& mesh,
                                  const Crossing& in,
                                  const Crossing& spoke,
                                  const Crossing& out,
                                  Crossing_loop& result) {
  if(is_backtrack(in, out)) // once around the hub is no way at all
    return;
  const bool is_hub_right = mesh.is_hub(spoke.right);
  const Index hub = is_hub_right ? spoke.right : spoke.left;
  const auto way_on = [&](bool has_hub_right, double longest) {
    return has_hub_right ? way_around_cap(mesh, hub, in.left, out.left, true, longest)
                         : way_around_cap(mesh, hub, in.right, out.right, false, longest);
  };
  const Way_around_cap own = way_on(is_hub_right, (std::numeric_limits<double>::max)()),
                       other = way_on(!is_hub_right, own.length);
  const bool is_right = is_hub_right == (own.length <= other.length);
  append_beside(mesh, own.length <= other.length ? own.vertices : other.vertices,
                is_right ? in.right : in.left, is_right ? out.right : out.left, is_right, result);
}

/// leads a loop without backtracks around each cap that it crosses the shorter way, on one side of
/// the hub or on the other, so that it enters none any more. A homotopy on the surface with its
/// caps. Linear in the number of edges that are crossed, before and after.
inline void lead_around_caps(const Flat_mesh& mesh, Crossing_loop& loop) {
  if(mesh.number_of_hubs == 0)
    return;
  const auto is_spoke = [&](const Crossing& c) { return mesh.is_spoke(c.left, c.right); };
  // The loop begins where it is not in a cap, nor comes out of one. There is no such place if it
  // runs around a hub.
  const std::size_t n = loop.size();
  std::size_t begin = 0;
  while(begin < n && (is_spoke(loop[begin]) || is_spoke(loop[begin == 0 ? n - 1 : begin - 1])))
    ++begin;
  if(begin == n)
    return loop.clear();
  std::rotate(loop.begin(), loop.begin() + begin, loop.end());
  Crossing_loop result;
  for(std::size_t i = 0; i < n; ++i) {
    std::size_t out = i + 1;
    while(out < n && is_spoke(loop[out]))
      ++out;
    if(out == i + 1)
      result.push_back(loop[i]);
    else {
      append_way_around_cap(mesh, loop[i], loop[i + 1], loop[out], result);
      i = out;
    }
  }
  loop = std::move(result);
  remove_backtracks(loop);
}

/*!
Tightens a loop without changing its homotopy class, towards a closed geodesic.

Two moves alternate. The loop is replaced by the shortest path through the strip of triangles that
it passes, from one of its places back to the same (the strip is laid out in the plane, the path
found with a funnel; the place moves from round to round). And where that path bends at a vertex and
the faces on the other side of the vertex span less than a straight angle, the strip is led around
that other side; where the strip goes all around the vertex, the turn is left out. All are
homotopies whatever the numbers say: rounding can cost length, not the class. A round costs as much
as there are edges that the loop crosses; where these are very many, edges are flipped between the
rounds.

A loop that crosses a cap of a boundary curve is led along that curve first, the shorter way around,
which is homotopic on the surface with its caps. No strip is led around the side of a vertex on
which there is a cap, so that it enters none.
*/
class Loop_tightening
{
public:
  explicit Loop_tightening(const Flat_mesh& mesh)
      : Loop_tightening(Execution(), mesh) {}

  /// as above; ends early where the execution is watched. There is one thread only.
  Loop_tightening(Execution execution, const Flat_mesh& mesh)
      : execution_(execution)
      , mesh_(mesh)
      , strip_(mesh) {}

  /// Each round moves the loop by about one ring of triangles. There are enough of them for a way
  /// as long as the loop, however fine the mesh is, within a share of work. Where that is not
  /// enough, edges are flipped.
  void tighten(Crossing_loop& loop) {
    const std::size_t rounds = (std::min)(loop.size(), share_of_work() / (loop.size() + 1));
    if(rounds < (std::min)(loop.size(), least_rounds))
      shorten_by_flips(loop);
    else
      tighten(loop, rounds);
  }

  /// takes out what is crooked, in a few rounds. To become a geodesic a loop may have a long way to
  /// go, which is to be done once, when it has been chosen.
  void straighten(Crossing_loop& loop) { tighten(loop, rounds_to_straighten); }

  /// tightens a loop that shares work with others: \p crossings are those of all of them. If the
  /// work does for `least_rounds`, it is as without others.
  void tighten_among(Crossing_loop& loop, double work, double crossings) {
    if(is_too_much(work, crossings))
      tighten(loop, 1 + static_cast<std::size_t>(work / crossings));
    else
      tighten(loop);
  }

  /// whether loops that cross so many edges, all of them, take more than that work.
  static bool is_too_much(double work, double crossings) {
    return work < double(least_rounds) * crossings;
  }

  /// Crossings times rounds. On a mesh of n faces a loop crosses about as many edges as the square
  /// root of n; only on ugly ones there are loops that need more than the share.
  std::size_t share_of_work() const { return 4 * mesh_.number_of_faces(); }

  /// Stops when a round gains less than a thousandth part of the length and changes no side, at the
  /// latest after the given number of rounds. A loop that becomes a point is empty.
  void tighten(Crossing_loop& loop, std::size_t maximum_number_of_rounds) {
    CGAL_expensive_precondition(are_consecutive(mesh_, loop));
    remove_backtracks(loop);
    lead_around_caps(mesh_, loop);
    remove_turns(mesh_, loop);
    Crossing_loop best = loop;
    double best_length = length(mesh_, best), previous_length = best_length;
    next_.clear();
    for(const Crossing& c : loop)
      next_.push_back({c.left, c.right, 0});
    // On the mesh, not in the plane: on slivers rounding can make the two differ.
    const auto keep_if_best = [&] {
      set_crossings(loop);
      const double current = length(mesh_, loop);
      if(current <= best_length) {
        best = loop;
        best_length = current;
      }
    };
    int idle_rounds = 0;
    // Where many points coincide, going around them may seem to gain without end.
    const std::size_t largest_size = 8 * loop.size() + 64,
                      largest_work = 2 * maximum_number_of_rounds * (loop.size() + 64);
    std::size_t work = 0;
    for(std::size_t round = 1;
        round <= maximum_number_of_rounds && next_.size() >= 3 && next_.size() <= largest_size &&
        work <= largest_work && idle_rounds < most_idle_rounds();
        ++round)
    {
      execution_.look();
      work += next_.size();
      const std::size_t start = next_start();
      ratio_at_start_ = round == 1 ? loop[start].ratio : ratio_of(next_[start]);
      strip_.assign(next_, start);
      find_bends();
      const double current = funnel_.length();
      const bool is_measured = round % 8 == 0 || round == maximum_number_of_rounds;
      if(is_measured)
        keep_if_best();
      const bool changed = change_sides();
      idle_rounds = changed || current < 0.999 * previous_length ? 0 : idle_rounds + 1;
      if(idle_rounds >= most_idle_rounds() && !is_measured)
        keep_if_best();
      previous_length = current;
    }
    if(next_.empty())
      best.clear();
    loop = std::move(best);
    CGAL_expensive_postcondition(are_consecutive(mesh_, loop));
  }

private:
  using Bend = Funnel::Bend;
  using Portal = Strip::Portal;

  static constexpr std::size_t rounds_to_straighten = 16, least_rounds = 200, short_loop = 16;
  static constexpr double gain_worth_having = 0.99;

  // The place where the path is held moves by an irrational part of the loop each time; on a short
  // loop it comes to all places.
  std::size_t next_start() const {
    std::size_t start = static_cast<std::size_t>(double(next_.size()) * 0.381966);
    while(next_.size() <= short_loop && std::gcd(start, next_.size()) != 1)
      ++start;
    return start;
  }

  // Around a corner of a short loop it may go only while it is held at one certain place.
  int most_idle_rounds() const {
    return next_.size() <= short_loop ? (std::max)(2, static_cast<int>(next_.size())) : 2;
  }

  // Flips move a loop over many vertices, one after the other, and rounds make it let go of many
  // that it goes around for nothing; so they take turns. The loop stays where that is not shorter.
  void shorten_by_flips(Crossing_loop& loop) {
    straighten(loop);
    for(double part = 0.; part < gain_worth_having && !loop.empty();) {
      Crossing_loop shorter = loop;
      Flip_shortening(execution_, mesh_).shorten(shorter);
      straighten(shorter);
      const double before = length(mesh_, loop);
      part = length(mesh_, shorter) / before;
      if(!(part < 1.))
        return;
      loop = std::move(shorter);
    }
  }

  // At the ends exactly: the funnel has to tell whether the path is held at a corner.
  static Point_2 between(const Point_2& l, const Point_2& r, double ratio) {
    return {rounded_product(1. - ratio, l[0]) + rounded_product(ratio, r[0]),
            rounded_product(1. - ratio, l[1]) + rounded_product(ratio, r[1])};
  }

  void find_bends() {
    const std::vector<Point_2>&left = strip_.left(), &right = strip_.right();
    const std::uint32_t n = static_cast<std::uint32_t>(strip_.size());
    funnel_.start({0, between(left[0], right[0], ratio_at_start_)});
    for(std::uint32_t i = 1; i < n; ++i) {
      if(i == 1 || strip_[i].left == strip_[i - 1].left)
        funnel_.narrow(Funnel::RIGHT, {i, right[i]});
      if(i == 1 || strip_[i].left != strip_[i - 1].left)
        funnel_.narrow(Funnel::LEFT, {i, left[i]});
    }
    funnel_.finish({n, between(left[n], right[n], ratio_at_start_)});
  }

  // The loop of the strip, crossing the portals where the path does.
  void set_crossings(Crossing_loop& loop) const {
    loop.clear();
    for(const Portal& portal : strip_)
      loop.push_back({portal.left, portal.right, ratio_at_start_});
    for_each_ratio(1, loop.size(), [&](std::size_t i, double ratio) { loop[i].ratio = ratio; });
  }

  // What `set_crossings()` would say of one portal.
  double ratio_of(const Portal& portal) const {
    if(portal.place == 0 || portal.place >= Strip::new_at_left)
      return portal.place == 0 ? ratio_at_start_ : portal.place == Strip::new_at_left ? 0. : 1.;
    double ratio = 0.;
    for_each_ratio(portal.place, portal.place + std::size_t(1),
                   [&](std::size_t, double r) { ratio = r; });
    return ratio;
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
    remove_backtracks_at_ends(next_);
    if(done > 0)
      remove_turns(mesh_, next_);
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

  Execution execution_;
  const Flat_mesh& mesh_;
  Strip strip_;
  Funnel funnel_;
  double ratio_at_start_ = 0.; // where the path is held
  std::vector<Portal> next_;   // the strip of the next round
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_LOOP_TIGHTENING_H
