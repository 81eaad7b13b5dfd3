// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_BALL_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_BALL_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Edges_at.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Inner_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_samples.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Way_along_wall.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/climb.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sorted_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A graph inside a surface: balls and segments between their centres.
struct Ball_graph
{
  using Edge = std::array<Index, 2>;

  std::vector<Inner_ball> balls;
  std::vector<Index> component;      ///< by ball
  std::vector<char> is_inlet;        ///< by ball, whether it is only a place: the hub of a cap
  std::vector<Edge> edges;           ///< the smaller number first, sorted
  std::vector<Index> ball_of_sample; ///< by sample
  Edges_at edges_at;                 ///< by ball
  /// samples that a ball touches on two sides of the solid
  std::vector<std::pair<Index, Index>> opposites;
  /// samples of which the regions meet, and that nothing joins
  std::vector<std::pair<Index, Index>> apart;
  std::vector<char> is_at_rim;  ///< by sample, whether the solid goes on on its other side
  std::vector<double> breadths; ///< by ball; of those that were added later none

  /// no less than the radius.
  double breadth(Index ball) const {
    return ball < breadths.size() ? (std::max)(breadths[ball], balls[ball].radius)
                                  : balls[ball].radius;
  }

  Index other_end(Index edge, Index ball) const {
    return edges[edge][0] == ball ? edges[edge][1] : edges[edge][0];
  }

  /// `no_index` if there is none.
  Index edge_between(Index a, Index b) const {
    for(const Index e : edges_at[a])
      if(other_end(e, a) == b)
        return e;
    return no_index;
  }

  /// calls `f(ball, edge)` for what is beside a ball.
  template <typename Function> void for_each_beside(Index ball, const Function& f) const {
    for(Index e : edges_at[ball])
      f(other_end(e, ball), e);
  }

  /// lets paths grow along edges that cost `cost(edge)`. The label of a ball behind another is
  /// `next(label, distance, edge)`.
  template <typename Label, typename Cost, typename Next>
  void grow(Shortest_paths<Label>& paths, const Cost& cost, const Next& next) const {
    paths.grow([&](Index b) {
      for_each_beside(b, [&](Index other, Index e) {
        const double distance = paths[b].distance + cost(e);
        if(distance < paths[other].distance)
          paths.reach(other, next(paths[b], distance, e));
      });
    });
  }

  /// calls `f(ball, edge)` on the way by which a ball was reached, back to where that begins.
  template <typename Label, typename Function>
  void for_each_back(const Shortest_paths<Label>& paths, Index ball, const Function& f) const {
    for(Index e = paths[ball].edge; e != no_index; e = paths[ball].edge)
      f(ball = other_end(e, ball), e);
  }

  double length(Index edge) const {
    return norm(balls[edges[edge][1]].centre - balls[edges[edge][0]].centre);
  }

  /// of balls, one by component or none, those of components without an edge that is taken.
  std::vector<Index> roots_without_edges(const std::vector<Index>& roots,
                                         const std::vector<char>& is_taken) const {
    std::vector<char> has_edge(roots.size(), 0);
    for(Index e = 0; e < edges.size(); ++e)
      if(is_taken[e] != 0)
        has_edge[component[edges[e][0]]] = 1;
    std::vector<Index> found;
    for(std::size_t c = 0; c < roots.size(); ++c)
      if(has_edge[c] == 0 && roots[c] != no_index)
        found.push_back(roots[c]);
    return found;
  }

  /// sorts the edges and finds those at each ball.
  void link() {
    for(Edge& e : edges)
      if(e[0] > e[1])
        std::swap(e[0], e[1]);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    edges_at = Edges_at(balls.size(), edges);
  }
};

/*!
Builds the graph of the balls of samples. Of balls with nearly the same centre the largest stays.
Two are joined if regions of their samples meet: by a segment if that is inside, which it is if the
balls overlap; or else by way of places nearer to the surface, where the two are beside each other:
along the surface itself only if nothing else connects them.
*/
class Ball_graph_builder
{
public:
  Ball_graph_builder(Execution execution,
                     const Wall& wall,
                     const Surface_pieces& pieces,
                     const Inner_balls& balls,
                     const Surface_samples& samples,
                     const std::vector<std::pair<Index, Index>>& neighbors)
      : execution_(execution)
      , wall_(wall)
      , pieces_(pieces)
      , balls_(balls)
      , samples_(samples)
      , neighbors_(neighbors) {}

