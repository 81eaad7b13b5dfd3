// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SEPARATION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SEPARATION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What a closed surface is, by counting.
struct Surface_count
{
  std::size_t components = 0;
  std::size_t genus = 0; ///< summed over the components
};

/// the pieces that the faces for which `stays(f)` form, as sets of faces. Linear in the size of the
/// mesh.
template <typename Predicate>
Concurrent_disjoint_sets
pieces(Execution execution, const Surgery_mesh& mesh, const Predicate& stays) {
  Concurrent_disjoint_sets sets(execution, mesh.face_bound());
  for_each_index(execution, mesh.face_bound(), [&](std::size_t f) {
    if(stays(static_cast<Index>(f)))
      sets.insert(static_cast<Index>(f));
  });
  for_each_index(execution, 3 * std::size_t(mesh.face_bound()), [&](std::size_t i) {
    const Index h = static_cast<Index>(i);
    if(stays(mesh.face(h)) && h < mesh.twin(h) && stays(mesh.face(mesh.twin(h))))
      sets.unite(mesh.face(h), mesh.face(mesh.twin(h)));
  });
  return sets;
}

/// the number of pieces of the surface. Linear in its size.
inline std::size_t number_of_pieces(Execution execution, const Surgery_mesh& mesh) {
  return pieces(execution, mesh, [&](Index f) { return mesh.is_alive(f); })
      .flatten(execution)
      .size();
}

/// whether a halfedge has a twin that leads back.
inline bool is_matched(const Surgery_mesh& mesh, Index h) {
  const Index twin = mesh.twin(h);
  return twin != no_index && mesh.is_alive(mesh.face(twin)) && mesh.twin(twin) == h &&
         mesh.source(twin) == mesh.target(h) && mesh.target(twin) == mesh.source(h);
}

/// whether each halfedge has a twin that leads back, and the faces at each vertex are one fan that
/// comes to no neighbour twice.
inline bool is_closed_manifold(Execution execution, const Surgery_mesh& mesh) {
  std::atomic<bool> is_good(true);
  for_each_index(execution, 3 * std::size_t(mesh.face_bound()), [&](std::size_t i) {
    const Index h = static_cast<Index>(i);
    if(mesh.is_alive(mesh.face(h)) && !is_matched(mesh, h))
      is_good = false;
  });
  if(!is_good)
    return false; // not all fans end
  std::atomic<std::size_t> number_in_fans(0);
  execution.for_ranges(mesh.vertex_bound(), 16384, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> neighbors;
    std::size_t number = 0;
    for(Index v = static_cast<Index>(begin); v < end; ++v) {
      neighbors.clear();
      mesh.for_each_outgoing(v, [&](Index h) { neighbors.push_back(mesh.target(h)); });
      number += neighbors.size();
      std::sort(neighbors.begin(), neighbors.end());
      if(std::adjacent_find(neighbors.begin(), neighbors.end()) != neighbors.end())
        is_good = false;
    }
    number_in_fans += number;
  });
  return is_good && number_in_fans == 3 * mesh.number_of_faces();
}

/// throws `std::logic_error` if the mesh is no closed manifold, which nothing that is done to it
/// may make of it. Linear in the size of the mesh.
inline Surface_count count_surface(Execution execution, const Surgery_mesh& mesh) {
  if(!is_closed_manifold(execution, mesh))
    throw std::logic_error("the surface is no closed manifold after the removal of handles");
  Surface_count count;
  count.components = number_of_pieces(execution, mesh);
  std::size_t vertices = 0;
  for(Index v = 0; v < mesh.vertex_bound(); ++v)
    vertices += mesh.outgoing(v) != no_index;
  // V - E + F = 2 c - 2 g, with 2 E = 3 F.
  count.genus = (2 * count.components + mesh.number_of_faces() / 2 - vertices) / 2;
  return count;
}

/// Where a surface is cut: the halfedges on either side, whose faces stay and are not joined across
/// them any more.
using Sides_of_cut = std::array<std::vector<Index>, 2>;

