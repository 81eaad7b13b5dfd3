// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_DISK_BOUNDARY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_DISK_BOUNDARY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// An arc of a cut, between vertices where not just two free edges meet: it is twice on the
/// boundary of the disk, as the places from `first` to `last`, and from `twin_first` to
/// `twin_last`.
struct Cut_arc
{
  Index first, last, twin_first, twin_last;
  double length;
  bool is_kept;
};

/*!
The boundary of the disk to which a component opens: a cyclic sequence of halfedges, the disk on
their left. Place k is that of the k-th halfedge and of the corner at its source.
*/
class Disk_boundary
{
public:
  /// of the component of a halfedge of the cut; begins at a node.
  Disk_boundary(const Cut_problem& problem, const Cut_graph& cut, Index some_halfedge)
      : problem_(problem)
      , cut_(cut)
      , halfedges_(cut.boundary_from(some_halfedge)) {
    Index node = 0;
    while(node < size() && !is_node(node))
      ++node;
    CGAL_assertion_msg(node < size(), "the cut of a closed surface has a node");
    std::rotate(halfedges_.begin(), halfedges_.begin() + node, halfedges_.end());
  }

  Index size() const { return static_cast<Index>(halfedges_.size()); }
  Index operator[](Index place) const { return halfedges_[place]; }
  Index vertex(Index place) const { return problem_.halfedges.source(halfedges_[place]); }
  const std::vector<Index>& halfedges() const { return halfedges_; }

  /// each edge counts twice.
  double length() const {
    double sum = 0.;
    for(const Index h : halfedges_)
      sum += problem_.weight[h];
    return sum;
  }

  Index next(Index place) const { return place + 1 == size() ? 0 : place + 1; }

  /// how many places on from one to another.
  Index places_from(Index k, Index l) const { return l >= k ? l - k : l + size() - k; }

  /// whether an arc ends at the corner of a place.
  bool is_node(Index place) const {
    const Index v = vertex(place);
    return cut_.degree(v) != 2 || problem_.is_cone(v) ||
           problem_.is_kept(halfedges_[place]) !=
               problem_.is_kept(halfedges_[place == 0 ? size() - 1 : place - 1]);
  }

  /// calls `f(halfedge)` for each halfedge within the corner of a place, on no edge of the cut but
  /// that of the first one.
  template <typename Function> void for_each_in_corner(Index place, const Function& f) const {
    Index h = halfedges_[place];
    do {
      f(h);
      h = problem_.halfedges.after(h);
    } while(!cut_.contains(h));
  }

  /// the arcs; `place(h)` is the place of a halfedge of the boundary.
  template <typename Place> std::vector<Cut_arc> arcs(const Place& place) const {
    std::vector<Cut_arc> arcs;
    for(Index first = 0; first < size();) {
      Index last = first;
      double length = 0.;
      do
        length += problem_.weight[halfedges_[last++]];
      while(last < size() && !is_node(last));
      const Index twin_first = place(problem_.halfedges.twin(halfedges_[last - 1]));
      if(first < twin_first)
        arcs.push_back({first, last == size() ? 0 : last, twin_first,
                        (twin_first + (last - first)) % size(), length,
                        problem_.is_kept(halfedges_[first])});
      first = last;
    }
    return arcs;
  }

private:
  const Cut_problem& problem_;
  const Cut_graph& cut_;
  std::vector<Index> halfedges_;
};

/// The sides of the annulus that there is without an arc.
struct Sides_of_arc
{
  const Disk_boundary& boundary;
  const Cut_arc& arc;

  /// 1 or 2; 0 for places on the arc.
  int of(Index place) const {
    if(boundary.places_from(arc.last, place) <= boundary.places_from(arc.last, arc.twin_first))
      return 1;
    if(boundary.places_from(arc.twin_last, place) <= boundary.places_from(arc.twin_last, arc.first))
      return 2;
    return 0;
  }

  /// the side of all places from one to another that is not before it; 0 if they differ.
  int of(Index first, Index last) const {
    const int side = of(first);
    const Index begin = side == 1 ? arc.last : arc.twin_last;
    return side == of(last) &&
                   boundary.places_from(begin, first) <= boundary.places_from(begin, last)
               ? side
               : 0;
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_DISK_BOUNDARY_H
