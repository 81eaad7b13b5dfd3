// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_SEPARATION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_SEPARATION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Concurrent_disjoint_sets.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the number of pieces that a surface is without some faces. Almost linear in the size of the
/// mesh.
inline std::size_t
number_of_pieces(Execution execution, const Surgery_mesh& mesh, const std::vector<Index>& out) {
  std::vector<char> is_left(mesh.face_bound());
  for_each_index(execution, is_left.size(),
                 [&](std::size_t f) { is_left[f] = mesh.is_alive(static_cast<Index>(f)); });
  for(Index f : out)
    is_left[f] = 0;
  Concurrent_disjoint_sets sets(execution, is_left.size());
  for_each_index(execution, is_left.size(), [&](std::size_t f) {
    if(is_left[f])
      sets.insert(static_cast<Index>(f));
  });
  for_each_index(execution, 3 * is_left.size(), [&](std::size_t i) {
    const Index h = static_cast<Index>(i), f = mesh.face(h);
    if(is_left[f] && h < mesh.twin(h) && is_left[mesh.face(mesh.twin(h))])
      sets.unite(f, mesh.face(mesh.twin(h)));
  });
  return sets.flatten(execution).size();
}

/// Finds whether a surface falls apart when a region is taken out: the faces beyond both of its
/// borders are gone through in turn, until they meet or one side has no more. Takes no longer than
/// the smaller piece or the way around.
class Separation
{
public:
  bool operator()(const Surgery_mesh& mesh, const Cut_region& region) {
    if(region.number_of_borders() == 1)
      return false; // each piece has a border
    side_of_.resize(mesh.face_bound(), 0);
    sides_ = {};
    for(Index f : region.faces())
      side_of_[f] = in_region;
    const bool separates = !do_sides_meet(mesh, region);
    for(Index f : region.faces())
      side_of_[f] = 0;
    for(const Side& side : sides_)
      for(Index f : side.reached)
        side_of_[f] = 0;
    return separates;
  }

private:
  static constexpr char in_region = 3;

  struct Side
  {
    std::vector<Index> reached;
    std::size_t done = 0;

    bool is_complete() const { return done == reached.size(); }
  };

  bool do_sides_meet(const Surgery_mesh& mesh, const Cut_region& region) {
    for(std::size_t side : {0, 1})
      for(Index h : region.border(side))
        if(visit(mesh.face(mesh.twin(h)), side))
          return true;
    for(std::size_t side = 0; !sides_[side].is_complete(); side = 1 - side)
      if(meets_other(mesh, side))
        return true;
    return false;
  }

  // Goes from the next face of a side to its neighbours.
  bool meets_other(const Surgery_mesh& mesh, std::size_t side) {
    const Index f = sides_[side].reached[sides_[side].done++];
    bool meets = false;
    for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
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
    return side_of_[f] != mark && side_of_[f] != in_region;
  }

  std::vector<char> side_of_; // by face
  std::array<Side, 2> sides_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_SEPARATION_H
