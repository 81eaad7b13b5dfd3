// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOPS_AROUND_VERTEX_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOPS_AROUND_VERTEX_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds short closed walks near a vertex that bound no disc there, in the ball of what is near the
vertex: with a tree of shortest paths to it, each other edge closes a walk. A face that has but one
other edge that is open is closed along that, one after the other; the walks of these edges bound
discs. The edges that are left form chains of faces, of which all walks are homotopic, so that one
of each is enough.

Whether a walk bounds something beyond the ball is not known here. Takes `O(n log n)` for a ball of
`n` vertices.
*/
class Loops_around_vertex
{
public:
  explicit Loops_around_vertex(const Surgery_mesh& mesh)
      : mesh_(mesh)
      , reached_(mesh.vertex_bound()) {}

  /// those that come to no vertex twice, the shortest way to the vertex and back first. The ball
  /// has this radius, measured along edges, and no more than \p most_vertices.
  std::vector<Closed_walk> operator()(Index root, double radius, std::size_t most_vertices) {
    reached_.resize(mesh_.vertex_bound());
    sides_.resize(mesh_.face_bound());
    find_ball(root, radius, most_vertices);
    find_faces();
    close_discs();
    std::vector<Closed_walk> walks;
    for(const Closing_edge& e : chains())
      walks.push_back(walk(e.second));
    clear();
    return walks;
  }

private:
  struct Reached
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index halfedge = no_index; // that leads there
    bool is_settled = false;
  };

  using Sides = std::array<bool, 3>;             // of a face, which are open
  using Closing_edge = std::pair<double, Index>; // the length of its walk to the root, a halfedge

  void find_ball(Index root, double radius, std::size_t most_vertices) {
    reached_.reach(root, {0.});
    reached_.grow([&](double d) { return d <= radius && ball_.size() < most_vertices; },
                  [&](Index v) {
                    reached_[v].is_settled = true;
                    ball_.push_back(v);
                    mesh_.for_each_outgoing(v, [&](Index h) {
                      const Index u = mesh_.target(h);
                      const double d = reached_[v].distance + distance(mesh_, v, u);
                      if(d < reached_[u].distance)
                        reached_.reach(u, {d, h});
                    });
                  });
  }

  bool is_in_ball(Index f) const {
    const Surgery_mesh::Face& c = mesh_.corners(f);
    return reached_[c[0]].is_settled && reached_[c[1]].is_settled && reached_[c[2]].is_settled;
  }

  bool is_in_tree(Index h) const {
    return reached_[mesh_.target(h)].halfedge == h ||
           reached_[mesh_.source(h)].halfedge == mesh_.twin(h);
  }

  int number_open(Index f) const { return sides_[f][0] + sides_[f][1] + sides_[f][2]; }

  bool is_open(Index h) const { return sides_[mesh_.face(h)][h % 3]; }

  void close(Index h) {
    for(Index side : {h, mesh_.twin(h)})
      sides_[mesh_.face(side)][side % 3] = false;
  }

  // Those with all corners in the ball. All sides are open then that are not in the tree.
  void find_faces() {
    for(Index v : ball_)
      mesh_.for_each_outgoing(v, [&](Index h) {
        const Index f = mesh_.face(h);
        if(v == (std::min)({mesh_.corners(f)[0], mesh_.corners(f)[1], mesh_.corners(f)[2]}) &&
           is_in_ball(f))
          faces_.push_back(f);
      });
    for(Index f : faces_)
      for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
        sides_[f][h % 3] = !is_in_tree(h);
  }

  // What is around the ball is never closed.
  void close_discs() {
    std::vector<Index> faces = faces_;
    while(!faces.empty()) {
      const Index f = faces.back();
      faces.pop_back();
      if(number_open(f) != 1)
        continue;
      const Index h = open_side(f);
      close(h);
      faces.push_back(mesh_.face(mesh_.twin(h)));
    }
  }

  Index open_side(Index f) const { return 3 * f + (sides_[f][0] ? 0 : sides_[f][1] ? 1 : 2); }

  // The shortest one of each.
  std::vector<Closing_edge> chains() const {
    std::vector<Closing_edge> edges;
    std::unordered_set<Index> seen;
    for(Index f : faces_)
      for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
        if(is_open(h) && seen.insert((std::min)(h, mesh_.twin(h))).second)
          edges.push_back(shortest_of_chain(h, seen));
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  Closing_edge shortest_of_chain(Index h, std::unordered_set<Index>& seen) const {
    Closing_edge shortest = closing_edge(h);
    for(Index side : {h, mesh_.twin(h)})
      while(number_open(mesh_.face(side)) == 2) {
        const Index across = is_open(Surgery_mesh::next(side)) ? Surgery_mesh::next(side)
                                                               : Surgery_mesh::previous(side);
        side = mesh_.twin(across);
        if(!seen.insert((std::min)(side, across)).second)
          break; // the chain is closed
        shortest = (std::min)(shortest, closing_edge(side));
      }
    return shortest;
  }

  Closing_edge closing_edge(Index h) const {
    const Index u = mesh_.source(h), v = mesh_.target(h);
    return {reached_[u].distance + distance(mesh_, u, v) + reached_[v].distance, h};
  }

  // Without what both ways to the root have in common.
  Closed_walk walk(Index h) const {
    Closed_walk walk = way_to_root(mesh_.source(h)), back = way_to_root(mesh_.target(h));
    while(walk.size() > 1 && back.size() > 1 && walk[walk.size() - 2] == back[back.size() - 2]) {
      walk.pop_back();
      back.pop_back();
    }
    back.pop_back();
    std::reverse(walk.begin(), walk.end());
    walk.insert(walk.end(), back.begin(), back.end());
    return walk;
  }

  Closed_walk way_to_root(Index v) const {
    Closed_walk way{v};
    for(Index h; (h = reached_[way.back()].halfedge) != no_index;)
      way.push_back(mesh_.source(h));
    return way;
  }

  void clear() {
    reached_.clear();
    for(Index f : faces_)
      sides_[f] = Sides();
    ball_.clear();
    faces_.clear();
  }

  const Surgery_mesh& mesh_;
  Shortest_paths<Reached> reached_; // by vertex
  std::vector<Sides> sides_;        // by face
  // Of the present ball.
  std::vector<Index> ball_; // the vertices that are settled
  std::vector<Index> faces_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_LOOPS_AROUND_VERTEX_H
