// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_DRAFT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_DRAFT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/climb.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A skeleton that is still changed: places, each with a ball inside, and what they are joined to.
class Skeleton_draft
{
public:
  struct Place
  {
    Inner_ball ball;
    Index component;
    bool is_inlet = false;
    std::vector<Index> beside;
  };

  /// the edges of a graph that are taken, and some balls even if they have no such edge.
  Skeleton_draft(const Ball_graph& graph,
                 const std::vector<char>& is_taken,
                 const std::vector<Index>& roots) {
    std::vector<Index> place_of_ball(graph.balls.size(), no_index);
    const auto place_of = [&](Index ball) {
      Index& place = place_of_ball[ball];
      if(place == no_index) {
        place = static_cast<Index>(places_.size());
        places_.push_back(
            {graph.balls[ball], graph.component[ball], graph.is_inlet[ball] != 0, {}});
      }
      return place;
    };
    for(Index e = 0; e < graph.edges.size(); ++e)
      if(is_taken[e]) { // places are numbered as they come, in the same order by all compilers
        const Index second = place_of(graph.edges[e][1]);
        join(place_of(graph.edges[e][0]), second);
      }
    for(Index root : graph.roots_without_edges(roots, is_taken))
      place_of(root);
  }

  std::size_t size() const { return places_.size(); }
  const Place& operator[](Index p) const { return places_[p]; }
  bool is_node(Index p) const { return places_[p].beside.size() != 2; }

  /*!
  draws joints as stars. In the ball around a joint, all ways are replaced by straight ones from its
  centre to where they leave it: the ball is convex, and joints that come almost at once become one.
  The largest balls first. Caps may cut into balls: \p wall tells.
  */
  void draw_stars(const Wall& wall) {
    for(Index joint : joints())
      if(places_[joint].beside.size() > 2)
        draw_star(joint, middle(joint, wall), no_index, wall);
  }

  /// those with the largest balls first.
  std::vector<Index> joints() const {
    std::vector<Index> joints;
    for(Index p = 0; p < places_.size(); ++p)
      if(places_[p].beside.size() > 2)
        joints.push_back(p);
    std::stable_sort(joints.begin(), joints.end(), [&](Index a, Index b) {
      return places_[a].ball.radius > places_[b].ball.radius;
    });
    return joints;
  }

  /*!
  puts the centre of a ball in the place of a joint and of all that is in the ball and joined to it
  there, but for what is behind \p stem, a place beside it.
  */
  void draw_star(Index joint, const Inner_ball& ball, Index stem, const Wall& wall) {
    std::vector<Index> inside = {joint};
    std::vector<std::pair<Index, Index>> exits;
    std::size_t edges = 0;
    is_inside_.resize(places_.size(), 0);
    is_inside_[joint] = 1;
    for(std::size_t i = 0; i < inside.size(); ++i)
      for(Index p : places_[inside[i]].beside) {
        if(is_inside_[p] != 0)
          ++edges;
        else if(p != stem && is_within(p, ball)) {
          ++edges;
          is_inside_[p] = 1;
          inside.push_back(p);
        } else
          exits.emplace_back(inside[i], p);
      }
    // Each edge inside has been seen from both ends, but that to a new place from one.
    const bool is_tree = edges == 2 * (inside.size() - 1);
    for(Index p : inside)
      is_inside_[p] = 0;
    if(!is_tree || (inside.size() == 1 && ball.centre == places_[joint].ball.centre))
      return;
    for(const auto& [from, to] : exits)
      if(wall.meets_cap(ball.centre, way_out(ball, places_[from].ball.centre, to)))
        return;
    std::vector<Vector> from_places;
    for(const auto& exit : exits)
      from_places.push_back(places_[exit.first].ball.centre);
    for(Index p : inside)
      remove(p);
    places_[joint].ball = ball;
    for(std::size_t i = 0; i < exits.size(); ++i)
      lead_out(joint, ball, from_places[i], exits[i].second);
  }

  // ---- changes

  Index add(const Inner_ball& ball, Index component) {
    places_.push_back({ball, component, false, {}});
    return static_cast<Index>(places_.size() - 1);
  }

  void join(Index p, Index q) {
    places_[p].beside.push_back(q);
    places_[q].beside.push_back(p);
  }

  /// takes a place away, with what joins it to others.
  void remove(Index p) {
    while(!places_[p].beside.empty())
      part(p, places_[p].beside.back());
    places_[p].ball.radius = -1.; // is no more
  }

  void part(Index p, Index q) {
    for(const auto& [a, b] : {std::make_pair(p, q), std::make_pair(q, p)}) {
      std::vector<Index>& beside = places_[a].beside;
      beside.erase(std::find(beside.begin(), beside.end(), b));
    }
  }

  static constexpr double within = 0.9; ///< the part of the radius of a ball that a star fills

  /// the paths between nodes, each once, by the numbers of their places; and the cycles without a
  /// node, which begin and end at the same place.
  std::vector<std::vector<Index>> arcs() const {
    std::vector<std::vector<Index>> arcs;
    std::vector<char> is_passed(places_.size(), 0);
    const auto follow = [&](Index from, Index to) {
      std::vector<Index> arc = {from, to};
      while(!is_node(arc.back()) && arc.back() != from) {
        const Index p = arc.back(), before = arc[arc.size() - 2];
        is_passed[p] = 1;
        const std::vector<Index>& beside = places_[p].beside;
        arc.push_back(beside[0] == before ? beside[1] : beside[0]);
      }
      return arc;
    };
    for(Index p = 0; p < places_.size(); ++p)
      if(is_node(p))
        for(Index other : places_[p].beside)
          if(is_node(other) ? p < other : is_passed[other] == 0)
            arcs.push_back(follow(p, other));
    for(Index p = 0; p < places_.size(); ++p)
      if(!is_node(p) && is_passed[p] == 0) {
        arcs.push_back(follow(p, places_[p].beside[0]));
        is_passed[p] = 1;
      }
    return arcs;
  }

private:
  bool is_within(Index p, const Inner_ball& ball) const {
    return !places_[p].is_inlet &&
           norm(places_[p].ball.centre - ball.centre) < within * ball.radius;
  }

  // The largest ball found uphill in which the joint still is.
  Inner_ball middle(Index joint, const Wall& wall) const {
    constexpr int most_steps = 12;
    const Inner_ball &start = places_[joint].ball, ball = climb_around(wall, start, most_steps);
    return norm(ball.centre - start.centre) < within * ball.radius ? ball : start;
  }

  // Where the segment to a place leaves a ball.
  Vector way_out(const Inner_ball& ball, const Vector& from, Index to) const {
    return exit_of_ball(ball, within, from, places_[to].ball.centre);
  }

  // By that place.
  void lead_out(Index joint, const Inner_ball& ball, const Vector& from, Index to) {
    const Vector leaving = way_out(ball, from, to);
    if(leaving == places_[to].ball.centre || leaving == ball.centre) {
      join(joint, to);
      return;
    }
    const Index place = add({leaving, (1. - within) * ball.radius}, places_[joint].component);
    join(joint, place);
    join(place, to);
  }

  std::vector<Place> places_;
  std::vector<char> is_inside_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_DRAFT_H
