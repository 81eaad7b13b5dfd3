// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_DUAL_LOOP_IMPROVEMENT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_DUAL_LOOP_IMPROVEMENT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Parallel_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds the way from the left side of a loop around to its right side as `Bidirectional_front` does,
but by the lengths of the edges and with the way along the loop that closes it: of the closed walks
that leave the loop on one side, come back on the other, each by a shortest path, and go on along
the loop to where they began, a shortest one. Dijkstra's algorithm runs from both sides at once, up
to half the length that is asked for.

A workspace that can be used again and again; a search costs as much as the region that it covers.
*/
class Bidirectional_dijkstra
{
public:
  explicit Bidirectional_dijkstra(const Flat_mesh& mesh)
      : mesh_(mesh)
      , paths_(mesh.number_of_vertices()) {}

  /// returns a closed walk on the edges that crosses `loop`, number `k` in the index, once. Empty
  /// if there is none shorter than `limit`, or if one has not been found with `number_of_visits`
  /// vertices.
  std::vector<Index> dual_walk(const Crossing_loop& loop,
                               Index k,
                               const Crossing_index& index,
                               double limit,
                               std::size_t number_of_visits) {
    CGAL_precondition(!loop.empty());
    const Only_loop only = {k};
    const Loop_walls<Only_loop> walls(index, only);
    parallel_paths_.measure(mesh_, loop);
    start(loop);
    best_ = {limit, no_index, no_index};
    const bool is_done = search(walls, number_of_visits);
    std::vector<Index> walk;
    if(is_done && best_.left != no_index)
      walk = parallel_paths_.closed_walk(path_back(best_.right), path_back(best_.left));
    if(!is_dual(index.intersections(walk), k, only))
      walk.clear();
    paths_.clear();
    return walk;
  }

private:
  static constexpr float infinite = std::numeric_limits<float>::infinity();
  static constexpr std::uint8_t right = 1, visited = 2, beside_loop = 4;

  // How a vertex is reached. Kept together, for they are read together.
  struct Label
  {
    float distance = infinite;
    Index parent = no_index;
    Index source = no_index; // the crossing of the loop from which it is reached
    std::uint8_t state = 0;
  };

  // Where what is reached from the left meets what is reached from the right.
  struct Meeting
  {
    double length;
    Index left, right;
  };

  void start(const Crossing_loop& loop) {
    for(const std::uint8_t side : {std::uint8_t(0), right})
      for(Index i = 0; i < loop.size(); ++i) {
        const Index v = side == right ? loop[i].right : loop[i].left;
        if(!paths_.is_reached(v))
          paths_.reach(v, {0.f, no_index, i, static_cast<std::uint8_t>(beside_loop | side)});
      }
  }

  // Returns whether it came to an end.
  template <typename Walls> bool search(const Walls& walls, std::size_t number_of_visits) {
    bool is_done = true;
    paths_.grow([&](float distance) { return is_done && 2. * distance < best_.length; },
                [&](Index v) {
                  is_done = number_of_visits-- > 0;
                  if(is_done)
                    visit(v, walls);
                });
    return is_done;
  }

  template <typename Walls> void visit(Index v, const Walls& walls) {
    paths_[v].state |= visited;
    const Label here = paths_[v];
    for(Index u : mesh_.ring(v)) {
      const Label& there = paths_[u];
      if((here.state & there.state & beside_loop) != 0 && walls.is_wall(v, u))
        continue;
      const float distance = here.distance + static_cast<float>(mesh_.edge_length(u, v));
      if((there.state & visited) != 0)
        note_meeting(v, u, distance);
      else if(distance < there.distance)
        paths_.reach(u, {distance, v, here.source, static_cast<std::uint8_t>(here.state & right)});
    }
  }

  void note_meeting(Index v, Index u, float distance) {
    const Label &here = paths_[v], &there = paths_[u];
    if(((here.state ^ there.state) & right) == 0)
      return;
    const double length = double(distance) + there.distance + along(here.source, there.source);
    if(length < best_.length)
      best_ = (here.state & right) != 0 ? Meeting{length, u, v} : Meeting{length, v, u};
  }

  double along(Index i, Index j) const {
    const std::vector<double>& position = parallel_paths_.along();
    const double one_way = std::abs(position[i] - position[j]);
    return (std::min)(one_way, position.back() - one_way);
  }

  // From `v` to a source.
  std::vector<Index> path_back(Index v) const {
    std::vector<Index> way;
    for(; v != no_index; v = paths_[v].parent) {
      CGAL_assertion(way.empty() || paths_[v].distance <= paths_[way.back()].distance);
      CGAL_assertion(way.empty() || ((paths_[v].state ^ paths_[way.back()].state) & right) == 0);
      way.push_back(v);
    }
    CGAL_assertion_msg((paths_[way.back()].state & beside_loop) != 0, "a way ends beside the loop");
    return way;
  }

  const Flat_mesh& mesh_;
  Shortest_paths<Label> paths_; // by vertex
  Meeting best_{};
  Parallel_paths parallel_paths_;
};

/*!
Looks once more for each loop of the pairs, this time by lengths. A field counts edges; where
triangles are of very different sizes or long and thin, the way that it finds may be far from short,
and a loop that is tightened comes to the nearest geodesic only, such as one around a bump.

A loop is replaced by a shorter one x if x = e (loop) + m (partner) in homology, with e = 1 or -1:
adding to an element of a basis a multiple of another one gives a basis again, whatever is replaced
besides. By Poincare duality this is so if and only if both sides have the same intersection numbers
with all loops, in integers.

The loops for which the search is expected to cover the fewest vertices come first, and it goes on
as long as it pays: when a part of the loops, for `first_share()` of vertices, gave nothing, the
rest is left as it is; otherwise the next part may cover twice as many.
*/
class Dual_loop_improvement
{
public:
  Dual_loop_improvement(Execution execution, const Flat_mesh& mesh, Progress& progress)
      : execution_(execution)
      , mesh_(mesh)
      , progress_(progress)
      , searches_([&] { return std::make_unique<Bidirectional_dijkstra>(mesh); }) {}

