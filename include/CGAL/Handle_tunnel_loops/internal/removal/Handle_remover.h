// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_REMOVER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_REMOVER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Removal_report.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Loop_certifier.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Handle_selection.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/remove_from.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Mesh_link.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/surface_count.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops_solver.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/iterator.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// `CGAL::remove_handles()`, step by step.
template <typename ConcurrencyTag, typename TriangleMesh, typename NamedParameters>
class Handle_remover
{
  using Vertex_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::type;
  using Const_point_map = typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type;
  using Geom_traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
  using Solver = Handle_tunnel_loops_solver<TriangleMesh, Const_point_map, Geom_traits>;
  using Pair = typename Solver::Pair;
  using Ask = std::function<bool(double)>;

public:
  Handle_remover(TriangleMesh& tm, const NamedParameters& np)
      : tm_(tm)
      , np_(np)
      , options_(get(internal_np::removal_options, Removal_options()))
      , ask_(get(internal_np::callback, Ask())) {}

  Removal_report operator()() {
    const auto vertex_index = CGAL::get_initialized_vertex_index_map(tm_, np_);
    const auto face_index = CGAL::get_initialized_face_index_map(tm_, np_);
    find_pairs(vertex_index, face_index);
    std::vector<Removal_task> tasks =
        Task_list<TriangleMesh, Pair, std::decay_t<decltype(vertex_index)>>(
            tm_, vertex_index, selection())(pairs_, report_.genus_before);
    Mesh_link<TriangleMesh, Vertex_point_map> link(
        tm_, parameters::choose_parameter(parameters::get_parameter(np_, internal_np::vertex_point),
                                          get_property_map(vertex_point, tm_)));
    Surgery_mesh mesh = link.read(execution, vertex_index, face_index);
    remove_from(execution, mesh, tasks, [this](double done) { ask(0.7 + 0.2 * done); });
    describe(tasks);
    if(options_.maximal_neck_length > 0.)
      describe_necks(remove_necks_from(execution, mesh, options_));
    check(mesh);
    ask(1.);
    if(!get(internal_np::dry_run, false)) {
      write_back(mesh, link);
      find_remaining_pairs();
    }
    return std::move(report_);
  }

private:
  static constexpr Execution execution = execution_of<ConcurrencyTag>();

  template <typename Tag, typename Default> auto get(Tag tag, const Default& value) const {
    return parameters::choose_parameter(parameters::get_parameter(np_, tag), value);
  }
  template <typename Tag>
  static constexpr bool is_given = !parameters::is_default_parameter<NamedParameters, Tag>::value;

  // Asks no more once it was told to stop.
  void ask(double done) {
    if(ask_ && !ask_(done)) {
      ask_ = nullptr;
      throw Interrupted_exception();
    }
  }

  // The solver checks the mesh, whoever finds the loops.
  template <typename VertexIndexMap, typename FaceIndexMap>
  void find_pairs(VertexIndexMap vertex_index, FaceIndexMap face_index) {
    Solver solver(ConcurrencyTag(), tm_, np_);
    report_.genus_before = solver.genus();
    report_.components_before = solver.number_of_components();
    if constexpr(is_given<internal_np::known_loops_t>) {
      const auto& known = parameters::get_parameter(np_, internal_np::known_loops);
      pairs_.assign(known.begin(), known.end());
      check_pairs(vertex_index, face_index);
    } else
      solver.template find_loops<ConcurrencyTag>(
          std::back_inserter(pairs_),
          parameters::callback(Ask([this](double done) { return !ask_ || ask_(0.7 * done); })));
  }

  template <typename VertexIndexMap, typename FaceIndexMap>
  void check_pairs(VertexIndexMap vertex_index, FaceIndexMap face_index) const {
    using Loop = typename Pair::Loop;
    std::vector<const Loop*> loops;
    for(const Pair& pair : pairs_)
      loops.insert(loops.end(), {&pair.handle(), &pair.tunnel()});
    Loop_certifier<TriangleMesh, VertexIndexMap, FaceIndexMap> certifier(tm_, vertex_index,
                                                                         face_index);
    certifier.set_loops(execution, loops);
    if(!certifier.are_closed_on_surface())
      throw std::invalid_argument("the loops are not of this mesh: " +
                                  certifier.failures().front());
  }