  Ball_graph build() {
    choose_balls();
    find_opposites();
    join_neighbors();
    join_surfaces();
    graph_.link();
    put_balls_into_necks();
    graph_.link();
    return std::move(graph_);
  }

  /// joins what is apart in a graph that has been built, along the wall.
  void join_along_wall(Ball_graph& graph) {
    graph_ = std::move(graph);
    for(const Pair& p : std::exchange(graph_.apart, {}))
      join_by_detour(p.first, p.second, true);
    graph_.link();
    graph = std::move(graph_);
  }

  /// adds closed ways along the wall by these pieces to a graph that has been built.
  void add_ways_along_wall(const std::vector<std::vector<Index>>& paths, Ball_graph& graph) {
    graph_ = std::move(graph);
    for(const std::vector<Index>& path : paths) {
      const Index sample = samples_.region(path.front());
      if(sample == no_index) // of a component without balls
        continue;
      const std::vector<Way_along_wall::Step> around = way_along_wall_.around(path);
      if(around.empty())
        continue;
      const Index first = append(ball_at_place(sample), around.front().point);
      Index last = first;
      for(std::size_t i = 1; i < around.size(); ++i)
        last = append(last, around[i].point);
      graph_.edges.push_back({last, first}); // along the normal
    }
    graph_.link();
    graph = std::move(graph_);
  }

private:
  using Pair = std::pair<Index, Index>;

  static constexpr double sure = 0.85;          // part of the radii of balls that meet for sure
  static constexpr double part_of_radius = 0.2; // between centres that are told from each other

  const Inner_ball& ball(Index sample) const { return samples_.samples()[sample].ball; }

