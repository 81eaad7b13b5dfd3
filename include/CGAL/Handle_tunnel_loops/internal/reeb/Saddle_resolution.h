// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SADDLE_RESOLUTION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SADDLE_RESOLUTION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_arcs.h>

#include <CGAL/assertions.h>

#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Unfolds a saddle with k lower components into k - 1 simple ones. In step i the contour arc around
lower components 0 .. i - 1 and the contour arc around lower component i are cut and joined
crosswise. If they belong to different contours, these meet; if not, their contour parts.
*/
class Saddle_resolution
{
public:
  /// goes through the steps; each calls `meet(a, b)`, which gives the arc above of two arcs that
  /// meet, or `part(a)`, which gives the two arcs above of one that parts. Then the contour arcs
  /// name the arcs above the saddle.
  template <typename Meet, typename Part>
  void resolve(Contour_arcs& contour_arcs, const Meet& meet, const Part& part) {
    start(contour_arcs);
    for(Index i = 1; i < contour_arcs.size(); ++i) {
      const Index a = contour_of(incoming_[i - 1]), b = contour_of(incoming_[i]);
      std::swap(leaving_[i - 1], leaving_[i]);
      if(a != b) {
        next_[b] = a;
        arc_[a] = meet(arc_[a], arc_[b]);
      } else {
        const auto [arc, other] = part(arc_[a]);
        arc_[a] = arc;
        separate_shorter(contour_arcs, i - 1, i, other);
      }
    }
    for(Index i = 0; i < contour_arcs.size(); ++i)
      contour_arcs[i].arc = arc_[contour_of(i)];
  }

private:
  // Contour_arcs of one contour below have one number.
  void start(const Contour_arcs& contour_arcs) {
    const Index k = static_cast<Index>(contour_arcs.size());
    incoming_.resize(k);
    leaving_.resize(k);
    contour_.assign(k, no_index);
    next_.clear();
    arc_.clear();
    std::iota(leaving_.begin(), leaving_.end(), Index(0));
    CGAL_expensive_precondition(is_permutation(contour_arcs));
    for(Index i = 0; i < k; ++i) {
      incoming_[contour_arcs[i].arrival] = i;
      if(contour_[i] != no_index)
        continue;
      const Index contour = new_contour(contour_arcs[i].arc);
      for(Index j = i; contour_[j] == no_index; j = contour_arcs[j].arrival)
        contour_[j] = contour;
    }
  }

  // Whether one arc arrives at each lower component.
  static bool is_permutation(const Contour_arcs& contour_arcs) {
    std::vector<char> is_taken(contour_arcs.size(), 0);
    for(const Contour_arc& arc : contour_arcs) {
      if(arc.arrival >= is_taken.size() || is_taken[arc.arrival])
        return false;
      is_taken[arc.arrival] = 1;
    }
    return true;
  }

  Index new_contour(Index arc) {
    next_.push_back(static_cast<Index>(next_.size()));
    arc_.push_back(arc);
    return next_.back();
  }

  Index contour_of(Index contour_arc) {
    Index c = contour_[contour_arc];
    while(next_[c] != c)
      c = next_[c] = next_[next_[c]];
    return c;
  }

  // The contours that leave lower components i and j are gone along in turns, and the one that
  // closes first gets a new number.
  void separate_shorter(const Contour_arcs& contour_arcs, Index i, Index j, Index arc) {
    Index at[2] = {i, j};
    const Index first[2] = {i, j};
    passed_[0].clear();
    passed_[1].clear();
    for(int side = 0;; side = 1 - side) {
      const Index contour_arc = leaving_[at[side]];
      passed_[side].push_back(contour_arc);
      at[side] = contour_arcs[contour_arc].arrival;
      if(at[side] == first[side]) {
        const Index contour = new_contour(arc);
        for(Index s : passed_[side])
          contour_[s] = contour;
        return;
      }
    }
  }

  std::vector<Index> incoming_, leaving_; // by lower component, a contour arc
  std::vector<Index> contour_;            // by contour arc, a number
  std::vector<Index> next_;               // by number, another one that it became a part of
  std::vector<Index> arc_;                // by number
  std::vector<Index> passed_[2];
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SADDLE_RESOLUTION_H
