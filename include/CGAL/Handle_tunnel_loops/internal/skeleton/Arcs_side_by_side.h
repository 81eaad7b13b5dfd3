// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_ARCS_SIDE_BY_SIDE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_ARCS_SIDE_BY_SIDE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Skeleton_draft.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Lets arcs of a draft that leave a joint side by side be one until they part, as legs that leave a
back at about the same place.

Two are side by side as far as the ball around the place halfway between them holds both well inside
it. So what is between them is inside, and their class stays.
*/
class Arcs_side_by_side
{
public:
  /// steps are no shorter than those for \p spacing: there is no end to them where the solid is so
  /// thin that they are lost in rounding.
  Arcs_side_by_side(const Wall& wall, double spacing, Skeleton_draft& draft)
      : wall_(wall)
      , spacing_(spacing)
      , draft_(draft) {}

  void join() {
    std::vector<Index> joints = draft_.joints();
    for(std::size_t i = 0; i < joints.size(); ++i)
      while(const std::optional<Index> next = join_two_at(joints[i]))
        joints.push_back(*next);
  }

private:
  /// On its way along an arc from a joint, between two places.
  struct Walker
  {
    Index before, next;
    Vector point;
  };

  struct Pair
  {
    double distance; // where they leave the ball of the joint
    Index first, second;
  };

  static constexpr double part_of_radius = 0.6; // how far from the middle, at most
  static constexpr double least_way = 0.7;      // from a joint to the next, in its radius
  static constexpr double part_of_step = 0.2;   // of the radius, or the spacing

  const Inner_ball& ball(Index place) const { return draft_[place].ball; }

  // Returns the joint where they part; nothing if no two are side by side out of its ball.
  std::optional<Index> join_two_at(Index joint) {
    for(const Pair& pair : pairs_at(joint))
      if(const std::optional<Index> next = join_two(joint, pair.first, pair.second))
        return next;
    return std::nullopt;
  }

  // Those that may be side by side, the closest first.
  std::vector<Pair> pairs_at(Index joint) const {
    const std::vector<Index>& beside = draft_[joint].beside;
    const double radius = ball(joint).radius, way = Skeleton_draft::within * radius;
    std::vector<Pair> pairs;
    if(beside.size() < 3)
      return pairs;
    std::vector<std::optional<Vector>> exits;
    for(const Index place : beside) {
      Walker walker = {joint, place, ball(joint).centre};
      exits.push_back(advance(walker, way) ? std::optional<Vector>(walker.point) : std::nullopt);
    }
    for(std::size_t i = 0; i < beside.size(); ++i)
      for(std::size_t k = i + 1; k < beside.size(); ++k)
        if(exits[i] && exits[k])
          if(const double distance = norm(*exits[k] - *exits[i]);
             distance < 2. * part_of_radius * (radius + way))
            pairs.push_back({distance, beside[i], beside[k]});
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
      return std::tie(a.distance, a.first, a.second) < std::tie(b.distance, b.first, b.second);
    });
    return pairs;
  }

  // So far along the arc. Returns whether there is no node before.
  bool advance(Walker& walker, double way) const {
    for(;;) {
      const Vector line = ball(walker.next).centre - walker.point;
      const double length = norm(line);
      if(way < length) {
        walker.point = walker.point + (way / length) * line;
        return true;
      }
      if(draft_.is_node(walker.next))
        return false;
      way -= length;
      walker.point = ball(walker.next).centre;
      const std::vector<Index>& beside = draft_[walker.next].beside;
      const Index next = beside[beside[0] == walker.before ? 1 : 0];
      walker.before = walker.next;
      walker.next = next;
    }
  }

  // How far two walkers can go without that they meet, if they are on the same arc.
  double way_before_meeting(Index joint, Index first, Index second) const {
    constexpr double part = 0.4;
    double length = norm(ball(first).centre - ball(joint).centre);
    Index before = joint, place = first;
    while(!draft_.is_node(place)) {
      const std::vector<Index>& beside = draft_[place].beside;
      const Index next = beside[beside[0] == before ? 1 : 0];
      length += norm(ball(next).centre - ball(place).centre);
      before = std::exchange(place, next);
    }
    return place == joint && before == second ? part * length
                                              : std::numeric_limits<double>::infinity();
  }

  // Returns the joint where they part, if that is out of the ball of the first.
  std::optional<Index> join_two(Index joint, Index first, Index second) {
    const Inner_ball start = ball(joint);
    const double most = way_before_meeting(joint, first, second);
    std::array<Walker, 2> ends = {{{joint, first, start.centre}, {joint, second, start.centre}}};
    std::vector<Inner_ball> line = {start};
    double way = 0.;
    for(std::array<Walker, 2> walkers = ends;;) {
      const double step = part_of_step * (std::max)(line.back().radius, spacing_);
      way += step;
      if(!(way < most) || !advance(walkers[0], step) || !advance(walkers[1], step))
        break;
      const std::optional<Inner_ball> between =
          ball_between(walkers[0].point, walkers[1].point, line.back());
      if(!between)
        break;
      line.push_back(*between);
      ends = walkers;
    }
    if(norm(line.back().centre - start.centre) < least_way * start.radius)
      return std::nullopt;
    return replace(joint, line, ends);
  }

  // Around the middle of two points that it holds well inside.
  std::optional<Inner_ball>
  ball_between(const Vector& a, const Vector& b, const Inner_ball& before) const {
    constexpr double precision = 0.95;
    const Vector middle = 0.5 * (a + b);
    const double least = norm(b - a) / (2. * part_of_radius),
                 most = before.radius + norm(middle - before.centre);
    if(!(least < most) || wall_.is_within(middle, least) || wall_.meets(before.centre, middle))
      return std::nullopt;
    return Inner_ball{middle, wall_.nearest(middle, most, precision).distance};
  }

  // Two arcs as far as two walkers came by one line.
  Index
  replace(Index joint, const std::vector<Inner_ball>& line, const std::array<Walker, 2>& ends) {
    const Index component = draft_[joint].component;
    for(const Walker& end : ends)
      cut_off(joint, end);
    Index stem = joint, last = joint;
    for(std::size_t i = 1; i < line.size(); ++i) {
      stem = std::exchange(last, draft_.add(line[i], component));
      draft_.join(stem, last);
    }
    const Inner_ball& there = line.back();
    for(const Walker& end : ends) {
      const Index place =
          draft_.add({end.point, there.radius - norm(end.point - there.centre)}, component);
      draft_.join(last, place);
      draft_.join(place, end.next);
    }
    draft_.draw_star(last, there, stem, wall_);
    return last;
  }

  // Takes away what is between a joint and a walker.
  void cut_off(Index joint, const Walker& end) {
    draft_.part(end.before, end.next);
    for(Index place = end.before; place != joint;) {
      const Index next = draft_[place].beside.front();
      draft_.remove(place);
      place = next;
    }
  }

  const Wall& wall_;
  const double spacing_;
  Skeleton_draft& draft_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_ARCS_SIDE_BY_SIDE_H