  void choose_balls() {
    const std::size_t n = samples_.samples().size();
    std::vector<Box<3>> centres;
    for(Index s = 0; s < n; ++s)
      centres.push_back({ball(s).centre, ball(s).centre});
    const Sorted_boxes<3> sorted(execution_, centres);
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return ball(a).radius > ball(b).radius; });
    graph_.ball_of_sample.assign(n, no_index);
    for(Index s : order)
      if(graph_.ball_of_sample[s] == no_index)
        add_ball(s, sorted);
  }

  void add_ball(Index s, const Sorted_boxes<3>& centres) {
    const Index component = component_of(s), number = add_ball(ball(s), component);
    const double extent = part_of_radius * ball(s).radius;
    const Vector& centre = ball(s).centre;
    const Vector corner = {extent, extent, extent};
    centres.for_each_meeting({centre - corner, centre + corner}, [&](Index other, const Box<3>&) {
      if(graph_.ball_of_sample[other] == no_index && component_of(other) == component &&
         norm(ball(other).centre - centre) < extent)
        graph_.ball_of_sample[other] = number;
    });
    graph_.ball_of_sample[s] = number;
  }

  Index add_ball(const Inner_ball& ball, Index component) {
    graph_.balls.push_back(ball);
    graph_.component.push_back(component);
    graph_.is_inlet.push_back(0);
    return static_cast<Index>(graph_.balls.size() - 1);
  }

  // Where the solid is thin, its two sides are neighbours nowhere but at the rim.
  void find_opposites() {
    constexpr double part = 0.5; // of the radius
    const std::size_t n = samples_.samples().size();
    std::vector<Index> opposite(n, no_index);
    graph_.is_at_rim.resize(n);
    for_each_index(
        execution_, n,
        [&](std::size_t i) {
          const Index s = static_cast<Index>(i);
          const Vector other_side = 2. * ball(s).centre - place(s);
          const Wall::Nearest there = wall_.nearest(other_side, part * ball(s).radius);
          if(there.face != no_index && !wall_.is_of_cap(there.face) &&
             wall_.component(there.face) == component_of(s))
            opposite[s] = samples_.region(pieces_.piece_at(there.face, there.point));
          graph_.is_at_rim[s] = there.face == no_index && is_room_behind(s);
        },
        256);
    for(Index s = 0; s < n; ++s)
      if(const Index other = opposite[s]; other != no_index && other != s)
        graph_.opposites.emplace_back((std::min)(s, other), (std::max)(s, other));
    std::sort(graph_.opposites.begin(), graph_.opposites.end());
    graph_.opposites.erase(std::unique(graph_.opposites.begin(), graph_.opposites.end()),
                           graph_.opposites.end());
  }

  // Whether a ball that touches at its place can be moved away from there.
  bool is_room_behind(Index s) const {
    constexpr double most = 1.5, part = 0.9, step = 0.5; // of the radius
    const Vector out = ball(s).centre - place(s);
    const double radius = ball(s).radius, distance = norm(out);
    return distance > 0. && distance < most * radius &&
           !wall_.is_within(ball(s).centre + (step * radius / distance) * out, part * radius);
  }

  void join_neighbors() {
    // The first of those between the same balls.
    const auto balls_of = [&](const Pair& p) {
      const Index a = graph_.ball_of_sample[p.first], b = graph_.ball_of_sample[p.second];
      return a < b ? Pair(a, b) : Pair(b, a);
    };
    std::vector<Pair> ends;
    for(const std::vector<Pair>& pairs : {neighbors_, graph_.opposites})
      for(const Pair& p : pairs)
        if(const Pair b = balls_of(p); b.first != b.second)
          ends.push_back(b);
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<char> is_inside(ends.size());
    for_each_index(
        execution_, ends.size(),
        [&](std::size_t i) {
          is_inside[i] = is_way_free(graph_.balls[ends[i].first], graph_.balls[ends[i].second]);
        },
        256);
    Sets_of_indices connected(graph_.balls.size());
    for(std::size_t i = 0; i < ends.size(); ++i)
      if(is_inside[i]) {
        graph_.edges.push_back({ends[i].first, ends[i].second});
        connected.unite(ends[i].first, ends[i].second);
      }
    for(const Pair& p : neighbors_) {
      const Pair b = balls_of(p);
      if(b.first == b.second ||
         is_inside[std::lower_bound(ends.begin(), ends.end(), b) - ends.begin()])
        continue;
      const bool is_needed = connected.find(b.first) != connected.find(b.second);
      if(join_by_detour(p.first, p.second, is_needed))
        connected.unite(b.first, b.second);
      else
        graph_.apart.push_back(p);
    }
  }

  // The surface of a cavity has no neighbours on the one around it: what is not joined across the
  // solid yet is joined where one is seen from the other, at the shortest distance first.
  void join_surfaces() {
    if(!wall_.has_cavities())
      return;
    Sets_of_indices joined = joined_samples();
    struct Sight
    {
      double way;
      Index from, piece, to; // a piece in the region of another sample
    };
    std::vector<Sight> sights;
    for(Index s = 0; s < samples_.samples().size(); ++s)
      if(const auto inward = balls_.inward_normal(face(s))) {
        const auto [way, met] = wall_.first_on_way(place(s), *inward, face(s));
        if(met == no_index || wall_.is_of_cap(met) || wall_.component(met) != component_of(s))
          continue;
        const Index piece = pieces_.piece_at(met, place(s) + way * *inward),
                    to = samples_.region(piece);
        if(to != no_index && joined.find(s) != joined.find(to))
          sights.push_back({way, s, piece, to});
      }
    std::stable_sort(sights.begin(), sights.end(),
                     [](const Sight& a, const Sight& b) { return a.way < b.way; });
    for(const Sight& sight : sights)
      if(joined.find(sight.from) != joined.find(sight.to) &&
         (join_by_detour(sight.from, sight.to, false) ||
          join_in_sight(sight.from, sight.piece, sight.to)))
        joined.unite(sight.from, sight.to);
  }

  // Along the normal of a sample, across to a piece that it meets, and along the wall to the sample
  // in the region of which that is.
  bool join_in_sight(Index a, Index piece, Index b) {
    constexpr int most_halvings = 12;
    const std::vector<Way_along_wall::Step> way = way_along_wall_.way(way_along_wall_.walk(
        {piece}, [&](Index p) { return p == samples_.samples()[b].piece; }, b, b));
    if(way.empty())
      return false;
    Vector up = balls_.way(place(a), face(a)).front() - place(a);
    for(int i = 0; i < most_halvings; ++i, up = 0.5 * up)
      if(const Vector p = place(a) + up; !wall_.meets(p, way.front().point)) {
        Index last = append(ball_at_place(a), p);
        for(const Way_along_wall::Step& step : way)
          last = append(last, step.point);
        graph_.edges.push_back({last, ball_at_place(b)}); // along the normal
        return true;
      }
    return false;
  }

  // Samples of one surface, and those of which balls are the same, or joined.
  Sets_of_indices joined_samples() const {
    Sets_of_indices joined(samples_.samples().size());
    for(const Pair& p : neighbors_)
      joined.unite(p.first, p.second);
    std::vector<Index> sample(graph_.balls.size(), no_index); // by ball, one of those that have it
    for(Index s = 0; s < graph_.ball_of_sample.size(); ++s)
      if(Index& first = sample[graph_.ball_of_sample[s]]; first == no_index)
        first = s;
      else
        joined.unite(first, s);
    for(const auto& [a, b] : graph_.edges)
      if(sample[a] != no_index && sample[b] != no_index)
        joined.unite(sample[a], sample[b]);
    return joined;
  }

  // Between large balls that leave some of an edge open, there may be no place that sees how narrow
  // it is there: as where two wheels are on one axle.
  void put_balls_into_necks() {
    const std::vector<Ball_graph::Edge> edges = graph_.edges;
    std::vector<Inner_ball> necks(edges.size(), {{}, 0.});
    for_each_index(
        execution_, edges.size(), [&](std::size_t e) { necks[e] = neck(edges[e]); }, 256);
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(const auto [a, b] = edges[e]; necks[e].radius > 0.) {
        const Index between = add_ball(necks[e], graph_.component[a]);
        graph_.edges[e] = {a, between};
        graph_.edges.push_back({b, between});
        for(const Index end : {a, b})
          for(const Index beside : graph_.edges_at[end])
            join_if_they_meet(edges[beside][edges[beside][0] == end ? 1 : 0], between);
      }
  }

  // On an edge; without a radius if there is none. Where a larger ball holds the place, it is only
  // that the edge passes close to the surface.
  Inner_ball neck(const Ball_graph::Edge& edge) const {
    constexpr double longest = 3., narrow = 0.5; // times the radii
    constexpr int most_steps = 6;
    const Inner_ball &a = graph_.balls[edge[0]], &b = graph_.balls[edge[1]];
    const double length = norm(b.centre - a.centre), radii = a.radius + b.radius,
                 most = narrow * (std::min)(a.radius, b.radius);
    if(!(length > radii && length < longest * radii))
      return {a.centre, 0.};
    const double part = 0.5 * (length + a.radius - b.radius) / length;
    const Vector middle = a.centre + part * (b.centre - a.centre);
    const Inner_ball ball = {middle, wall_.nearest(middle, most).distance};
    return ball.radius < most && climb_around(wall_, ball, most_steps).radius < most
               ? ball
               : Inner_ball{middle, 0.};
  }

  void join_if_they_meet(Index a, Index b) {
    const Inner_ball &p = graph_.balls[a], &q = graph_.balls[b];
    if(norm(q.centre - p.centre) < sure * (p.radius + q.radius) &&
       !wall_.meets_cap(p.centre, q.centre))
      graph_.edges.push_back({a, b});
  }

  bool is_way_free(const Inner_ball& a, const Inner_ball& b) const {
    return norm(b.centre - a.centre) < sure * (a.radius + b.radius)
               ? !wall_.meets_cap(a.centre, b.centre)
               : !wall_.meets(a.centre, b.centre);
  }

  // From the centres towards the surface, until there is a free way; if it is needed, as far as to
  // the wall. Returns whether there is one.
  bool join_by_detour(Index a, Index b, bool is_needed) {
    const std::vector<Vector> from = balls_.way(place(a), face(a)),
                              to = balls_.way(place(b), face(b));
    if(from.empty() || to.empty())
      return false;
    if(!wall_.meets(from.back(), to.back())) {
      join(graph_.ball_of_sample[a], {from.back(), to.back()}, graph_.ball_of_sample[b]);
      return true;
    }
    const std::vector<Vector> between = free_way(a, from.front(), b, to.front());
    if(between.empty())
      return is_needed && join_by_pieces(a, b);
    const Index end = ball_at_place(b); // numbered as it comes, in the same order by all compilers
    join(ball_at_place(a), between, end);
    return true;
  }

  // Straight from one to the other of two ways from the surface to these places, as far from the
  // surface as may be.
  std::vector<Vector> free_way(Index a, const Vector& from, Index b, const Vector& to) const {
    constexpr int most_halvings = 12;
    double part = 1.;
    for(int i = 0; i < most_halvings; ++i, part *= 0.5) {
      const Vector p = place(a) + part * (from - place(a)), q = place(b) + part * (to - place(b));
      if(!wall_.meets(p, q))
        return {p, q};
    }
    return {};
  }

  Index component_of(Index sample) const { return wall_.component(face(sample)); }
  Vector place(Index sample) const { return samples_.place(sample); }
  Index face(Index sample) const { return pieces_.face(samples_.samples()[sample].piece); }

  // Along the wall, between ways that have been there before: each piece is passed about once.
  bool join_by_pieces(Index a, Index b) {
    for(const Index s : {a, b})
      ball_at_place(s);
    if(pieces_passed_[a].size() > pieces_passed_[b].size())
      std::swap(a, b);
    const std::vector<Index> walk = way_along_wall_.walk(
        pieces_passed_[a],
        [&](Index p) { return samples_.region(p) == b && ball_of_piece_.count(p) > 0; }, a, b);
    const std::vector<Way_along_wall::Step> way = way_along_wall_.way(walk);
    if(way.empty())
      return false;
    std::vector<Index> balls = {ball_of_piece_.at(walk.front())};
    for(const Way_along_wall::Step& step : way)
      balls.push_back(append(balls.back(), step.point));
    graph_.edges.push_back({balls.back(), ball_of_piece_.at(walk.back())}); // along the normal
    for(std::size_t i = 0; i < way.size() && pass(way[i].piece, a, balls[i + 1]);)
      ++i;
    for(std::size_t i = way.size(); i > 0 && pass(way[i - 1].piece, b, balls[i]);)
      --i;
    return true;
  }

  // Notes the ball of a piece, by which others can be joined to a sample: one in its region.
  bool pass(Index piece, Index sample, Index ball) {
    if(piece == no_index)
      return true;
    if(samples_.region(piece) != sample)
      return false;
    if(ball_of_piece_.emplace(piece, ball).second)
      pieces_passed_[sample].push_back(piece);
    return true;
  }

  // The first of the balls that grow from the place of a sample, joined to the last one.
  Index ball_at_place(Index s) {
    const Index piece = samples_.samples()[s].piece;
    if(const auto known = ball_of_piece_.find(piece); known != ball_of_piece_.end())
      return known->second;
    const std::vector<Vector> way = balls_.way(place(s), face(s));
    Index last = graph_.ball_of_sample[s];
    for(auto p = way.rbegin(); p != way.rend(); ++p)
      last = append(last, *p);
    pass(piece, s, last);
    return last;
  }

  // By these places.
  void join(Index a, const std::vector<Vector>& places, Index b) {
    for(const Vector& p : places)
      a = append(a, p);
    if(a != b)
      graph_.edges.push_back({a, b});
  }

  // Leads on from a ball to a place, if that is another one. Returns the last ball.
  Index append(Index before, const Vector& p) {
    if(p == graph_.balls[before].centre)
      return before;
    const Inner_ball ball = {p, wall_.nearest(p, ball_limit(p, before)).distance};
    const Index next = add_ball(ball, graph_.component[before]);
    graph_.edges.push_back({before, next});
    return next;
  }

  // The distance to the surface changes no faster than one goes.
  double ball_limit(const Vector& p, Index before) const {
    return graph_.balls[before].radius + norm(p - graph_.balls[before].centre);
  }

  Execution execution_;
  const Wall& wall_;
  const Surface_pieces& pieces_;
  const Inner_balls& balls_;
  const Surface_samples& samples_;
  const std::vector<Pair>& neighbors_;
  Way_along_wall way_along_wall_{wall_, pieces_, balls_, samples_};
  std::unordered_map<Index, Index> ball_of_piece_;              // on ways along the wall
  std::unordered_map<Index, std::vector<Index>> pieces_passed_; // by sample
  Ball_graph graph_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_BALL_GRAPH_H
