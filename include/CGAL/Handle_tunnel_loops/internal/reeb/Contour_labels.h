// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_LABELS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_LABELS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_arcs.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
The contours at the present level, as labels of the edges that they cross.

An edge is labelled when its lower end is passed, in the slot that it has there, and its label may
grow old: which arc the label has become a part of is looked up in a forest. Contours that meet cost
one entry of the forest. A contour that parts is walked from the saddle, both parts in turns, until
the shorter one has been walked around, and the edges of that one are labelled anew.
*/
class Contour_labels
{
public:
  Contour_labels(const Flat_mesh& mesh, const Sweep_order& order)
      : mesh_(mesh)
      , order_(order)
      , label_(mesh.neighbor.size()) {}

  /// the number of edges that were walked over.
  std::uint64_t number_of_steps() const { return number_of_steps_; }

  /// the arc of the contour that crosses the edge in a slot.
  Index arc_at(Index slot) { return find(label_[slot]); }

  /// says that a new contour begins around \p v, or that one of an arc passes over it.
  void pass(Index v, Index arc) {
    // The edges to lower neighbours have their label there; so no harm is done to them.
    std::fill(label_.begin() + mesh_.row_begin[v], label_.begin() + mesh_.row_begin[v + 1], arc);
  }

  /// makes room for arcs up to a number.
  void add_arcs(Index number_of_arcs) {
    const Index old = static_cast<Index>(next_.size());
    next_.resize(number_of_arcs);
    std::iota(next_.begin() + old, next_.end(), old);
  }

  /// finds the contour arcs at a saddle; \p front_of gives the front of an arc.
  template <typename FrontOfArc>
  void cut(const Swept_vertex& at, Contour_arcs& contour_arcs, const FrontOfArc& front_of) {
    const Index k = at.number_of_lower_components();
    contour_arcs.resize(k);
    walked_.resize((std::max)(walked_.size(), std::size_t(k)));
    by_arc_.resize(k);
    std::iota(by_arc_.begin(), by_arc_.end(), Index(0));
    for(Index i = 0; i < k; ++i) {
      contour_arcs[i] = {i, arc_at(at.slot_of_lower_component(i)), {}};
      walked_[i].clear();
    }
    std::sort(by_arc_.begin(), by_arc_.end(),
              [&](Index i, Index j) { return contour_arcs[i].arc < contour_arcs[j].arc; });
    groups_.clear();
    for(auto first = by_arc_.begin(); first != by_arc_.end();) {
      auto last = first;
      while(last != by_arc_.end() && contour_arcs[*last].arc == contour_arcs[*first].arc)
        ++last;
      cut_contour(at, {first, last}, contour_arcs, front_of(contour_arcs[*first].arc));
      first = last;
    }
  }

  /// labels the edges above a saddle; the contour arcs now name the arcs that they belong to.
  void join(const Swept_vertex& at, const Contour_arcs& contour_arcs) {
    for(const Group& group : groups_) {
      const Index arc = contour_arcs[group.longest].arc;
      next_[group.arc_below] = arc;
      for(auto i = group.begin; i != group.end; ++i)
        if(contour_arcs[*i].arc != arc)
          for(const Crossed_edge& edge : walked_[*i])
            label_[mesh_.row_begin[edge.lower] + edge.position] = contour_arcs[*i].arc;
    }
    for(Index i = 0; i < at.number_of_lower_components(); ++i) {
      const Index arc = contour_arcs[at.next_lower_component(i)].arc;
      at.for_each_above(i, [&](Index p) { label_[at.slot_above(p)] = arc; });
    }
  }

private:
  using Iterator = std::vector<Index>::iterator;

  // An edge by its lower end and the position of the other in the ring of that.
  struct Crossed_edge
  {
    Index lower, position;
  };

  // The contour arcs of one contour; all but the longest are walked.
  struct Group
  {
    Iterator begin, end; // in by_arc_
    Index longest = no_index;
    Index arc_below = no_index;
  };