/// the sides of a region with two borders.
inline Sides_of_cut sides_of(const Surgery_mesh& mesh, const Cut_region& region) {
  Sides_of_cut sides;
  for(std::size_t side : {0, 1})
    for(Index h : region.border(side))
      sides[side].push_back(mesh.twin(h));
  return sides;
}

/// the sides of a simple closed walk.
inline Sides_of_cut sides_of(const Surgery_mesh& mesh, const Closed_walk& walk) {
  Sides_of_cut sides;
  sides[0] = halfedges_of(mesh, walk);
  for(Index h : sides[0])
    sides[1].push_back(mesh.twin(h));
  return sides;
}

/// Finds whether a surface falls apart along a cut: the faces on both sides are gone through in
/// turn, until they meet or one side has no more. Takes no longer than the smaller piece or the way
/// around.
class Separation
{
public:
  bool operator()(const Surgery_mesh& mesh, const Sides_of_cut& cut) {
    walls_ = cut[0];
    walls_.insert(walls_.end(), cut[1].begin(), cut[1].end());
    make_set(walls_);
    side_of_.resize(mesh.face_bound(), 0);
    sides_ = {};
    const bool separates = !do_sides_meet(mesh, cut);
    for(const Side& side : sides_)
      for(Index f : side.reached)
        side_of_[f] = 0;
    return separates;
  }

private:
  struct Side
  {
    std::vector<Index> reached;
    std::size_t number_at_walls = 0; // which are reached first
    std::size_t done = 0;

    bool is_complete() const { return done == reached.size(); }
  };

  bool do_sides_meet(const Surgery_mesh& mesh, const Sides_of_cut& cut) {
    for(std::size_t side : {0, 1})
      for(Index h : cut[side])
        if(visit(mesh.face(h), side))
          return true;
    for(Side& side : sides_)
      side.number_at_walls = side.reached.size();
    for(std::size_t side = 0; !sides_[side].is_complete(); side = 1 - side)
      if(meets_other(mesh, side))
        return true;
    return false;
  }

  // Goes from the next face of a side to its neighbours.
  bool meets_other(const Surgery_mesh& mesh, std::size_t side) {
    const bool is_at_wall = sides_[side].done < sides_[side].number_at_walls;
    const Index f = sides_[side].reached[sides_[side].done++];
    bool meets = false;
    for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
      if(!is_at_wall || !is_in(h, walls_))
        meets = visit(mesh.face(mesh.twin(h)), side) || meets;
    return meets;
  }

  // Whether the other side was here.
  bool visit(Index f, std::size_t side) {
    const char mark = static_cast<char>(side + 1);
    if(side_of_[f] == 0) {
      side_of_[f] = mark;
      sides_[side].reached.push_back(f);
    }
    return side_of_[f] != mark;
  }

  std::vector<char> side_of_; // by face
  std::vector<Index> walls_;  // in ascending order
  std::array<Side, 2> sides_;
};

/// Which of some strips, that share no vertices, would separate the surface if they were taken out
/// and closed in this order, but for those that would. Near linear in the size of the mesh, however
/// many strips there are.
inline std::vector<char> separating_strips(Execution execution,
                                           const Surgery_mesh& mesh,
                                           const std::vector<const Cut_region*>& strips) {
  std::vector<char> is_taken_out(mesh.face_bound(), 0);
  for(const Cut_region* strip : strips)
    for(Index f : strip->faces())
      is_taken_out[f] = 1;
  Concurrent_disjoint_sets left =
      pieces(execution, mesh, [&](Index f) { return mesh.is_alive(f) && !is_taken_out[f]; });
  // The last ones that are needed to join what is left stay.
  std::vector<char> separates(strips.size(), 0);
  for(std::size_t i = strips.size(); i-- > 0;) {
    const auto beyond = [&](std::size_t border) {
      return mesh.face(mesh.twin(strips[i]->border(border).front()));
    };
    separates[i] = left.root(beyond(0)) != left.root(beyond(1));
    left.unite(beyond(0), beyond(1));
  }
  return separates;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SEPARATION_H