  // The size of a neck is a limit for handles, too, unless these have one of their own.
  Handle_selection<Pair> selection() const {
    if(!(options_.maximal_neck_length >= 0.))
      throw std::invalid_argument("the maximal length of a neck is negative");
    if(!(options_.minimal_piece_share >= 0. && options_.minimal_piece_share <= 0.5))
      throw std::invalid_argument("the share of a piece is not in [0, 0.5]");
    if(options_.maximal_length && !(*options_.maximal_length > 0.))
      throw std::invalid_argument("the maximal length is not positive");
    Handle_selection<Pair> wanted{options_, {}};
    if(!wanted.maximal_length && options_.maximal_neck_length > 0.)
      wanted.maximal_length = options_.maximal_neck_length;
    if constexpr(is_given<internal_np::filter_t>)
      wanted.filter = parameters::get_parameter(np_, internal_np::filter);
    return wanted;
  }

  // That what is promised is so.
  void check(const Surgery_mesh& mesh) {
    const Surface_count count = count_surface(execution, mesh);
    report_.genus_after = count.genus;
    report_.components_after = count.components;
    if(report_.genus_after + report_.removed.size() != report_.genus_before ||
       report_.components_after != report_.components_before + report_.removed_necks.size())
      throw std::logic_error("handles were removed, but the genus does not say so");
  }

  void describe(const std::vector<Removal_task>& tasks) {
    for(const Removal_task& task : tasks)
      if(task.state == Removal_task::State::REMOVED) {
        note_patch(task);
        report_.removed.push_back(removed(task));
      } else if(task.state == Removal_task::State::REFUSED)
        report_.refused.push_back(refused(task));
  }

  void describe_necks(const std::vector<Removal_task>& tasks) {
    for(const Removal_task& task : tasks)
      if(task.state == Removal_task::State::REMOVED) {
        note_patch(task);
        report_.removed_necks.push_back(removed(task));
      } else
        report_.refused_necks.push_back(refused(task));
  }

  static Removed_handle removed(const Removal_task& task) {
    return {task.pair, way(task), task.choices[task.choice].length, task.area, task.volume};
  }

  static Refused_handle refused(const Removal_task& task) {
    return {task.pair, task.choices.front().length, why_refused(task)};
  }

  static Removal_way way(const Removal_task& task) {
    if(task.is_whole)
      return Removal_way::WHOLE;
    return task.choices[task.choice].type == Loop_type::HANDLE ? Removal_way::CUT
                                                               : Removal_way::FILL;
  }

  static std::string why_refused(const Removal_task& task) {
    std::string why;
    for(std::size_t i = 0; i < task.choices.size(); ++i)
      if(task.choices[i].is_allowed)
        why += std::string(i == 0 ? "" : "; ") +
               (task.choices[i].type == Loop_type::HANDLE ? "cut: " : "fill: ") + task.reasons[i];
    return why;
  }

  // Of the next one that is described.
  void note_patch(const Removal_task& task) {
    patches_.push_back({task.end_of_faces, report_.removed.size() + report_.removed_necks.size()});
  }

  // Patches follow each other without gaps.
  std::size_t patch_of(Index face) const {
    return std::upper_bound(patches_.begin(), patches_.end(),
                            std::make_pair(face, (std::numeric_limits<std::size_t>::max)()))
        ->second;
  }

  void write_back(const Surgery_mesh& mesh, Mesh_link<TriangleMesh, Vertex_point_map>& link) {
    auto vertices = get(internal_np::vertex_output_iterator, Emptyset_iterator());
    auto faces = get(internal_np::face_output_iterator, Emptyset_iterator());
    std::sort(patches_.begin(), patches_.end());
    link.write_back(
        mesh, [&](Index, auto v) { *vertices++ = v; },
        [&](Index number, auto f) {
          *faces++ = f;
          if constexpr(is_given<internal_np::face_patch_t>)
            put(parameters::get_parameter(np_, internal_np::face_patch), f, patch_of(number));
        });
  }

  // With no index maps of the caller, which know the mesh as it was.
  void find_remaining_pairs() {
    if constexpr(is_given<internal_np::output_iterator_t>) {
      auto pairs = parameters::get_parameter(np_, internal_np::output_iterator);
      const auto traits = parameters::choose_parameter<Geom_traits>(
          parameters::get_parameter(np_, internal_np::geom_traits));
      const auto point =
          parameters::choose_parameter(parameters::get_parameter(np_, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, tm_));
      Solver solver(ConcurrencyTag(), tm_, parameters::vertex_point_map(point).geom_traits(traits));
      solver.template find_loops<ConcurrencyTag>(pairs);
    }
  }

  TriangleMesh& tm_;
  const NamedParameters& np_;
  const Removal_options options_;
  Ask ask_;
  std::vector<Pair> pairs_;
  Removal_report report_;
  std::vector<std::pair<Index, std::size_t>> patches_; // ends of their faces, and numbers
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_HANDLE_REMOVER_H
