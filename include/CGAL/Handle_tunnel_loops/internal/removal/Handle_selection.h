// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_SELECTION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_SELECTION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/Removal_report.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_task.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Which handles are to be removed: those that fulfil all conditions, and of these, smallest first,
/// as many as the target genus asks for. The size of a handle is the length of the loop that it
/// would be removed along.
template <typename Pair> struct Handle_selection : Removal_options
{
  std::function<bool(const Pair&)> filter;
};

/// Turns pairs of loops into tasks: first the handles that are to be removed, smallest first, then
/// those that are kept. Throws `std::invalid_argument` if the selection makes no sense.
template <typename TriangleMesh, typename Pair, typename VertexIndexMap> class Task_list
{
public:
  Task_list(const TriangleMesh& tm,
            VertexIndexMap vertex_index,
            const Handle_selection<Pair>& wanted)
      : tm_(tm)
      , vertex_index_(vertex_index)
      , wanted_(wanted) {}

  std::vector<Removal_task> operator()(const std::vector<Pair>& pairs, std::size_t genus) const {
    if(wanted_.target_genus && *wanted_.target_genus > genus)
      throw std::invalid_argument("the target genus is " + std::to_string(*wanted_.target_genus) +
                                  ", but the surface has genus " + std::to_string(genus));
    std::vector<Removal_task> selected, kept;
    for(std::size_t i = 0; i < pairs.size(); ++i) {
      const bool is_selected = is_wanted(pairs[i]);
      (is_selected ? selected : kept).push_back(task(pairs[i], i));
    }
    if(wanted_.box && selected.empty())
      throw std::invalid_argument("no loop that a handle could be removed along lies in the box");
    std::stable_sort(selected.begin(), selected.end(),
                     [](const Removal_task& a, const Removal_task& b) {
                       return a.choices.front().length < b.choices.front().length;
                     });
    const std::size_t number = wanted_.target_genus
                                   ? (std::min)(selected.size(), genus - *wanted_.target_genus)
                                   : selected.size();
    selected.insert(selected.end(), kept.begin(), kept.end());
    for(std::size_t i = number; i < selected.size(); ++i)
      selected[i].state = Removal_task::State::KEPT;
    return selected;
  }

private:
  using Loop = typename Pair::Loop;

  // The one that is tried first.
  Loop_type first_type(const Pair& pair) const {
    if(wanted_.method == Removal_method::CUT)
      return Loop_type::HANDLE;
    if(wanted_.method == Removal_method::FILL)
      return Loop_type::TUNNEL;
    return pair.tunnel().length() < pair.handle().length() ? Loop_type::TUNNEL : Loop_type::HANDLE;
  }

  bool is_wanted(const Pair& pair) const {
    const Loop& loop = pair.loop(first_type(pair));
    return (!wanted_.maximal_length || loop.length() < *wanted_.maximal_length) &&
           (!wanted_.box || lies_in_box(loop)) && (!wanted_.filter || wanted_.filter(pair));
  }

  bool lies_in_box(const Loop& loop) const {
    return std::all_of(loop.points().begin(), loop.points().end(), [&](const auto& p) {
      const Bbox_3 b = p.bbox();
      return wanted_.box->xmin() <= b.xmin() && b.xmax() <= wanted_.box->xmax() &&
             wanted_.box->ymin() <= b.ymin() && b.ymax() <= wanted_.box->ymax() &&
             wanted_.box->zmin() <= b.zmin() && b.zmax() <= wanted_.box->zmax();
    });
  }

  Removal_task task(const Pair& pair, std::size_t number) const {
    Removal_task task;
    task.pair = number;
    const Loop& first = pair.loop(first_type(pair));
    task.choices.push_back(choice(first));
    task.choices.push_back(choice(pair.partner(first)));
    task.choices.back().is_allowed = wanted_.method == Removal_method::CHEAPEST;
    return task;
  }

  Loop_choice choice(const Loop& loop) const {
    Loop_choice choice{loop.type(), loop.length(), {}};
    for(const typename Loop::Step& step : loop.steps())
      choice.places.push_back({static_cast<Index>(get(vertex_index_, source(step.halfedge, tm_))),
                               static_cast<Index>(get(vertex_index_, target(step.halfedge, tm_))),
                               step.ratio});
    return choice;
  }

  const TriangleMesh& tm_;
  VertexIndexMap vertex_index_;
  const Handle_selection<Pair>& wanted_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_SELECTION_H
