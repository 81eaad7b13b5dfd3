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

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/make_set.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SEPARATION_H
