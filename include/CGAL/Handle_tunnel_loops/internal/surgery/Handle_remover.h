// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_HANDLE_REMOVER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_HANDLE_REMOVER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/Removal_report.h>
#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Loop_certifier.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Mesh_link.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Parted_walls.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_rounds.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/bores_around.h>
#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops_solver.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/iterator.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Which handles are to be removed: those that fulfil all conditions, and of these, smallest first,
/// as many as the target genus asks for. The size of a handle is the length of the loop that it
/// would be removed along.
template <typename Pair> struct Handle_selection : Removal_options
{
  std::function<bool(const Pair&)> filter;
  std::vector<char> is_bore_wanted; ///< by pair, if only bores are

  /// turns pairs of loops into tasks: first the handles that are to be removed, smallest first,
  /// then those that are kept. Throws `std::invalid_argument` if the selection makes no sense.
  template <typename TriangleMesh, typename VertexIndexMap>
  std::vector<Removal_task> tasks(const TriangleMesh& tm,
                                  VertexIndexMap vertex_index,
                                  const std::vector<Pair>& pairs,
                                  std::size_t genus) const {
    if(target_genus && *target_genus > genus)
      throw std::invalid_argument("the target genus is " + std::to_string(*target_genus) +
                                  ", but the surface has genus " + std::to_string(genus));
    if(!methods.empty() && methods.rbegin()->first >= pairs.size())
      throw std::invalid_argument("pair " + std::to_string(methods.rbegin()->first) +
                                  " does not exist");
    std::vector<Removal_task> selected, kept;
    for(std::size_t i = 0; i < pairs.size(); ++i) {
      const Loop& first = pairs[i].loop(first_type(i, pairs[i]));
      Removal_task task = removal_task(i, pairs[i], first, tm, vertex_index);
      task.choices.back().is_allowed = method_of(i) == Removal_method::SMALLEST_CHANGE;
      (is_wanted(i, pairs[i], first) ? selected : kept).push_back(std::move(task));
    }
    if(box && selected.empty())
      throw std::invalid_argument("the box contains no loop along which a handle can be removed");
    std::stable_sort(selected.begin(), selected.end(),
                     [](const Removal_task& a, const Removal_task& b) {
                       return a.choices.front().length < b.choices.front().length;
                     });
    const std::size_t number =
        target_genus ? (std::min)(selected.size(), genus - *target_genus) : selected.size();
    selected.insert(selected.end(), kept.begin(), kept.end());
    for(std::size_t i = number; i < selected.size(); ++i)
      selected[i].state = Removal_task::State::KEPT;
    return selected;
  }

private:
  using Loop = typename Pair::Loop;

  Removal_method method_of(std::size_t i) const {
    const auto own = methods.find(i);
    return own == methods.end() ? method : own->second;
  }

  // The one whose length is the size of the handle.
  Loop_type first_type(std::size_t i, const Pair& pair) const {
    if(method_of(i) == Removal_method::CUT)
      return Loop_type::HANDLE;
    if(method_of(i) == Removal_method::FILL)
      return Loop_type::TUNNEL;
    return pair.tunnel().length() < pair.handle().length() ? Loop_type::TUNNEL : Loop_type::HANDLE;
  }

  bool is_wanted(std::size_t i, const Pair& pair, const Loop& first) const {
    return (is_bore_wanted.empty() || is_bore_wanted[i]) &&
           (!maximal_length || first.length() < *maximal_length) && (!box || lies_in_box(first)) &&
           (!filter || filter(pair));
  }

  bool lies_in_box(const Loop& loop) const {
    return std::all_of(loop.points().begin(), loop.points().end(), [&](const auto& p) {
      const Bbox_3 b = p.bbox();
      return box->xmin() <= b.xmin() && b.xmax() <= box->xmax() && box->ymin() <= b.ymin() &&
             b.ymax() <= box->ymax() && box->zmin() <= b.zmin() && b.zmax() <= box->zmax();
    });
  }
};

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
    Handle_selection<Pair> wanted = selection();
    if(selects_bores())
      wanted.is_bore_wanted = find_bores(vertex_index, face_index);
    std::vector<Removal_task> tasks = wanted.tasks(tm_, vertex_index, pairs_, report_.genus_before);
    Attempt attempt = attempt_at_all(tasks, vertex_index, face_index);
    while(options_.only_channels && keep_others(tasks, attempt))
      attempt = attempt_at_all(tasks, vertex_index, face_index);
    const double unit = attempt.link->unit();
    describe(std::move(attempt.tasks), unit, report_.removed, report_.refused);
    describe(std::move(attempt.necks), unit, report_.removed_necks, report_.refused_necks);
    check(attempt.mesh);
    ask(1.);
    if(!get(internal_np::dry_run, false)) {
      write_back(attempt.mesh, *attempt.link);
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

  using Link = Mesh_link<TriangleMesh, Vertex_point_map>;

  std::unique_ptr<Link> new_link() const {
    return std::make_unique<Link>(
        tm_, parameters::choose_parameter(parameters::get_parameter(np_, internal_np::vertex_point),
                                          get_property_map(vertex_point, tm_)));
  }

  bool selects_bores() const {
    return options_.minimal_bore_diameter || options_.maximal_bore_diameter;
  }

  // By pair, whether it is that of a bore of a diameter that is asked for.
  template <typename VertexIndexMap, typename FaceIndexMap>
  std::vector<char> find_bores(VertexIndexMap vertex_index, FaceIndexMap face_index) const {
    const auto link = new_link();
    const Surgery_mesh mesh = link->read(execution, vertex_index, face_index);
    std::vector<std::vector<Place_on_edge>> tunnels;
    for(const Pair& pair : pairs_)
      tunnels.push_back(loop_choice(pair.tunnel(), tm_, vertex_index).places);
    const std::vector<std::optional<Cylinder>> bores = bores_around(execution, mesh, tunnels);
    const double unit = link->unit(), least = options_.minimal_bore_diameter.value_or(0.),
                 most = options_.maximal_bore_diameter.value_or(
                     std::numeric_limits<double>::infinity());
    std::vector<char> is_wanted(pairs_.size(), 0);
    for(std::size_t i = 0; i < bores.size(); ++i)
      is_wanted[i] =
          bores[i] && least <= bores[i]->diameter * unit && bores[i]->diameter * unit <= most;
    return is_wanted;
  }

  // The mesh of the caller is as it was.
  struct Attempt
  {
    std::unique_ptr<Link> link;
    Surgery_mesh mesh;
    Index first_put_in;
    std::vector<Removal_task> tasks, necks;
  };

  // Handles, and then necks. If some handles are left where others were removed, all is done once
  // more, and they come first: as long as there are new ones among them, and not more are left.
  template <typename VertexIndexMap, typename FaceIndexMap>
  Attempt attempt_at_all(const std::vector<Removal_task>& tasks,
                         VertexIndexMap vertex_index,
                         FaceIndexMap face_index) {
    // Most of what is tried are no channels: their own loops have to do.
    Attempt attempt = attempt_at(
        tasks, options_.only_channels ? Removal_effort::GIVEN_LOOPS : Removal_effort::ALL_LOOPS,
        vertex_index, face_index);
    std::set<std::size_t> first; // those that come first, by pair
    std::vector<Removal_task> done = attempt.tasks;
    while(!options_.only_channels && number_left(done) <= number_left(attempt.tasks) &&
          may_do_better(done, first))
    {
      Attempt other = attempt_at(hindered_first(tasks, done, first), Removal_effort::MORE_LOOPS,
                                 vertex_index, face_index);
      done = other.tasks;
      if(number_left(done) < number_left(attempt.tasks))
        attempt = std::move(other);
    }
    if(options_.maximal_neck_length > 0.) {
      Removal_options options = options_;
      options.maximal_neck_length /= attempt.link->unit();
      attempt.necks = remove_necks(execution, attempt.mesh, options);
    }
    return attempt;
  }

  // Those that were removed and are no channels; whether there are any.
  static bool keep_others(std::vector<Removal_task>& tasks, const Attempt& attempt) {
    Parted_walls walls(execution, attempt.mesh, attempt.first_put_in,
                       {&attempt.tasks, &attempt.necks});
    std::set<std::size_t> others;
    for(const Removal_task& task : attempt.tasks)
      if(task.state == Removal_task::State::REMOVED && !walls.was_channel(task))
        others.insert(task.pair);
    for(Removal_task& task : tasks)
      if(others.count(task.pair) > 0)
        task.state = Removal_task::State::KEPT;
    return !others.empty();
  }

  template <typename VertexIndexMap, typename FaceIndexMap>
  Attempt attempt_at(std::vector<Removal_task> tasks,
                     Removal_effort effort,
                     VertexIndexMap vertex_index,
                     FaceIndexMap face_index) {
    Attempt attempt;
    attempt.link = new_link();
    attempt.mesh = attempt.link->read(execution, vertex_index, face_index);
    attempt.first_put_in = attempt.mesh.face_bound();
    attempt.tasks = std::move(tasks);
    for(Removal_task& task : attempt.tasks)
      task.divide_lengths(attempt.link->unit());
    remove_handles(execution, attempt.mesh, attempt.tasks, effort, options_.force,
                   [this](double done) { ask(0.7 + 0.2 * done); });
    return attempt;
  }

  // Whether some handles that did not come first may be left because of others that were removed:
  // not if they are too many.
  static bool may_do_better(const std::vector<Removal_task>& done,
                            const std::set<std::size_t>& first) {
    constexpr std::size_t most = 2; // for each that was removed, and before the first one
    return number_left(done) <= most * (1 + number_with(Removal_task::State::REMOVED, done)) &&
           std::any_of(done.begin(), done.end(), [&](const Removal_task& task) {
             return is_hindered(task) && first.count(task.pair) == 0;
           });
  }

  static bool is_hindered(const Removal_task& task) {
    return task.has_failed() && task.is_hindered;
  }

  // Those that are hindered are added to the first ones; the others are tried as it was done
  // before.
  static std::vector<Removal_task> hindered_first(std::vector<Removal_task> tasks,
                                                  const std::vector<Removal_task>& done,
                                                  std::set<std::size_t>& first) {
    std::map<std::size_t, const Removal_task*> done_of; // by pair
    for(const Removal_task& task : done)
      done_of[task.pair] = &task;
    for(Removal_task& task : tasks) {
      const Removal_task& other = *done_of.at(task.pair);
      if(is_hindered(other))
        first.insert(task.pair);
      task.comes_first = first.count(task.pair) > 0;
      if(other.state == Removal_task::State::REMOVED && other.are_given_loops)
        task.region = other.region;
    }
    return tasks;
  }

  // Asks no more once it was told to stop. What is done a second time is no progress.
  void ask(double done) {
    most_done_ = (std::max)(most_done_, done);
    if(ask_ && !ask_(most_done_)) {
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
      throw std::invalid_argument("the loops belong to another mesh: " +
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
    Handle_selection<Pair> wanted{options_, {}, {}};
    if(selects_bores())
      check_bores(wanted);
    if(options_.only_channels)
      check_channels(wanted);
    if(!wanted.maximal_length && options_.maximal_neck_length > 0.)
      wanted.maximal_length = options_.maximal_neck_length;
    if constexpr(is_given<internal_np::filter_t>)
      wanted.filter = parameters::get_parameter(np_, internal_np::filter);
    return wanted;
  }

  // Which are filled.
  void check_bores(Handle_selection<Pair>& wanted) const {
    const double least = options_.minimal_bore_diameter.value_or(0.),
                 most = options_.maximal_bore_diameter.value_or(least);
    if(!(least >= 0. && least <= most))
      throw std::invalid_argument("the range of bore diameters is empty");
    if(wanted.method == Removal_method::CUT)
      throw std::invalid_argument("bores can only be filled, not cut");
    wanted.method = Removal_method::FILL;
  }

  // Which are filled, and the last one of which is a neck.
  void check_channels(Handle_selection<Pair>& wanted) const {
    if(!(options_.maximal_neck_length > 0.))
      throw std::invalid_argument("removing channels requires the maximal neck length");
    if(wanted.method == Removal_method::CUT)
      throw std::invalid_argument("channels can only be filled, not cut");
    wanted.method = Removal_method::FILL;
  }

  // That what is promised is so.
  void check(const Surgery_mesh& mesh) {
    const Surface_count count = count_surface(execution, mesh);
    report_.genus_after = count.genus;
    report_.components_after = count.components;
    if(report_.genus_after + report_.removed.size() != report_.genus_before ||
       report_.components_after != report_.components_before + report_.removed_necks.size())
      throw std::logic_error("handles were removed, but the genus did not change accordingly");
  }

  // Patches are numbered as handles are described; the first of those removed together has one.
  void describe(std::vector<Removal_task> tasks,
                double unit,
                std::vector<Removed_handle>& removed,
                std::vector<Refused_handle>& refused) {
    for(Removal_task& task : tasks)
      task.divide_lengths(1. / unit);
    for(const Removal_task& task : tasks)
      if(task.state == Removal_task::State::REMOVED) {
        const std::size_t number = report_.removed.size() + report_.removed_necks.size();
        removed.push_back(task.removed());
        removed.back().patch = patches_.try_emplace(task.end_of_faces, number).first->second;
      } else if(task.state == Removal_task::State::REFUSED)
        refused.push_back(task.refused());
  }

  // Patches follow each other without gaps.
  std::size_t patch_of(Index face) const { return patches_.upper_bound(face)->second; }

  void write_back(const Surgery_mesh& mesh, Mesh_link<TriangleMesh, Vertex_point_map>& link) {
    auto vertices = get(internal_np::vertex_output_iterator, Emptyset_iterator());
    auto faces = get(internal_np::face_output_iterator, Emptyset_iterator());
    link.write_back(
        mesh, [&](Index, auto v) { *vertices++ = v; },
        [&](Index number, auto f) {
          *faces++ = f;
          if constexpr(is_given<internal_np::face_patch_t>)
            put(parameters::get_parameter(np_, internal_np::face_patch), f, patch_of(number));
          if constexpr(is_given<internal_np::face_to_face_map_t>)
            if(const Index origin = mesh.origin(number); origin != no_index)
              put(parameters::get_parameter(np_, internal_np::face_to_face_map), f,
                  link.face_read(origin));
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
  double most_done_ = 0.;
  std::vector<Pair> pairs_;
  Removal_report report_;
  std::map<Index, std::size_t> patches_; // their numbers, by the ends of their faces
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_HANDLE_REMOVER_H
