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

#include <CGAL/assertions.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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
  /// begins anywhere on the cut of a component.
  Disk_boundary(const Cut_problem& problem, const Cut_graph& cut, Index some_halfedge)
      : problem_(problem)
      , cut_(cut) {
    Index h = some_halfedge;
    do {
      halfedges_.push_back(h);
      h = cut.following(h);
    } while(h != some_halfedge);
    begin_at_node();
  }

  Index size() const { return static_cast<Index>(halfedges_.size()); }
  Index operator[](Index place) const { return halfedges_[place]; }
  Index vertex(Index place) const { return problem_.halfedges.source(halfedges_[place]); }

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
  void begin_at_node() {
    Index node = 0;
    while(node < size() && !is_node(node))
      ++node;
    CGAL_assertion_msg(node < size(), "the cut of a closed surface has a node");
    std::rotate(halfedges_.begin(), halfedges_.begin() + node, halfedges_.end());
  }

  const Cut_problem& problem_;
  const Cut_graph& cut_;
  std::vector<Index> halfedges_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_DISK_BOUNDARY_H