  /// improves the handles and the tunnels, which are geodesics and a basis.
  void improve(std::vector<Crossing_loop>& handles, std::vector<Crossing_loop>& tunnels) {
    CGAL_precondition(handles.size() == tunnels.size());
    std::vector<Index> numbers(handles.size());
    std::iota(numbers.begin(), numbers.end(), Index(0));
    look_for(tunnels, handles, numbers);
    for(int round = 0; round < maximum_number_of_rounds && !numbers.empty(); ++round) {
      numbers = look_for(handles, tunnels, numbers);
      numbers = look_for(tunnels, handles, numbers);
    }
  }

private:
  static constexpr int maximum_number_of_rounds = 3;

  // A walk on the edges is longer than the loop that it is pulled to. One that is by more than this
  // factor longer than the loop there is, is not pulled.
  static constexpr double slack = 1.15;

  // A search that has covered so many times what was expected is given up.
  static constexpr std::size_t patience_factor = 4;

  static constexpr double gain_worth_having = 0.99;

  std::size_t first_share() const { return mesh_.number_of_vertices() / 16 + (1 << 16); }

  // About the area within half the length of a loop on both sides of its partner, in vertices: a
  // geodesic crosses two edges on an edge length.
  std::size_t expected_visits(const Crossing_loop& loop, const Crossing_loop& partner) const {
    return (std::min)(loop.size() * partner.size() / 4 + 16, mesh_.number_of_vertices());
  }

  // The loops that are looked for, those that cross them, and what crosses both.
  struct Families
  {
    const std::vector<Crossing_loop>&loops, &partners;
    Crossing_index index, partner_index;
  };

  /// looks for the given loops. Returns those that have become shorter.
  std::vector<Index> look_for(std::vector<Crossing_loop>& loops,
                              const std::vector<Crossing_loop>& partners,
                              std::vector<Index> numbers) {
    if(numbers.empty())
      return {};
    const Families families = {loops, partners, {mesh_, loops}, {mesh_, partners}};
    const auto visits = [&](Index k) { return expected_visits(loops[k], partners[k]); };
    std::stable_sort(numbers.begin(), numbers.end(),
                     [&](Index a, Index b) { return visits(a) < visits(b); });
    std::vector<Crossing_loop> shorter(loops.size());
    bool does_pay = true;
    std::size_t end = 0;
    for(std::size_t share = first_share(); does_pay && end < numbers.size(); share *= 2) {
      const std::size_t begin = end;
      for(std::size_t sum = 0; end < numbers.size() && (sum += visits(numbers[end])) <= share;)
        ++end;
      for_each_index(
          execution_, end - begin,
          [&](std::size_t i) {
            const Index k = numbers[begin + i];
            if(progress_.goes_on())
              shorter[k] = shorter_loop(k, families);
          },
          1);
      progress_.throw_if_interrupted();
      does_pay = std::any_of(numbers.begin() + begin, numbers.begin() + end,
                             [&](Index k) { return !shorter[k].empty(); });
    }
    numbers.clear();
    for(Index k = 0; k < loops.size(); ++k)
      if(!shorter[k].empty()) {
        loops[k] = std::move(shorter[k]);
        numbers.push_back(k);
      }
    return numbers;
  }

  // Empty if there is none.
  Crossing_loop shorter_loop(Index k, const Families& families) {
    const Crossing_loop &loop = families.loops[k], &partner = families.partners[k];
    const double length_before = length(mesh_, loop);
    const std::vector<Index> walk =
        searches_.borrow()->dual_walk(partner, k, families.partner_index, slack * length_before,
                                      patience_factor * expected_visits(loop, partner));
    if(walk.empty())
      return {};
    Crossing_loop found = pushed_left(mesh_, walk);
    Loop_tightening(execution_, mesh_).tighten(found);
    if(length(mesh_, found) >= gain_worth_having * length_before ||
       !can_replace(found, k, families))
      return {};
    return found;
  }

  static bool can_replace(const Crossing_loop& found, Index k, const Families& families) {
    const auto& [loops, partners, index, partner_index] = families;
    // The factors are those for which the numbers with the pair itself agree.
    const std::int64_t crossing = number(partner_index.intersections(loops[k]), k);
    const std::int64_t e = crossing * number(partner_index.intersections(found), k);
    const std::int64_t m = -crossing * number(index.intersections(found), k);
    if(std::abs(crossing) != 1 || std::abs(e) != 1)
      return false;
    for(const Crossing_index* i : {&index, &partner_index}) {
      Sparse_numbers difference = i->intersections(found);
      subtract_multiple(difference, e, i->intersections(loops[k]));
      subtract_multiple(difference, m, i->intersections(partners[k]));
      if(!difference.empty())
        return false;
    }
    return true;
  }

  static std::int64_t number(const Sparse_numbers& numbers, Index k) {
    const auto it = numbers.find(k);
    return it == numbers.end() ? 0 : it->second;
  }

  static void
  subtract_multiple(Sparse_numbers& numbers, std::int64_t factor, const Sparse_numbers& others) {
    for(const auto& [i, value] : others) {
      const auto it = numbers.emplace(i, 0).first;
      it->second -= factor * value;
      if(it->second == 0)
        numbers.erase(it);
    }
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  Progress& progress_;
  Workspace_pool<Bidirectional_dijkstra> searches_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_DUAL_LOOP_IMPROVEMENT_H
