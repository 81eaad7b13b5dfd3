// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_SHORTENING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_SHORTENING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/cutting/Arc_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Boundary_tour.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Disk_boundary.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Makes a cut shorter: arcs give way to shorter paths, whose ends may be anywhere on the cut, as long
as each component still opens to one disk. That is decided by counting alone: the boundary is one
cycle, and the numbers of vertices and edges of the cut differ by as much as before.
*/
class Cut_shortening
{
public:
  Cut_shortening(const Cut_problem& problem, Cut_graph& cut)
      : problem_(problem)
      , halfedges_(problem.halfedges)
      , cut_(cut)
      , exchange_(problem, cut)
      , tour_(problem, cut) {}

  /// until hardly any arc can be replaced by a shorter one.
  void run() {
    std::vector<char> is_done(problem_.mesh.seeds.size(), 0);
    for(Index h = 0; h < halfedges_.size(); ++h) {
      char& done = is_done[problem_.mesh.component[halfedges_.source(h)]];
      if(cut_.contains(h) && !done) {
        done = 1;
        shorten_component(h);
      }
    }
  }

private:
  struct Change
  {
    Index halfedge;
    bool is_inserted;
  };

  static constexpr int most_rounds = 40;
  // The last rounds gain next to nothing, and each looks for chords on the whole surface.
  static constexpr double least_gain = 5e-4; // of the length of the cut, in a round

  void shorten_component(Index some_halfedge) {
    some_halfedge_ = some_halfedge;
    exchange_.clear();
    for(int round = 0; round < most_rounds; ++round) {
      const Disk_boundary boundary(problem_, cut_, some_halfedge_);
      edges_ = boundary.size() / 2;
      tour_.set(boundary.halfedges());
      double gained = 0.;
      for(const Arc_proposal& proposal : exchange_.find(boundary))
        if(accept(boundary, proposal))
          gained += gain();
      if(!(gained > least_gain * boundary.length() / 2.))
        return;
    }
  }

  void erase(Index h) {
    cut_.erase(h);
    note_erased(h);
  }
  void note_erased(Index h) {
    --edges_;
    excess_ -= excess_of(h);
    changes_.push_back({h, false});
    tour_.note_change(h);
  }
  void insert(Index h) {
    ++edges_;
    excess_ += excess_of(h);
    cut_.insert(h);
    changes_.push_back({h, true});
    tour_.note_change(h);
  }

  // Of an edge that is not in the cut: one, less the vertices that come with it.
  int excess_of(Index h) const {
    return 1 - (cut_.degree(halfedges_.source(h)) == 0) - (cut_.degree(halfedges_.target(h)) == 0);
  }

  // Other arcs may have changed since the proposal was made.
  bool accept(const Disk_boundary& boundary, const Arc_proposal& proposal) {
    changes_.clear();
    excess_ = 0;
    tour_.begin_change();
    const Cut_arc& arc = exchange_.arcs()[proposal.arc];
    for(Index k = arc.first; k != arc.last; k = boundary.next(k))
      if(cut_.contains(boundary[k]))
        erase(boundary[k]);
    for(const Index h : proposal.path)
      if(!cut_.contains(h))
        insert(h);
    for(const Index v : {boundary.vertex(arc.first), boundary.vertex(arc.last)})
      prune(v);
    for(const Index h : proposal.path)
      for(const Index v : {halfedges_.source(h), halfedges_.target(h)})
        prune(v);
    if(passes_cones() && gain() > 1e-12 * arc.length && opens_to_disk(proposal.path.front()))
      return true;
    undo();
    return false;
  }

  void prune(Index v) {
    cut_.prune(v, [&](Index h) { note_erased(h); });
  }

  bool passes_cones() const {
    for(const Change& change : changes_)
      for(const Index v : {halfedges_.source(change.halfedge), halfedges_.target(change.halfedge)})
        if(problem_.is_cone(v) && cut_.degree(v) == 0)
          return false;
    return true;
  }

  double gain() const {
    double sum = 0.;
    for(const Change& change : changes_)
      sum +=
          change.is_inserted ? -problem_.weight[change.halfedge] : problem_.weight[change.halfedge];
    return sum;
  }

  bool opens_to_disk(Index some_halfedge) {
    if(excess_ != 0 || !cut_.contains(some_halfedge))
      return false;
    const bool is_disk = tour_.is_cycle(some_halfedge, 2 * edges_);
    if(is_disk) // else it is taken out again
      some_halfedge_ = some_halfedge;
    return is_disk;
  }

  void undo() {
    const std::vector<Change> changes = changes_;
    for(auto change = changes.rbegin(); change != changes.rend(); ++change)
      if(change->is_inserted)
        erase(change->halfedge);
      else
        insert(change->halfedge);
    tour_.take_change_back();
  }

  const Cut_problem& problem_;
  const Flat_halfedges& halfedges_;
  Cut_graph& cut_;
  Arc_exchange exchange_;
  Boundary_tour tour_;
  Index some_halfedge_ = no_index; // of the cut of the component
  std::size_t edges_ = 0;          // of the cut of the component
  std::vector<Change> changes_;    // the last ones
  int excess_ = 0;                 // of the edges that they add over the vertices
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_SHORTENING_H
