// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_WAY_ALONG_WALL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_WAY_ALONG_WALL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Inner_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_samples.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds ways along the surface, a little inside: from the middle of one piece to that of another, by
the edges between faces, where all places are pushed in. If they are pushed in by little enough
there is nothing in the way: inside of a face, and of two with a common edge, is nothing else of a
surface that does not touch itself. That it is so is tested exactly.
*/
class Way_along_wall
{
public:
  Way_along_wall(const Wall& wall,
                 const Surface_pieces& pieces,
                 const Inner_balls& balls,
                 const Surface_samples& samples)
      : wall_(wall)
      , pieces_(pieces)
      , balls_(balls)
      , samples_(samples) {}

  /// A place on a way, and the piece in the middle of which it is; none on an edge.
  struct Step
  {
    Vector point;
    Index piece;
  };

  /// a shortest walk in the regions a and b, by pieces that are beside each other, from some pieces
  /// to one for which `is_end(piece)` holds; an empty one if there is none.
  template <typename Predicate>
  std::vector<Index>
  walk(const std::vector<Index>& from, const Predicate& is_end, Index a, Index b) const {
    std::unordered_map<Index, Index> before;
    std::vector<Index> reached = from, walk;
    for(Index p : from)
      before.emplace(p, p);
    std::size_t i = 0;
    while(i < reached.size() && !is_end(reached[i]))
      pieces_.for_each_neighbor(reached[i++], [&](Index p) {
        const Index region = samples_.region(p);
        if((region == a || region == b) && before.emplace(p, reached[i - 1]).second)
          reached.push_back(p);
      });
    if(i == reached.size())
      return walk;
    for(walk = {reached[i]}; before[walk.back()] != walk.back();)
      walk.push_back(before[walk.back()]);
    std::reverse(walk.begin(), walk.end());
    return walk;
  }

  /// a closed way around by pieces that are beside each other, from the piece of the sample of
  /// which the first is in the region: there and back.
  std::vector<Step> around(const std::vector<Index>& pieces) const {
    const Index region = samples_.region(pieces.front());
    std::vector<Index> all = walk(
        {samples_.samples()[region].piece}, [&](Index p) { return p == pieces.front(); }, region,
        region);
    const std::vector<Index> back(all.rbegin(), all.rend());
    all.insert(all.end(), pieces.begin() + 1, pieces.end());
    all.insert(all.end(), back.begin(), back.end());
    return way(all);
  }

  /// the way of a walk; nothing on a surface that touches itself or is too thin for doubles.
  std::vector<Step> way(const std::vector<Index>& walk) const {
    std::vector<Place> places;
    for(std::size_t i = 0; i < walk.size(); ++i) {
      if(i > 0 && pieces_.face(walk[i]) != pieces_.face(walk[i - 1]))
        append_edge(walk[i - 1], walk[i], places);
      append_middle(walk[i], places);
    }
    std::vector<Step> way;
    for(const Place& p : places)
      way.push_back({p.point + p.inward, p.piece});
    std::vector<char> is_open(way.size(), 1); // whether the segment that ends here may be met
    constexpr int most_rounds = 60, few_rounds = 6;
    for(int i = 0; i < most_rounds; ++i) {
      if(lower(places, way, is_open))
        return way;
      if(i == few_rounds && is_in_vain(places))
        return {};
    }
    return {};
  }

private:
  struct Place
  {
    Vector point, inward; // as far in as there is room
    Index piece;
  };

  // Faces without a normal are passed over.
  void append_middle(Index piece, std::vector<Place>& places) const {
    const Index f = pieces_.face(piece);
    if(const std::optional<Vector> normal = balls_.inward_normal(f)) {
      const Vector middle = pieces_.centre(piece);
      places.push_back({middle, depth(middle, *normal, f) * *normal, piece});
    }
  }

  double depth(const Vector& place, const Vector& direction, Index f) const {
    constexpr double part = 0.25;
    const double way = wall_.free_way(place, direction, f);
    return part * (std::min)(way, norm(wall_.corner(f, 1) - wall_.corner(f, 0)));
  }

  void append_edge(Index p, Index q, std::vector<Place>& places) const {
    const Index f = pieces_.face(p), g = pieces_.face(q);
    const auto normal_f = balls_.inward_normal(f), normal_g = balls_.inward_normal(g);
    if(!normal_f || !normal_g || places.empty())
      return;
    const Vector sum = *normal_f + *normal_g, middle = place_on_edge(p, q, f, g);
    const double length = norm(sum), deep = norm(places.back().inward);
    if(length > 0.)
      places.push_back({middle, (deep / length) * sum, no_index});
  }

  // On the common edge of two faces, about between the pieces.
  Vector place_on_edge(Index p, Index q, Index f, Index g) const {
    std::array<Vector, 3> ends;
    int n = 0;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3 && n < 2; ++j)
        if(wall_[f][i] == wall_[g][j])
          ends[n++] = wall_.corner(f, i);
    const Vector between = 0.5 * (pieces_.centre(p) + pieces_.centre(q)), way = ends[1] - ends[0];
    const double square = dot(way, way);
    const double at = square > 0. ? dot(between - ends[0], way) / square : 0.5;
    return ends[0] + (std::max)(0.05, (std::min)(0.95, at)) * way;
  }

  // Whether there is something in the way wherever it may be: a surface that crosses itself.
  bool is_in_vain(const std::vector<Place>& places) const {
    const auto is_met = [&](std::size_t i, double part) {
      return wall_.meets(places[i - 1].point + part * places[i - 1].inward,
                         places[i].point + part * places[i].inward);
    };
    for(std::size_t i = 1; i < places.size(); ++i)
      if(is_met(i, 0x1p-8) && is_met(i, 0x1p-16) && is_met(i, 0x1p-24) && is_met(i, 0x1p-32))
        return true;
    return places.empty();
  }

  // Brings the ends of segments that are not free nearer to the surface. Returns whether all are.
  bool lower(std::vector<Place>& places, std::vector<Step>& way, std::vector<char>& is_open) const {
    std::vector<char> is_lowered(way.size(), 0);
    for(std::size_t i = 1; i < way.size(); ++i)
      if(is_open[i] != 0 && wall_.meets(way[i - 1].point, way[i].point))
        is_lowered[i - 1] = is_lowered[i] = 1;
    bool is_free = !way.empty();
    for(std::size_t i = 0; i < way.size(); ++i) {
      is_open[i] = is_lowered[i] | (i > 0 ? is_lowered[i - 1] : 0);
      if(is_lowered[i] != 0) {
        is_free = false;
        places[i].inward = 0.5 * places[i].inward;
        way[i].point = places[i].point + places[i].inward;
      }
    }
    return is_free;
  }

  const Wall& wall_;
  const Surface_pieces& pieces_;
  const Inner_balls& balls_;
  const Surface_samples& samples_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_WAY_ALONG_WALL_H
