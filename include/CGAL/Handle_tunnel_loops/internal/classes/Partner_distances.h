// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PARTNER_DISTANCES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PARTNER_DISTANCES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Edge_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/classes/Search_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
How far it is to a loop, the partner, from either side of it: lower bounds of closed walks that
cross it.

The surface is cut open along the partner, and copies of it are put together, a copy beginning where
the one before ends: the cyclic cover. A closed walk through the partner that crosses it a net
number of times other than zero leads there from the partner between two copies to that between two
others. So what is left of a walk at any of its places is not shorter than the way from there to a
partner that is not the one it came from.
*/
class Partner_distances
{
public:
  Partner_distances(const Search_mesh& mesh, const Edge_classes& classes)
      : mesh_(mesh)
      , classes_(classes)
      , sides_{Side(mesh), Side(mesh)} {}

  /// measures the distances to loop \p number, for walks shorter than `limit`. Takes a visit for
  /// two vertices; what has not been reached when there are none left is known to be no nearer.
  void compute(const Crossing_loop& partner, Index number, double limit, std::size_t& visits) {
    number_ = number;
    for(Side& side : sides_)
      side.paths.clear();
    mesh_.for_each_step_across(partner, number, [&](Index v, Index step) { add_step(v, step); });
    // Halfway from both sides; and on only where both together are short enough.
    const float whole = static_cast<float>(limit), half = 0.5f * whole;
    for(std::size_t i : {0, 1})
      grow(sides_[i], half, visits, [](Index, float) { return true; });
    around_ = whole;
    for(Index v : sides_[0].paths.reached())
      around_ = (std::min)(around_, after(v) + before(v));
    for(std::size_t i : {0, 1})
      if(sides_[i].radius == half)
        grow(sides_[i], whole, visits,
             [&](Index v, float distance) { return distance + value(sides_[1 - i], v) < whole; });
  }

  /// No walk that crosses the partner is shorter.
  double around() const { return around_; }

  /// by how much a step crosses the partner, if its sums are not zero.
  int number(Index v, Index step) const { return mesh_.number(v, step, number_, classes_); }

  /// the copy in which a walk begins that comes from the partner before copy 0.
  int first_copy(Index v) const { return after(v) <= before(v) ? 0 : -1; }

  /// the distance of a vertex from the partner.
  double distance(Index v) const { return (std::min)(after(v), before(v)); }

  /// No way from a vertex in a copy is shorter to a partner that is not the one before copy 0.
  double way_on(Index v, int copy) const {
    return copy == 0    ? (std::min)(before(v), after(v) + around_)
           : copy == -1 ? (std::min)(after(v), before(v) + around_)
                        : (std::min)(after(v), before(v));
  }

private:
  static constexpr float infinity = std::numeric_limits<float>::infinity();

  struct Label
  {
    float distance = infinity;
  };

  struct Side
  {
    explicit Side(const Search_mesh& mesh)
        : paths(mesh.number_of_vertices()) {}

    Shortest_paths<Label> paths; // by vertex
    float radius = 0.f;          // so far they are known
  };

  // The distances to the partners at the ends of a copy.
  float after(Index v) const { return value(sides_[0], v); }
  float before(Index v) const { return value(sides_[1], v); }

  static float value(const Side& side, Index v) {
    return (std::min)(side.paths[v].distance, side.radius);
  }

  static void reach(Side& side, Index v, float distance) {
    if(distance < side.paths[v].distance)
      side.paths.reach(v, {distance});
  }

  // The partner is in the middle of each step that crosses it.
  void add_step(Index v, Index step) {
    const int crossings = number(v, step);
    const float length = mesh_.length(v, step);
    if(crossings == 0 || length == infinity)
      return;
    const Index head = mesh_.head(step), before = crossings > 0 ? v : head;
    reach(sides_[0], before == v ? head : v, 0.5f * length);
    reach(sides_[1], before, 0.5f * length);
  }

  template <typename Predicate>
  void grow(Side& side, float radius, std::size_t& visits, const Predicate& is_wanted) {
    side.radius = radius;
    std::size_t settled = 0;
    const auto goes_on = [&](float distance) {
      if(visits == 0)
        side.radius = (std::min)(radius, distance);
      return distance < side.radius;
    };
    side.paths.grow(goes_on, [&](Index v) {
      visits -= ++settled % 2;
      for(Index step = mesh_.begin(v); step != mesh_.end(v); ++step) {
        const float there = side.paths[v].distance + mesh_.length(v, step);
        const Index head = mesh_.head(step);
        if(there < side.paths[head].distance && is_wanted(head, there) &&
           (mesh_.sums(v, step, classes_).is_zero() || number(v, step) == 0))
          side.paths.reach(head, {there});
      }
    });
  }

  const Search_mesh& mesh_;
  const Edge_classes& classes_;
  Index number_ = 0;
  std::array<Side, 2> sides_; // after and before the partner
  float around_ = 0.f;        // from the partner to itself
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PARTNER_DISTANCES_H
