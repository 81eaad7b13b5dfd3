// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/surgery/removal.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Closed_triangles.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Loop_certifier.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Parted_walls.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Polyline_shape.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_rounds.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/bores_around.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/costs_of_removals.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/round_bores_of.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
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
struct Handle_selection : Removal_options
{
  std::function<bool(std::size_t)> filter;
  std::vector<char> is_bore_wanted; ///< by handle, if only bores are

  /// turns handles into tasks: first those that are to be removed, smallest first, then those that
  /// are kept. Throws `std::invalid_argument` if the selection makes no sense.
  std::vector<Removal_task> tasks(const std::vector<Choice_of_handle>& handles,
                                  std::size_t genus) const {
    if(target_genus && *target_genus > genus)
      throw std::invalid_argument("the target genus is " + std::to_string(*target_genus) +
                                  ", but the surface has genus " + std::to_string(genus));
    if(!methods.empty() && methods.rbegin()->first >= handles.size())
      throw std::invalid_argument("pair " + std::to_string(methods.rbegin()->first) +
                                  " does not exist");
    std::vector<Removal_task> selected, kept;
    for(std::size_t i = 0; i < handles.size(); ++i) {
      const Loop_type first = first_type(i, handles[i]);
      Removal_task task;
      task.pair = i;
      task.choices = {handles[i].loop(first), handles[i].loop(other(first))};
      task.choices.back().is_allowed = method_of(i) == Removal_method::SMALLEST_CHANGE;
      (is_wanted(i, handles[i], first) ? selected : kept).push_back(std::move(task));
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
  static Loop_type other(Loop_type type) {
    return type == Loop_type::TUNNEL ? Loop_type::HANDLE : Loop_type::TUNNEL;
  }

  Removal_method method_of(std::size_t i) const {
    const auto own = methods.find(i);
    return own == methods.end() ? method : own->second;
  }

  // The one whose length is the size of the handle.
  Loop_type first_type(std::size_t i, const Choice_of_handle& handle) const {
    if(method_of(i) == Removal_method::CUT)
      return Loop_type::HANDLE;
    if(method_of(i) == Removal_method::FILL)
      return Loop_type::TUNNEL;
    return handle.tunnel.length < handle.handle.length ? Loop_type::TUNNEL : Loop_type::HANDLE;
  }

  bool is_wanted(std::size_t i, const Choice_of_handle& handle, Loop_type first) const {
    return (is_bore_wanted.empty() || is_bore_wanted[i]) &&
           (!maximal_length || handle.loop(first).length < *maximal_length) &&
           (!box ||
            (first == Loop_type::TUNNEL ? handle.is_tunnel_in_box : handle.is_handle_in_box)) &&
           (!filter || filter(i));
  }
};

/// `CGAL::remove_handles()`, step by step.
class Handle_removal
{
public:
  Handle_removal(Execution execution,
                 const Triangle_list& triangles,
                 const Removal_request& request)
      : execution_(execution)
      , request_(request)
      , options_(request.options)
      , original_(surgery_mesh_of(triangles, unit_))
      , number_of_faces_(static_cast<Index>(triangles.number_of_faces())) {
    report_.genus_before = request.genus;
    report_.components_before = request.components;
  }

  Removal_result operator()() {
    Handle_selection wanted = selection();
    if(selects_bores())
      wanted.is_bore_wanted = find_bores();
    std::vector<Removal_task> tasks = wanted.tasks(request_.handles, report_.genus_before);
    Attempt attempt = attempt_at_all(tasks);
    while(options_.only_channels && keep_others(tasks, attempt))
      attempt = attempt_at_all(tasks);
    describe(std::move(attempt.tasks), report_.removed, report_.refused);
    describe(std::move(attempt.necks), report_.removed_necks, report_.refused_necks);
    check(attempt.mesh);
    ask(1.);
    return {std::move(report_), change_to(attempt.mesh)};
  }

private:
  bool selects_bores() const {
    return options_.minimal_bore_diameter || options_.maximal_bore_diameter;
  }

  // By pair, whether it is that of a bore of a diameter that is asked for.
  std::vector<char> find_bores() const {
    std::vector<std::vector<Place_on_edge>> tunnels;
    for(const Choice_of_handle& handle : request_.handles)
      tunnels.push_back(handle.tunnel.places);
    const std::vector<std::optional<Cylinder>> bores = bores_around(execution_, original_, tunnels);
    const double least = options_.minimal_bore_diameter.value_or(0.),
                 most = options_.maximal_bore_diameter.value_or(
                     std::numeric_limits<double>::infinity());
    std::vector<char> is_wanted(request_.handles.size(), 0);
    for(std::size_t i = 0; i < bores.size(); ++i)
      is_wanted[i] =
          bores[i] && least <= bores[i]->diameter * unit_ && bores[i]->diameter * unit_ <= most;
    return is_wanted;
  }

  struct Attempt
  {
    Surgery_mesh mesh;
    std::vector<Removal_task> tasks, necks;
  };

  // Handles, and then necks. If some handles are left where others were removed, all is done once
  // more, and they come first: as long as there are new ones among them, and not more are left.
  Attempt attempt_at_all(const std::vector<Removal_task>& tasks) {
    // Most of what is tried are no channels: their own loops have to do.
    Attempt attempt = attempt_at(tasks, options_.only_channels ? Removal_effort::GIVEN_LOOPS
                                                               : Removal_effort::ALL_LOOPS);
    std::set<std::size_t> first; // those that come first, by pair
    std::vector<Removal_task> done = attempt.tasks;
    while(!options_.only_channels && number_left(done) <= number_left(attempt.tasks) &&
          may_do_better(done, first))
    {
      Attempt other = attempt_at(hindered_first(tasks, done, first), Removal_effort::MORE_LOOPS);
      done = other.tasks;
      if(number_left(done) < number_left(attempt.tasks))
        attempt = std::move(other);
    }
    if(options_.maximal_neck_length > 0.) {
      Removal_options options = options_;
      options.maximal_neck_length /= unit_;
      attempt.necks = remove_necks(execution_, attempt.mesh, options);
    }
    return attempt;
  }

  // Those that were removed and are no channels; whether there are any.
  bool keep_others(std::vector<Removal_task>& tasks, const Attempt& attempt) const {
    Parted_walls walls(execution_, attempt.mesh, original_.face_bound(),
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

  Attempt attempt_at(std::vector<Removal_task> tasks, Removal_effort effort) {
    Attempt attempt{original_, std::move(tasks), {}};
    for(Removal_task& task : attempt.tasks)
      task.divide_lengths(unit_);
    remove_handles(execution_, attempt.mesh, attempt.tasks, effort, options_.force,
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
    if(is_asked_ && request_.callback && !request_.callback(most_done_)) {
      is_asked_ = false;
      throw Interrupted_exception();
    }
  }

  // The size of a neck is a limit for handles, too, unless these have one of their own.
  Handle_selection selection() const {
    if(!(options_.maximal_neck_length >= 0.))
      throw std::invalid_argument("the maximal length of a neck is negative");
    if(!(options_.minimal_piece_share >= 0. && options_.minimal_piece_share <= 0.5))
      throw std::invalid_argument("the share of a piece is not in [0, 0.5]");
    if(options_.maximal_length && !(*options_.maximal_length > 0.))
      throw std::invalid_argument("the maximal length is not positive");
    Handle_selection wanted{options_, request_.filter, {}};
    if(selects_bores())
      check_bores(wanted);
    if(options_.only_channels)
      check_channels(wanted);
    if(!wanted.maximal_length && options_.maximal_neck_length > 0.)
      wanted.maximal_length = options_.maximal_neck_length;
    return wanted;
  }

  // Which are filled.
  void check_bores(Handle_selection& wanted) const {
    const double least = options_.minimal_bore_diameter.value_or(0.),
                 most = options_.maximal_bore_diameter.value_or(least);
    if(!(least >= 0. && least <= most))
      throw std::invalid_argument("the range of bore diameters is empty");
    if(wanted.method == Removal_method::CUT)
      throw std::invalid_argument("bores can only be filled, not cut");
    wanted.method = Removal_method::FILL;
  }

  // Which are filled, and the last one of which is a neck.
  void check_channels(Handle_selection& wanted) const {
    if(!(options_.maximal_neck_length > 0.))
      throw std::invalid_argument("removing channels requires the maximal neck length");
    if(wanted.method == Removal_method::CUT)
      throw std::invalid_argument("channels can only be filled, not cut");
    wanted.method = Removal_method::FILL;
  }

  // That what is promised is so.
  void check(const Surgery_mesh& mesh) {
    const Surface_count count = count_surface(execution_, mesh);
    report_.genus_after = count.genus;
    report_.components_after = count.components;
    if(report_.genus_after + report_.removed.size() != report_.genus_before ||
       report_.components_after != report_.components_before + report_.removed_necks.size())
      throw std::logic_error("handles were removed, but the genus did not change accordingly");
  }

  // Patches are numbered as handles are described; the first of those removed together has one.
  void describe(std::vector<Removal_task> tasks,
                std::vector<Removed_handle>& removed,
                std::vector<Refused_handle>& refused) {
    for(Removal_task& task : tasks)
      task.divide_lengths(1. / unit_);
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

  Mesh_change change_to(const Surgery_mesh& mesh) const {
    Mesh_change change;
    change.vertex_bound = mesh.vertex_bound();
    change.first_new_face = original_.face_bound();
    for(Index f = number_of_faces_; f < original_.face_bound(); ++f)
      change.twins_of_caps.push_back(original_.twin(3 * f));
    for(Index f = 0; f < number_of_faces_; ++f)
      if(original_.is_alive(f) && !mesh.is_alive(f))
        change.faces_gone.push_back(f);
    for(Index v = 0; v < mesh.vertex_bound(); ++v) {
      const bool was_there = v < original_.first_hub() && original_.outgoing(v) != no_index;
      const bool is_there = mesh.outgoing(v) != no_index && !mesh.is_hub(v);
      if(was_there && mesh.outgoing(v) == no_index)
        change.vertices_gone.push_back(v);
      else if(!was_there && is_there)
        change.new_vertices.push_back({v, unit_ * Surgery_mesh::place_of(mesh.point(v))});
    }
    for(Index f = change.first_new_face; f < mesh.face_bound(); ++f)
      if(mesh.is_alive(f))
        change.new_faces.push_back({f,
                                    mesh.corners(f),
                                    {mesh.twin(3 * f), mesh.twin(3 * f + 1), mesh.twin(3 * f + 2)},
                                    mesh.origin(f),
                                    patch_of(f)});
    return change;
  }

  Execution execution_;
  const Removal_request& request_;
  const Removal_options& options_;
  double unit_ = 1.; // of lengths in the copies
  const Surgery_mesh original_;
  const Index number_of_faces_; // without those of caps
  double most_done_ = 0.;
  bool is_asked_ = true;
  Removal_report report_;
  std::map<Index, std::size_t> patches_; // their numbers, by the ends of their faces
};

/// throws `std::invalid_argument` unless all loops are closed curves on the mesh.
static void check_loops(Execution execution,
                        const Triangle_list& triangles,
                        const std::vector<Choice_of_handle>& handles) {
  const Closed_triangles closed(triangles);
  std::vector<Closed_triangles::Loop> loops;
  for(const Choice_of_handle& handle : handles)
    for(const Loop_choice* loop : {&handle.handle, &handle.tunnel}) {
      std::vector<Closed_triangles::Loop::Step> steps;
      for(const Place_on_edge& p : loop->places) {
        const bool is_known = p.source < num_vertices(closed) && p.target < num_vertices(closed) &&
                              halfedge(p.target, closed) != Closed_triangles::Halfedge();
        steps.push_back(
            {is_known ? halfedge(p.source, p.target, closed).first : Closed_triangles::Halfedge(),
             p.ratio});
      }
      loops.emplace_back(std::move(steps), std::vector<Closed_triangles::Point>(), 0.,
                         Loop_type::HANDLE, loops.size());
    }
  Loop_certifier certifier(closed);
  certifier.set_loops(execution, loops);
  if(!certifier.are_closed_on_surface())
    throw std::invalid_argument("the loops belong to another mesh: " +
                                certifier.failures().front());
}

Removal_result
removal_of_handles(Execution execution, Triangle_list triangles, const Removal_request& request) {
  if(request.are_loops_of_caller)
    check_loops(execution, triangles, request.handles);
  Handle_removal removal(execution, triangles, request);
  triangles = {};
  return removal();
}

std::vector<Removal_costs> costs_of_removals(Execution execution,
                                             const Triangle_list& triangles,
                                             const std::vector<Choice_of_handle>& handles,
                                             bool force,
                                             const std::function<bool(double)>& callback) {
  double unit = 1.;
  Surgery_mesh mesh = surgery_mesh_of(triangles, unit);
  std::vector<Removal_task> tasks; // two for each handle, first that of the cut
  for(std::size_t i = 0; i < 2 * handles.size(); ++i) {
    const Choice_of_handle& handle = handles[i / 2];
    tasks.emplace_back();
    tasks.back().pair = i / 2;
    tasks.back().choices = i % 2 == 0 ? std::vector<Loop_choice>{handle.handle, handle.tunnel}
                                      : std::vector<Loop_choice>{handle.tunnel, handle.handle};
    tasks.back().choices.back().is_allowed = false;
    tasks.back().divide_lengths(unit);
  }
  try_to_remove_each(execution, mesh, tasks, force, [&](double done) {
    if(callback && !callback(done))
      throw Interrupted_exception();
  });
  std::vector<Removal_costs> costs(handles.size());
  const auto describe = [&](Removal_task& task, std::optional<Removed_handle>& way,
                            std::string& why_not) {
    task.divide_lengths(1. / unit);
    if(task.state == Removal_task::State::REMOVED)
      way = task.removed();
    else
      why_not = task.reasons.front();
  };
  for(std::size_t i = 0; i < handles.size(); ++i) {
    describe(tasks[2 * i], costs[i].cut, costs[i].why_no_cut);
    describe(tasks[2 * i + 1], costs[i].fill, costs[i].why_no_fill);
  }
  return costs;
}

/// whether at least half of the edges and vertices of a loop have a face beside them that lies
/// along the axis of the loop, up to three degrees, as those of a cylinder do around which it goes.
static bool crosses_faces_along_axis(const Surgery_mesh& mesh, const Tunnel_to_search& tunnel) {
  using Direction = Polyline_shape::Vector;
  constexpr double sine = 0.05;
  std::vector<Polyline_shape::Point> points;
  for(const Vector& p : tunnel.points)
    points.emplace_back(p[0], p[1], p[2]);
  const Direction axis = Polyline_shape(points).normal;
  const auto place = [&](Index v) {
    const Vector p = Surgery_mesh::place_of(mesh.point(v));
    return Polyline_shape::Point(p[0], p[1], p[2]);
  };
  // In a unit in which squares are numbers.
  const auto side = [&](Index from, Index to) {
    const Direction v = place(to) - place(from);
    const double size = (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
    return size > 0. ? v / size : v;
  };
  const auto lies_along = [&](Index h) {
    if(mesh.is_in_cap(mesh.face(h)))
      return false;
    const Index v = mesh.source(h);
    const Direction n =
        CGAL::cross_product(side(v, mesh.target(h)), side(v, mesh.target(mesh.next(h))));
    return std::abs(n * axis) <= sine * std::sqrt(n.squared_length());
  };
  // A loop along a mouth goes from vertex to vertex.
  const auto is_beside_one = [&](const Place_on_edge& p) {
    if(p.ratio != 0. && p.ratio != 1.) {
      const Index h = mesh.halfedge(p.source, p.target);
      return lies_along(h) || lies_along(mesh.twin(h));
    }
    bool is_any = false;
    mesh.for_each_outgoing(p.ratio == 1. ? p.target : p.source,
                           [&](Index h) { is_any = is_any || lies_along(mesh.twin(h)); });
    return is_any;
  };
  const auto number = std::count_if(tunnel.places.begin(), tunnel.places.end(), is_beside_one);
  return 2 * static_cast<std::size_t>(number) >= tunnel.places.size();
}

std::vector<std::optional<Bore_of_caller>>
round_bores_of(Execution execution,
               const Triangle_list& triangles,
               const std::vector<Tunnel_to_search>& tunnels) {
  double unit = 1.;
  const Surgery_mesh mesh = surgery_mesh_of(triangles, unit);
  std::vector<std::vector<Place_on_edge>> searched;
  std::vector<std::size_t> numbers;
  for(std::size_t i = 0; i < tunnels.size(); ++i)
    if(crosses_faces_along_axis(mesh, tunnels[i])) {
      searched.push_back(tunnels[i].places);
      numbers.push_back(i);
    }
  std::vector<std::optional<Bore_of_caller>> bores(tunnels.size());
  if(searched.empty())
    return bores;
  const std::vector<std::optional<Cylinder>> found = bores_around(execution, mesh, searched);
  std::map<Index, std::size_t> drillings; // by their first faces
  for(std::size_t i = 0; i < found.size(); ++i)
    if(found[i]) {
      const auto& c = found[i]->center;
      const auto& a = found[i]->axis;
      bores[numbers[i]] =
          Bore_of_caller{unit * found[i]->diameter,
                         {unit * c.x(), unit * c.y(), unit * c.z()},
                         {a.x(), a.y(), a.z()},
                         unit * found[i]->length,
                         unit * found[i]->deviation,
                         drillings.insert({found[i]->first_face, drillings.size()}).first->second};
    }
  return bores;
}

} // namespace CGAL::Handle_tunnel_loops::internal
