// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PARTNER_SEARCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PARTNER_SEARCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Class_search.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Finds short loops that cross a given one: `Class_search` from places along it, as close to each
other as it takes.

A loop through a place that is d away is longer by at most 2 d than one through this place. So
places at a part of the length of what is looked for find a loop that is longer by that part at
most, before it is tightened; and places near one through which there is no short loop can be left
out.
*/
class Partner_search
{
public:
  Partner_search(const Flat_mesh& mesh, const Search_mesh& search_mesh, const Edge_classes& classes)
      : mesh_(mesh)
      , search_mesh_(search_mesh)
      , distances_(search_mesh, classes)
      , search_(search_mesh, classes) {}

  /// looks for the targets along loop \p number, that all of them have to cross; see `Class_search`
  /// for the walls. The places are \p spacing times what is looked for apart.
  void run(const Crossing_loop& partner,
           Index number,
           bool are_walls_along,
           double spacing,
           Search_targets& targets,
           std::size_t& visits) {
    measure(partner);
    distances_.compute(partner, number, targets.limit(), visits);
    if(distances_.around() >= targets.limit())
      return;
    search_.start(are_walls_along, &distances_);
    for(const auto& [bound, root] : places(partner, spacing * targets.smallest_limit()))
      if(visits > 0 && bound < worth_a_way * targets.limit() &&
         search_.lower_bound(root) < worth_a_search * targets.limit())
      {
        targets.start_place();
        search_.search(root, targets, visits);
      }
  }

private:
  // However short the loops are that are looked for: lengths may be zero.
  static constexpr double most_places = 1000.;

  // Of the length that is looked for, unless no loop through a place can be so short.
  static constexpr double worth_a_search = 0.8, worth_a_way = 0.95;

  void measure(const Crossing_loop& loop) {
    along_.assign(1, 0.);
    for(std::size_t i = 0; i < loop.size(); ++i)
      along_.push_back(
          along_.back() +
          norm(position(mesh_, loop[i + 1 == loop.size() ? 0 : i + 1]) - position(mesh_, loop[i])));
  }

  // Where to search from, so far apart, and what no walk through there can be shorter than: those
  // first through which there may be short ones.
  std::vector<std::pair<double, Index>> places(const Crossing_loop& partner, double spacing) const {
    std::vector<std::pair<double, Index>> all;
    spacing = (std::max)(spacing, along_.back() / most_places);
    double s = 0.;
    do {
      const Index root = place(partner, s);
      all.emplace_back(distances_.way_on(root, distances_.first_copy(root)), root);
      s += spacing;
    } while(s < along_.back());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  // A vertex to search from, near the place of the loop at a distance along it.
  Index place(const Crossing_loop& loop, double s) const {
    const std::size_t i = static_cast<std::size_t>(
        std::upper_bound(along_.begin(), along_.end() - 1, s) - along_.begin() - 1);
    const Crossing &c = loop[i], &next = loop[i + 1 == loop.size() ? 0 : i + 1];
    const double part = along_[i + 1] - along_[i];
    const Vector from = position(mesh_, c);
    const Vector p =
        part > 0. ? from + ((s - along_[i]) / part) * (position(mesh_, next) - from) : from;
    return search_mesh_.vertex_near(p, ratio_on_surface(mesh_, c) < 0.5 ? c.left : c.right);
  }

  const Flat_mesh& mesh_;
  const Search_mesh& search_mesh_;
  Partner_distances distances_;
  Class_search search_;
  std::vector<double> along_; // the loop, by crossing
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PARTNER_SEARCH_H