  Index find(Index label) {
    CGAL_precondition(label < next_.size());
    while(next_[label] != label)
      label = next_[label] = next_[next_[label]];
    return label;
  }

  void
  cut_contour(const Swept_vertex& at, Group group, Contour_arcs& contour_arcs, Front_mean whole) {
    group.arc_below = contour_arcs[*group.begin].arc;
    group.longest = *group.begin;
    for(auto i = group.begin; i != group.end; ++i)
      whole -= at.front_below(*i);
    if(group.end - group.begin > 1)
      walk(at, group, contour_arcs);
    for(auto i = group.begin; i != group.end; ++i)
      if(*i != group.longest) {
        contour_arcs[*i].front = front_along(walked_[*i]);
        whole -= contour_arcs[*i].front;
      }
    contour_arcs[group.longest].front = whole;
    groups_.push_back(group);
  }

  Front_mean front_along(const std::vector<Crossed_edge>& edges) const {
    Front_mean front;
    for(const Crossed_edge& edge : edges)
      front += crossing_of_front(mesh_, edge.lower, mesh_.ring(edge.lower), edge.position);
    return front;
  }

  // In turns, until all but one have arrived; where the last one arrives is then clear.
  void walk(const Swept_vertex& at, Group& group, Contour_arcs& contour_arcs) {
    walks_.clear();
    const Index level = order_.rank(at.center());
    for(auto i = group.begin; i != group.end; ++i) {
      walks_.push_back(
          {Contour_walk(mesh_, order_, level, at.first_of(*i), at.before_first_of(*i)), *i});
      contour_arcs[*i].arrival = no_index;
    }
    while(walks_.size() > 1) {
      std::size_t kept = 0, size = walks_.size();
      for(std::size_t w = 0; w < size; ++w)
        if(kept + (size - w) == 1 || step(at, walks_[w], contour_arcs))
          walks_[kept++] = walks_[w];
      walks_.erase(walks_.begin() + kept, walks_.end());
    }
    group.longest = walks_.front().contour_arc;
    settle(group, contour_arcs);
  }

  struct Walk
  {
    Contour_walk contour;
    Index contour_arc;
  };

  bool step(const Swept_vertex& at, Walk& walk, Contour_arcs& contour_arcs) {
    ++number_of_steps_;
    walked_[walk.contour_arc].push_back({walk.contour.left(), walk.contour.position()});
    if(walk.contour.advance(at.center()))
      return true;
    contour_arcs[walk.contour_arc].arrival = at.lower_component_that_ends_at(walk.contour.left());
    return false;
  }

  // The longest contour arc arrives at the one lower component of its contour at which no other
  // does.
  void settle(const Group& group, Contour_arcs& contour_arcs) {
    taken_.resize((std::max)(taken_.size(), contour_arcs.size()));
    for(auto i = group.begin; i != group.end; ++i)
      taken_[*i] = 0;
    for(auto i = group.begin; i != group.end; ++i)
      if(*i != group.longest) {
        CGAL_assertion_msg(!taken_[contour_arcs[*i].arrival],
                           "each arc arrives at a place of its own");
        taken_[contour_arcs[*i].arrival] = 1;
      }
    for(auto i = group.begin; i != group.end; ++i)
      if(!taken_[*i])
        contour_arcs[group.longest].arrival = *i;
    CGAL_assertion(contour_arcs[group.longest].arrival != no_index);
  }

  const Flat_mesh& mesh_;
  const Sweep_order& order_;
  std::vector<Index> label_; // by slot
  std::vector<Index> next_;  // the forest: by label, another one that it became a part of
  std::uint64_t number_of_steps_ = 0;

  // Of the saddle at hand.
  std::vector<Index> by_arc_;
  std::vector<Group> groups_;
  std::vector<std::vector<Crossed_edge>> walked_; // by contour arc, what it was walked over
  std::vector<Walk> walks_;
  std::vector<char> taken_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_CONTOUR_LABELS_H
