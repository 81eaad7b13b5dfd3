// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_BOUNDARY_TOUR_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_BOUNDARY_TOUR_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <boost/dynamic_bitset.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Counts the halfedges of the boundary of the disk to which a component opens, again and again while
its cut changes. Where the boundary is as it was when it was written down, it is passed over in one
step: as it is written down anew after some changes, a count takes time in the order of the square
root of its length.
*/
class Boundary_tour
{
public:
  Boundary_tour(const Cut_problem& problem, const Cut_graph& cut)
      : halfedges_(problem.halfedges)
      , cut_(cut)
      , place_(problem.halfedges.size(), no_index) {}

  /// writes the boundary down.
  void set(const std::vector<Index>& boundary) {
    for(const Index h : boundary_)
      place_[h] = no_index;
    boundary_ = boundary;
    for(std::size_t k = 0; k < boundary_.size(); ++k)
      place_[boundary_[k]] = static_cast<Index>(k);
    is_changed_.clear();
    is_changed_.resize(boundary_.size());
    number_changed_ = 0;
    latest_.clear();
  }

  /// to be told of each edge that is inserted or erased, after that.
  void note_change(Index h) {
    for(const Index k : {h, halfedges_.twin(h)}) {
      mark(k);
      mark(preceding(k));
    }
  }

  /// what is changed from here on may be taken back.
  void begin_change() { latest_.clear(); }

  /// to be told when the edges are as they were at `begin_change()`.
  void take_change_back() {
    for(const Index k : latest_)
      is_changed_.reset(k);
    number_changed_ -= latest_.size();
    latest_.clear();
  }

  /// whether the boundary is one cycle of so many halfedges, one of which is h.
  bool is_cycle(Index h, std::size_t number) {
    const Index begin = cut_.following(last_of_stretch(h));
    std::size_t count = 0;
    Index k = begin;
    do {
      const Index last = last_of_stretch(k);
      count += last == k ? 1 : place_[last] - place_[k] + 1;
      k = cut_.following(last);
    } while(k != begin && count <= number);
    if(count == number && is_outdated())
      set(cut_.boundary_from(begin));
    return count == number;
  }

private:
  // About where a count takes as long as writing the boundary down, shared by the counts up to
  // then.
  bool is_outdated() const { return number_changed_ * number_changed_ > 256 * boundary_.size(); }

  void mark(Index h) {
    const Index k = place_[h];
    if(k == no_index || is_changed_.test_set(k))
      return;
    ++number_changed_;
    latest_.push_back(k);
  }

  // What the halfedge follows, or would if it were in the cut.
  Index preceding(Index h) const {
    Index k = h;
    do
      k = halfedges_.after(k);
    while(k != h && !cut_.contains(k));
    return halfedges_.twin(k);
  }

  // The boundary goes on as it did up to there.
  Index last_of_stretch(Index h) const {
    const std::size_t k = place_[h];
    if(k == no_index || is_changed_[k])
      return h;
    const std::size_t next = is_changed_.find_next(k);
    return next < boundary_.size() ? boundary_[next] : boundary_.back();
  }

  const Flat_halfedges& halfedges_;
  const Cut_graph& cut_;
  std::vector<Index> boundary_; // as it was written down
  std::vector<Index> place_;    // by halfedge, in what was written down
  // By place, whether something else may follow.
  boost::dynamic_bitset<> is_changed_;
  std::size_t number_changed_ = 0;
  std::vector<Index> latest_; // places that were not changed before the last change began
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_BOUNDARY_TOUR_H
