// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SINGLE_REMOVALS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SINGLE_REMOVALS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Removal_costs.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Mesh_link.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_rounds.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// `CGAL::removal_costs()`, step by step: two tasks for each pair, first that of the cut.
template <typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters>
class Single_removals
{
  using Point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;

public:
  Single_removals(const TriangleMesh& tm, const NamedParameters& np)
      : tm_(tm)
      , np_(np) {}

  template <typename PairRange> std::vector<Removal_costs> costs(const PairRange& pairs) const {
    const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm_, np_);
    std::vector<Removal_task> tasks;
    for(const auto& pair : pairs)
      for(const auto* loop : {&pair.handle(), &pair.tunnel()}) {
        Removal_task task = removal_task(tasks.size() / 2, pair, *loop, tm_, vertex_index);
        task.choices.back().is_allowed = false;
        tasks.push_back(std::move(task));
      }
    if(!tasks.empty())
      try_all(vertex_index, tasks);
    std::vector<Removal_costs> costs(tasks.size() / 2);
    for(std::size_t i = 0; i < tasks.size(); i += 2) {
      Removal_costs& both = costs[i / 2];
      describe(tasks[i], both.cut, both.why_no_cut);
      describe(tasks[i + 1], both.fill, both.why_no_fill);
    }
    return costs;
  }

private:
  template <typename Tag, typename Default> auto get(Tag tag, const Default& value) const {
    return parameters::choose_parameter(parameters::get_parameter(np_, tag), value);
  }

  template <typename VertexIndexMap>
  void try_all(VertexIndexMap vertex_index, std::vector<Removal_task>& tasks) const {
    constexpr Execution execution = execution_of<ConcurrencyTag>();
    Mesh_link<const TriangleMesh, Point_map> link(
        tm_, get(internal_np::vertex_point, get_const_property_map(vertex_point, tm_)));
    Surgery_mesh mesh =
        link.read(execution, vertex_index, CGAL::get_initialized_face_index_map(tm_, np_));
    for(Removal_task& task : tasks)
      task.divide_lengths(link.unit());
    const auto callback = get(internal_np::callback, std::function<bool(double)>());
    try_to_remove_each(execution, mesh, tasks,
                       get(internal_np::removal_options, Removal_options()).force,
                       [&](double done) {
                         if(callback && !callback(done))
                           throw Interrupted_exception();
                       });
    for(Removal_task& task : tasks)
      task.divide_lengths(1. / link.unit());
  }

  static void
  describe(const Removal_task& task, std::optional<Removed_handle>& way, std::string& why_not) {
    if(task.state == Removal_task::State::REMOVED)
      way = task.removed();
    else
      why_not = task.reasons.front();
  }

  const TriangleMesh& tm_;
  const NamedParameters& np_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SINGLE_REMOVALS_H
