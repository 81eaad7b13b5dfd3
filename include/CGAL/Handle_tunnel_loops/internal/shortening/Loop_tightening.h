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
#include <CGAL/Handle_tunnel_loops/internal/shortening/Flip_shortening.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Strip_path.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

Two moves alternate: the loop is replaced by the shortest path through the strip of triangles that
it passes, from one of its places back to the same, and the strip is led around the other side of
vertices where that is shorter (see `Strip_path`). The place moves from round to round. A round
costs as much as there are edges that the loop crosses; where these are very many, edges are flipped
between the rounds. Of a long loop arcs are tightened side by side, as long as that gains much;
only the whole loop moves as a whole.

A loop that crosses a cap of a boundary curve is led along that curve first, the shorter way around,
which is homotopic on the surface with its caps. No strip is led around the side of a vertex on
which there is a cap, so that it enters none.
*/
class Loop_tightening
{
public:
  explicit Loop_tightening(const Flat_mesh& mesh)
      : Loop_tightening(Execution(), mesh) {}

  /// as above; ends early where the execution is watched.
  Loop_tightening(Execution execution, const Flat_mesh& mesh)
      : execution_(execution)
      , mesh_(mesh)
      , path_(mesh) {}

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

  /// Stops when a round gains less than a thousandth part of the length and changes no side, when
  /// many rounds gain next to nothing, as along a cylinder, and at the latest after the given
  /// number of rounds, of a long loop once more of its arcs. A loop that becomes a point is empty.
  void tighten(Crossing_loop& loop, std::size_t maximum_number_of_rounds) {
    CGAL_expensive_precondition(are_consecutive(mesh_, loop));
    remove_backtracks(loop);
    lead_around_caps(mesh_, loop);
    remove_turns(mesh_, loop);
    tighten_arcs(loop, maximum_number_of_rounds);
    tighten_whole(loop, maximum_number_of_rounds);
    CGAL_expensive_postcondition(are_consecutive(mesh_, loop));
  }

private:
  static constexpr std::size_t rounds_to_straighten = 16, least_rounds = 200;
  static constexpr double gain_worth_having = 0.99;

  // Of a long loop, arcs of about so many crossings are tightened by themselves for some rounds.
  static constexpr std::size_t size_of_arc = 512, rounds_of_arc = 32, fewest_arcs = 4;
  static constexpr double gain_worth_a_turn = 1e-4;

  // So many rounds of a whole loop have to gain that much, as it is measured.
  static constexpr std::size_t rounds_of_measure = 8, rounds_of_look = 8 * rounds_of_measure;
  static constexpr double gain_worth_a_look = 1e-6;

  // Tightens a long loop between points that are held for some rounds, then between others, until
  // that gains little: in all threads, and the same in any number of them. The rounds of the whole
  // are not fewer for that: an arc gains less in one, and nothing where it is beside one vertex.
  void tighten_arcs(Crossing_loop& loop, std::size_t maximum_number_of_rounds) const {
    const std::size_t largest_size = 8 * loop.size(),
                      most_turns = maximum_number_of_rounds / rounds_of_arc;
    double gain = 1.;
    for(std::size_t turn = 0;
        turn < most_turns && gain >= gain_worth_a_turn &&
        loop.size() >= fewest_arcs * size_of_arc && loop.size() <= largest_size;
        ++turn)
    {
      std::rotate(loop.begin(), loop.begin() + size_of_arc / 2, loop.end());
      const Crossing_loop before = loop;
      const std::size_t n = loop.size() / size_of_arc;
      std::vector<Crossing_loop> arcs(n);
      for_each_index(
          execution_, n,
          [&](std::size_t i) {
            const std::size_t begin = i * loop.size() / n, end = (i + 1) * loop.size() / n;
            arcs[i].assign(loop.begin() + begin, loop.begin() + end);
            arcs[i].push_back(loop[end == loop.size() ? 0 : end]);
            tighten_way(arcs[i]);
            arcs[i].pop_back();
          },
          1);
      loop.clear();
      for(const Crossing_loop& arc : arcs)
        loop.insert(loop.end(), arc.begin(), arc.end());
      gain = 1. - length(mesh_, loop) / length(mesh_, before);
      if(!(gain >= 0.))
        loop = before;
    }
  }

  // Tightens a way between its first and last crossing, which stay where they are.
  void tighten_way(Crossing_loop& way) const {
    Strip_path path(mesh_);
    path.assign(way);
    const double first = way.front().ratio, last = way.back().ratio;
    const std::size_t largest_size = 2 * way.size();
    for(std::size_t round = 1; round <= rounds_of_arc && path.size() <= largest_size; ++round) {
      path.pull_way(first, last);
      path.set_crossings(way);
      if(!path.change_sides_of_way())
        break;
    }
  }

  void tighten_whole(Crossing_loop& loop, std::size_t maximum_number_of_rounds) {
    Crossing_loop best = loop;
    double best_length = length(mesh_, best), previous_length = best_length;
    path_.assign(loop);
    // On the mesh, not in the plane: on slivers rounding can make the two differ.
    const auto keep_if_best = [&] {
      path_.set_crossings(loop);
      const double current = length(mesh_, loop);
      if(current <= best_length) {
        best = loop;
        best_length = current;
      }
    };
    int idle_rounds = 0;
    double length_at_look = best_length;
    // Where many points coincide, going around them may seem to gain without end.
    const std::size_t largest_size = 8 * loop.size() + 64,
                      largest_work = 2 * maximum_number_of_rounds * (loop.size() + 64);
    std::size_t work = 0;
    for(std::size_t round = 1;
        round <= maximum_number_of_rounds && path_.size() >= 3 && path_.size() <= largest_size &&
        work <= largest_work && idle_rounds < most_idle_rounds();
        ++round)
    {
      execution_.look();
      work += path_.size();
      const std::size_t start = next_start();
      const double current =
          path_.pull_loop(start, round == 1 ? loop[start].ratio : path_.ratio_of(start));
      const bool is_measured = round % rounds_of_measure == 0 || round == maximum_number_of_rounds;
      if(is_measured)
        keep_if_best();
      if(round % rounds_of_look == 0) {
        if(best_length > (1. - gain_worth_a_look) * length_at_look)
          break;
        length_at_look = best_length;
      }
      const bool changed = path_.change_sides_of_loop();
      idle_rounds = changed || current < 0.999 * previous_length ? 0 : idle_rounds + 1;
      if(idle_rounds >= most_idle_rounds() && !is_measured)
        keep_if_best();
      previous_length = current;
    }
    if(path_.size() == 0)
      best.clear();
    loop = std::move(best);
  }

  // The place where the path is held moves by an irrational part of the loop each time; on a short
  // loop it comes to all places.
  std::size_t next_start() const {
    std::size_t start = static_cast<std::size_t>(double(path_.size()) * 0.381966);
    while(path_.size() <= Strip_path::short_loop && std::gcd(start, path_.size()) != 1)
      ++start;
    return start;
  }

  // Around a corner of a short loop it may go only while it is held at one certain place.
  int most_idle_rounds() const {
    return path_.size() <= Strip_path::short_loop ? (std::max)(2, static_cast<int>(path_.size()))
                                                  : 2;
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

  Execution execution_;
  const Flat_mesh& mesh_;
  Strip_path path_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_LOOP_TIGHTENING_H
