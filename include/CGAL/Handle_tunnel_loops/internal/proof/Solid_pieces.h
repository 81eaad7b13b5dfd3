// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SOLID_PIECES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SOLID_PIECES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Component_orientation.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/append_lines.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Exact_meeting.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sorted_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the components that hold a point, which lies on none of them but \p own, in order.
inline std::vector<Index> components_that_hold(const Vector& point,
                                               const Flat_mesh& mesh,
                                               const Face_tree& tree,
                                               Index own = no_index) {
  std::vector<Index> above;
  tree.for_each_above(point, point, [&](Index face) {
    if(const Index c = mesh.component[tree.corners(face)[0]]; c != own)
      above.push_back(c);
  });
  std::sort(above.begin(), above.end());
  std::vector<Index> holders; // those that are above an odd number of times
  for(Index c : above)
    if(!holders.empty() && holders.back() == c)
      holders.pop_back();
    else
      holders.push_back(c);
  return holders;
}

/*!
The pieces of the solid that a surface encloses. A piece lies between its outer component and the
cavities in it, which are the components next within that look the other way. What lies in a cavity
is another piece.

A component that meets another one, or that looks the same way as the next one around it, bounds a
piece of its own: it is taken alone. All of this is decided exactly.
*/
class Solid_pieces
{
public:
  /// \p places are those of the vertices, hubs included. All must outlive it.
  Solid_pieces(Execution execution, const Flat_mesh& mesh, const std::vector<Vector>& places)
      : mesh_(mesh)
      , places_(places)
      , outer_(mesh.seeds.size())
      , boxes_(mesh.seeds.size(), Box<3>::empty()) {
    std::iota(outer_.begin(), outer_.end(), Index(0));
    for(Index v = 0; v < places.size(); ++v)
      boxes_[mesh.component[v]].extend({places[v], places[v]});
    const Sorted_boxes<3> sorted(execution, boxes_);
    std::vector<char> is_near(outer_.size());
    for(Index c = 0; c < outer_.size(); ++c)
      is_near[c] = is_near_others(boxes_[c], c, sorted);
    if(std::find(is_near.begin(), is_near.end(), 1) == is_near.end())
      return;
    const Face_tree tree(execution, mesh, span_of(places));
    take_alone_what_meets(execution, tree, sorted, is_near);
    join(execution, tree, is_near);
  }

  /// by component, the outer component of the piece that it bounds.
  const std::vector<Index>& outer() const { return outer_; }

  /// which components are taken alone, and why, in lines of text.
  const std::string& taken_alone() const { return taken_alone_; }

private:
  using Pair = std::pair<Index, Index>;

  static bool is_near_others(const Box<3>& box, Index c, const Sorted_boxes<3>& sorted) {
    return sorted.any_meeting(box, [&](Index other, const Box<3>&) { return other != c; });
  }

  // Where two triangles meet, an edge of one meets the other.
  std::vector<Pair> pairs_that_meet(Execution execution,
                                    const Face_tree& tree,
                                    const Sorted_boxes<3>& sorted,
                                    const std::vector<char>& is_near) const {
    std::vector<Pair> pairs = collect<Pair>(
        execution, mesh_.number_of_vertices(), [&](std::size_t begin, std::size_t end) {
          std::vector<Pair> found;
          for(Index v = static_cast<Index>(begin); v < end; ++v)
            if(const Index c = mesh_.component[v]; is_near[c] != 0)
              for(Index u : mesh_.ring(v))
                if(v < u && is_near_others(box_around(places_[u], places_[v]), c, sorted))
                  find_met({u, v}, tree, found);
          return found;
        });
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  void find_met(const Pair& edge, const Face_tree& tree, std::vector<Pair>& found) const {
    const Vector &a = places_[edge.first], &b = places_[edge.second];
    const Exact_segment segment = {exact_point(a), exact_point(b)};
    const Index c = mesh_.component[edge.first];
    tree.any_near(a, b, [&](Index face) {
      const Index other = mesh_.component[tree.corners(face)[0]];
      const Pair pair = std::minmax(c, other);
      if(other != c && (found.empty() || found.back() != pair)) {
        const Triangle t = tree.triangle(face);
        if(do_meet(segment,
                   Exact_triangle{exact_point(t[0]), exact_point(t[1]), exact_point(t[2])}))
          found.push_back(pair);
      }
      return false;
    });
  }

  void take_alone_what_meets(Execution execution,
                             const Face_tree& tree,
                             const Sorted_boxes<3>& sorted,
                             const std::vector<char>& is_near) {
    does_meet_.assign(outer_.size(), 0);
    met_ = pairs_that_meet(execution, tree, sorted, is_near);
    std::vector<std::string> lines;
    for(const auto& [c, d] : met_) {
      does_meet_[c] = does_meet_[d] = 1;
      lines.push_back("components " + std::to_string(c) + " and " + std::to_string(d) +
                      " cross or touch each other: each is taken alone");
    }
    append_lines(taken_alone_, lines, "of that kind");
  }

  // The components that a component lies in: none of those that it meets.
  std::vector<Index> holders_of(Index c, const Face_tree& tree) const {
    std::vector<Index> holders = components_that_hold(places_[mesh_.seeds[c]], mesh_, tree, c);
    const auto is_met = [&](Index d) {
      return std::binary_search(met_.begin(), met_.end(), Pair(std::minmax(c, d)));
    };
    holders.erase(std::remove_if(holders.begin(), holders.end(), is_met), holders.end());
    return holders;
  }

  // From the outside in.
  void join(Execution execution, const Face_tree& tree, const std::vector<char>& is_near) {
    std::vector<std::vector<Index>> holders(outer_.size());
    for_each_index(
        execution, outer_.size(),
        [&](std::size_t c) {
          if(is_near[c] != 0)
            holders[c] = holders_of(static_cast<Index>(c), tree);
        },
        1);
    std::vector<Index> order(outer_.size());
    std::iota(order.begin(), order.end(), Index(0));
    const auto is_held_by_fewer = [&](Index c, Index d) {
      return holders[c].size() < holders[d].size();
    };
    std::stable_sort(order.begin(), order.end(), is_held_by_fewer);
    if(holders[order.back()].empty())
      return;
    const std::vector<int> sides = sides_of(tree);
    std::vector<std::string> lines;
    for(Index c : order)
      if(!holders[c].empty() && does_meet_[c] == 0) {
        const Index around =
            *std::max_element(holders[c].begin(), holders[c].end(), is_held_by_fewer);
        const char* const why = does_meet_[around] != 0      ? ", which meets another one"
                                : sides[c] != -sides[around] ? " with the same orientation"
                                                             : nullptr;
        if(why != nullptr)
          lines.push_back("component " + std::to_string(c) + " lies in component " +
                          std::to_string(around) + why + ": it is taken alone");
        else if(outer_[around] == around)
          outer_[c] = around;
      }
    append_lines(taken_alone_, lines, "of that kind");
  }

  std::vector<int> sides_of(const Face_tree& tree) const {
    return signs_of_volumes(outer_.size(), [&](const auto& add) {
      for(Index f = 0; f < tree.size(); ++f)
        add(mesh_.component[tree.corners(f)[0]], tree.triangle(f));
    });
  }

  const Flat_mesh& mesh_;
  const std::vector<Vector>& places_;
  std::vector<Index> outer_;    // by component
  std::vector<Box<3>> boxes_;   // by component
  std::vector<Pair> met_;       // components that meet, sorted
  std::vector<char> does_meet_; // by component, another one
  std::string taken_alone_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_SOLID_PIECES_H
