// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_HANDLE_MEASURER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_HANDLE_MEASURER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Ball_curve.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Cap_bounds.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Cycle_trials.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Edge_names.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Leaking_edges.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linked_segments.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Paired_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Pushed_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Surface_points.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Voronoi_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Way_network.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Widest_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/measure_handles.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds the largest balls that can be led through holes and around handles.

Where they pass caps, there must be room for them: that is one bound (`Cap_bounds`). The other is a
cycle itself, if balls of nearly its radius fit all along it (`Clearance`). Beside the loops there
are some (`Pushed_loops`), which are moved to where there is more room as far as that leads
(`Cycle_trials::widened`).

Where these differ, points on the surface are no nearer to a ball than the surface is: so the widest
cycles among the points (`Widest_cycles`) are at least as wide as those of the surface, one by one,
as long as no cycle slips between points through a loop. Few points lead to most that are not beside
loops. Where the bounds still differ, cycles slip through the surface between points that are too
far apart: more are taken all along where they do (`Leaking_edges`). So it goes on until the bounds
agree. Only the widest cycles are looked for, up to the last that is in doubt: balls so small that
they slip through the surface whatever points are taken are left to the caps.
*/
class Handle_measurer
{
public:
  Handle_measurer(Execution execution,
                  const Flat_mesh& mesh,
                  const std::vector<Vector>& places,
                  const std::vector<Polyline_pair>& pairs)
      : execution_(execution)
      , faces_(execution, mesh, span_of(places))
      , clearance_(faces_, gap / 12.)
      , wall_(mesh, span_of(places), faces_)
      , points_(execution, faces_)
      , loops_(loops_of(pairs))
      , caps_(execution, faces_, clearance_, span_of(places), loops_, gap / 8.)
      , most_(caps_.most())
      , linked_(execution, loops_)
      , tries_(clearance_, linked_, gap) {
    for(const Vector& p : places)
      points_.add(p);
    for(const auto& loop : loops_)
      lengths_.push_back(closed_length(loop));
    places_ = places.size();
    find_extent();
  }

  Flat_measures measure() {
    if(loops_.empty())
      return {};
    take_pushed_loops();
    take_sections();
    if(!are_all_known())
      take_parts_of_ways();
    if(are_all_known())
      return assign();
    refine_along_loops();
    Voronoi_graph graph(box_.low, box_.high);
    number_ = loops_.size();
    take_cycles_among_points(graph, 0);
    number_ = number_in_doubt();
    if(number_ == 0)
      return assign();
    std::size_t inserted = points_.points().size(), work = inserted; // points of all rounds
    const double number = double(most_at_first + places_);
    points_.refine_by_thickness(execution_, wall_, part_of_thickness,
                                (std::max)(std::sqrt(area_ / number), 0.1 * sides_ / number));
    points_.set_most(points_.points().size() + most_points());
    do {
      const std::size_t before = std::exchange(inserted, points_.points().size());
      take_cycles_among_points(graph, before);
      refine(graph, inserted);
      work += inserted;
    } while(points_.points().size() > inserted && is_worth(work));
    return assign();
  }

private:
  // Between the bounds of a diameter, so that its middle is known to 1% with half of it and more to
  // spare for what is rounded.
  static constexpr double gap = 0.015;
  // Of pieces of faces, as a part of the radius of a ball: that comes nearer to the middle of such
  // a side than to its ends by half the gap.
  static constexpr double least_side = 0.26;
  static constexpr int blind_rounds = 1; // a few points first, to see between
  static constexpr double part_of_thickness = 0.45, least_growth = 0.1;
  static constexpr std::size_t most_at_first = 20000;
  static constexpr std::size_t work_per_vertex = 5, more_work = 400000;
  static constexpr std::size_t points_per_vertex = 3, more_points = 100000;

  /// An edge through which cycles slip that are wider than a radius, and how long sides of pieces
  /// may be where they are not to.
  struct Leak
  {
    Narrow_place narrow;
    double radius, side;
  };

  static std::vector<std::vector<Vector>> loops_of(const std::vector<Polyline_pair>& pairs) {
    std::vector<std::vector<Vector>> loops;
    for(const Polyline_pair& pair : pairs)
      loops.insert(loops.end(), pair.begin(), pair.end());
    return loops;
  }

  void find_extent() {
    box_ = Box<3>::empty();
    for(Index f = 0; f < faces_.size(); ++f) {
      const Triangle t = faces_.triangle(f);
      area_ += 0.5 * norm(cross(t[1] - t[0], t[2] - t[0]));
      sides_ += norm(t[1] - t[0]) + norm(t[2] - t[1]) + norm(t[0] - t[2]);
      for(const Vector& p : t)
        box_.extend({p, p});
    }
  }

  // ---- points

  // Points on loops, and near those through which cycles in doubt are led, and beside which they
  // are, their partners: what is narrow is close to these.
  void refine_along_loops() {
    std::vector<char> is_in_doubt(loops_.size(), cycles_.size() < most_.size() ? 1 : 0);
    for(std::size_t i = 0; i < cycles_.size(); ++i)
      if(!is_known(i))
        for(const auto& [loop, number] : cycles_[i].row)
          is_in_doubt[loop] = is_in_doubt[loop ^ 1] = 1;
    for(std::size_t l = 0; l < loops_.size(); ++l) {
      const double radius = lengths_[l] / 12., side = 0.5 * radius;
      for_each_place(l, side, [&](const Vector& p) {
        if(is_in_doubt[l] != 0)
          requests_.push_back({p, 1.2 * radius, side});
        points_.add(p);
      });
    }
    points_.refine(execution_, std::exchange(requests_, {}));
  }

  // Places on a loop that are not farther apart.
  template <typename Function>
  void for_each_place(std::size_t loop, double distance, const Function& f) const {
    const std::vector<Vector>& points = loops_[loop];
    for(std::size_t i = 0; i < points.size(); ++i) {
      const Vector &a = points[i], &b = points[i + 1 < points.size() ? i + 1 : 0];
      const int n = static_cast<int>((std::min)(1e6, norm(b - a) / distance)) + 1;
      for(int k = 0; k < n; ++k)
        f(k == 0 ? a : (1. - double(k) / n) * a + (double(k) / n) * b);
    }
  }

  // Whether to go on: until bounds agree, the longer where there is but one.
  bool is_worth(std::size_t work) const {
    const std::size_t most = work_per_vertex * places_ + more_work;
    return work < most || (work < 2 * most && !are_all_wide());
  }

  // More effort where little came of it.
  void refine(const Voronoi_graph& graph, std::size_t before) {
    constexpr int most_effort = 8;
    do {
      refine();
      effort_ += points_.points().size() < (1. + least_growth) * double(before) ? 1 : 0;
    } while(points_.points().size() == before && number_in_doubt() > 0 && effort_ < most_effort);
    close_loops(graph, most_[number_ - 1]);
  }

  std::size_t most_points() const { return points_per_vertex * places_ + more_points; }

  // Of the widest cycles: all are among them that are in doubt, and of which points can tell.
  std::size_t number_in_doubt() const {
    const double least = least_radius();
    const auto is_left = [&](std::size_t i) {
      return is_known(i) || (most_[i] < least && most_[i] >= caps_.most()[i]);
    };
    std::size_t number = most_.size();
    while(number > 0 && is_left(number - 1))
      --number;
    return number;
  }

  // Smaller balls slip through, where a few points do not tell otherwise already, whatever more are
  // taken: two to a square with sides of sqrt(3) times that, on a part of the surface, as not all
  // of it is narrow. (With a quarter of the part, a mesh whose tiny ways points do not settle takes
  // twice as long; with four times as much, ways are given up that they would settle.)
  double least_radius() const {
    constexpr double part = 0.1;
    return std::sqrt(2. / 3. * part * area_ / double(most_points()));
  }

  bool is_known(std::size_t cycle) const {
    return cycle < cycles_.size() && trials_[cycle].narrow.empty();
  }

  bool are_all_wide() const {
    return cycles_.size() == most_.size() &&
           std::all_of(trials_.begin(), trials_.end(),
                       [](const Cycle_trial& trial) { return trial.is_wide; });
  }

  bool are_all_known() const {
    return cycles_.size() == most_.size() &&
           std::all_of(trials_.begin(), trials_.end(),
                       [](const Cycle_trial& trial) { return trial.narrow.empty(); });
  }

  // Where a ball nearly passes, and where points are passed. Denser, and farther around, the less
  // came of it in the rounds before.
  void refine() {
    constexpr double wide_reach = 6., largest_side = 0.8, much = 4.;
    for(std::size_t i = 0; i < size_in_doubt(); ++i)
      if(!trials_[i].is_leak_known || trials_[i].radius >= (1. - much * gap) * most_[i])
        for(const Narrow_place& n : trials_[i].narrow)
          if(refine_at(n, most_[i],
                       least_side * most_[i])) // no such ball is to slip through beside it
            requests_.push_back(
                {n.place, wide_reach * reach() * n.distance, largest_side * most_[i]});
    for(const auto& [narrow, radius, side] : leaks_)
      refine_at(narrow, radius, side);
    points_.refine(execution_, std::exchange(requests_, {}));
  }

  double reach() const { return 1.1 * integer_power(1.25, (std::min)(effort_, 4)); }

  // Returns whether it is about as narrow as a radius.
  bool refine_at(const Narrow_place& narrow, double radius, double side) {
    constexpr double part_of_distance = 0.35, much = 1.5;
    const bool is_tight = narrow.distance < much * radius;
    requests_.push_back({narrow.place, reach() * narrow.distance,
                         is_tight ? integer_power(0.7, (std::min)(effort_, 4)) * side
                                  : (std::max)(side, part_of_distance * narrow.distance)});
    return is_tight;
  }

  // So that no cycle slips through between points of a loop, as long as these are not too many.
  void close_loops(const Voronoi_graph& graph, double radius) {
    constexpr double step = 0.5, most_away = 0.7;
    const double all = std::accumulate(lengths_.begin(), lengths_.end(), 0.);
    const double least = all / static_cast<double>(places_ + more_points);
    Voronoi_graph::Vertex_handle nearest;
    for(std::size_t l = 0; l < loops_.size(); ++l)
      for_each_place(l, (std::max)(step * radius, least), [&](const Vector& p) {
        if(graph.distance(p, nearest) > most_away * radius)
          points_.add(p);
      });
  }

  // ---- cycles

  // \p inserted is how many of the points the graph has already.
  void take_cycles_among_points(Voronoi_graph& graph, std::size_t inserted) {
    graph.insert(execution_, points_.points(), inserted);
    graph.build(execution_);
    find_cycles(graph);
  }

  // The widest among the points tell how wide cycles are at most. Where none is known that is as
  // wide, others are looked for that do not cross the surface, and are wide as that is seen.
  void find_cycles(Voronoi_graph& graph) {
    Edge_names names(graph, linked_);
    auto cycles = widest_cycles(graph, names, &Ball_network::Edge::radius);
    for(std::size_t i = 0; i < cycles.size(); ++i)
      most_[i] = (std::min)(caps_.most()[i], cycles[i].radius);
    leaks_.clear();
    judge();
    if(number_in_doubt() > 0) {
      take(std::move(cycles));
      take_sections();
    }
    if(number_in_doubt() == 0 || rounds_++ < blind_rounds)
      return;
    see_surface(graph, least_doubtful(), most_doubtful());
    auto others = widest_cycles(graph, names, &Ball_network::Edge::seen);
    std::vector<Class> seen;
    for(const Widest_cycle& cycle : others)
      seen.push_back({cycle.radius, cycle.row});
    take(std::move(others));
    take_sections();
    find_leaks(graph, names, seen);
  }

  std::vector<Widest_cycle>
  widest_cycles(const Ball_network& graph, Edge_names& names, Widest_cycles::Width width) const {
    return Widest_cycles(execution_, graph, names, width).find(number_);
  }

  // How many cycles there are among those that may be in doubt.
  std::size_t size_in_doubt() const { return (std::min)(number_, cycles_.size()); }

  void take(std::vector<Widest_cycle> cycles) {
    std::vector<Cycle_trial> found(cycles.size());
    for_each_index(
        execution_, cycles.size(),
        [&](std::size_t i) {
          found[i] = tries_.trial(cycles[i], most_[i]);
          const double most = (std::min)(most_[i], caps_.of_cycle(cycles[i].row));
          if(found[i].is_wide && found[i].radius < (1. - gap) * most)
            found[i] = tries_.widened(std::move(found[i]), cycles[i].row, most);
        },
        1);
    take(std::move(cycles), std::move(found));
  }

  // Beside loops, for a ball that passes through the loop's partner.
  void take_pushed_loops() {
    const Pushed_loops pushed(wall_, clearance_, tries_);
    std::vector<std::vector<Pushed_loops::Free_walk>> walks(loops_.size());
    for_each_index(
        execution_, loops_.size(),
        [&](std::size_t l) {
          const Index partner = static_cast<Index>(l) ^ 1;
          walks[l] = pushed.find(loops_[l], partner, caps_.of_loop(partner));
          for(auto& [row, trial] : walks[l])
            if(!row.empty())
              trial = tries_.widened(std::move(trial), row, caps_.of_cycle(row));
        },
        1);
    std::vector<Widest_cycle> cycles;
    std::vector<Cycle_trial> found;
    for(auto& beside : walks)
      for(auto& [row, trial] : beside)
        if(!row.empty()) {
          cycles.push_back(Cycle_trials::cycle_along(trial, row));
          found.push_back(std::move(trial));
        }
    take(std::move(cycles), std::move(found));
  }

  // What parts of the ways that are known make up, with caps across their narrow places.
  void take_parts_of_ways() {
    const Way_network network(execution_, clearance_, trials_, most_.front());
    Edge_names names(network, linked_);
    std::vector<Widest_cycle> cycles = others_than_known(
        Widest_cycles(execution_, network, names, &Ball_network::Edge::radius).find(loops_.size()));
    std::vector<Cycle_trial> found(cycles.size());
    for_each_index(
        execution_, cycles.size(),
        [&](std::size_t i) {
          found[i] = tries_.along(cycles[i], cycles[i].radius, Cycle_trials::Places::KEEP);
          found[i].is_wide = found[i].is_wide && tries_.row_of(found[i].curve) == cycles[i].row;
          if(found[i].is_wide)
            found[i] = tries_.widened(std::move(found[i]), cycles[i].row,
                                      (std::min)(most_[i], caps_.of_cycle(cycles[i].row)));
        },
        1);
    take(std::move(cycles), std::move(found));
    take_sections();
  }

  // Those of other classes than sums of cycles that are known to be as wide as may be.
  std::vector<Widest_cycle> others_than_known(std::vector<Widest_cycle> cycles) const {
    Linking_rank rank;
    for(std::size_t i = 0; i < cycles_.size(); ++i)
      if(trials_[i].is_wide && trials_[i].narrow.empty())
        rank.add(cycles_[i].row);
    cycles.erase(std::remove_if(cycles.begin(), cycles.end(),
                                [&](const Widest_cycle& cycle) { return !rank.add(cycle.row); }),
                 cycles.end());
    return cycles;
  }

  // Caps across the narrow places of cycles that might be wider by what is known.
  void take_sections() {
    caps_.add_sections(1. - gap, cycles_, trials_);
    for(std::size_t i = 0; i < most_.size(); ++i)
      most_[i] = (std::min)(most_[i], caps_.most()[i]);
    judge();
  }

  // Of the cycles and these, the ones that have most room and are independent.
  void take(std::vector<Widest_cycle> cycles, std::vector<Cycle_trial> found) {
    cycles.insert(cycles.end(), std::make_move_iterator(cycles_.begin()),
                  std::make_move_iterator(cycles_.end()));
    found.insert(found.end(), std::make_move_iterator(trials_.begin()),
                 std::make_move_iterator(trials_.end()));
    std::vector<std::size_t> order(cycles.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto room = [&](std::size_t i) { return found[i].is_wide ? found[i].radius : 0.; };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return room(i) > room(j); });
    cycles_.clear();
    trials_.clear();
    Linking_rank rank;
    for(const std::size_t i : order)
      if(cycles_.size() < most_.size() && rank.add(cycles[i].row)) {
        cycles_.push_back(std::move(cycles[i]));
        trials_.push_back(std::move(found[i]));
      }
    judge();
  }

  // Whether cycles are as wide as they may be, which may be other radii than were tried.
  void judge() {
    for(std::size_t i = 0; i < cycles_.size(); ++i)
      if(Cycle_trial& trial = trials_[i]; trial.is_wide && trial.radius >= (1. - gap) * most_[i])
        trial.narrow.clear();
      else if(trial.narrow.empty())
        trial.narrow.push_back({cycles_[i].balls.front().place, cycles_[i].balls.front().radius});
  }

  /// Of cycles that are seen, and a radius.
  struct Class
  {
    double radius;
    Linking_row row;
  };

  // For radii that are a little larger than what is known. Those that are about equal need but one
  // look.
  void
  find_leaks(const Voronoi_graph& graph, const Edge_names& names, const std::vector<Class>& seen) {
    const Leaking_edges leaking(graph, names, loops_.size());
    double last = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < size_in_doubt(); ++i) {
      if(is_known(i))
        continue;
      const double known = trials_[i].is_wide ? trials_[i].radius
                           : i < seen.size()  ? seen[i].radius
                                              : 0.5 * most_[i];
      const double radius = (1. + 0.5 * gap) * known;
      trials_[i].is_leak_known = i > 0 && trials_[i - 1].is_leak_known;
      if(radius > (1. - gap) * last)
        continue;
      last = radius;
      const std::size_t before = leaks_.size();
      for(const Index e : leaking.find(radius, classes_wider(radius, seen)))
        leaks_.push_back({{graph.narrowest(e), graph.edges[e].radius},
                          radius,
                          side_against(radius, graph.edges[e].radius)});
      trials_[i].is_leak_known = leaks_.size() > before;
    }
  }

  // Of pieces with points between which there is not so much more room than that: the more there
  // is, the less is known yet of where there is least.
  double side_against(double radius, double room) const {
    constexpr double part = 2., most = 0.5;
    const double side = std::sqrt((std::max)(0., part * (room - radius) * (room + radius)));
    return (std::max)(least_side * radius, (std::min)(most * radius, side));
  }

  Linking_rank classes_wider(double radius, const std::vector<Class>& seen) const {
    Linking_rank rank;
    for(const Class& c : seen)
      if(c.radius >= radius)
        rank.add(c.row);
    for(std::size_t i = 0; i < cycles_.size(); ++i)
      if(trials_[i].is_wide && trials_[i].radius >= radius)
        rank.add(cycles_[i].row);
    return rank;
  }

  // A radius that is less than those of which not enough is known. A way between points that are
  // far apart may lead through narrow ones, beside which there is room.
  double least_doubtful() const {
    constexpr double part_of_known = 0.95, part_of_most = 0.5;
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < size_in_doubt(); ++i)
      if(const Cycle_trial& trial = trials_[i]; !trial.narrow.empty())
        least = (std::min)(least, (std::max)(trial.is_wide ? part_of_known * trial.radius : 0.,
                                             part_of_most * most_[i]));
    return least;
  }

  // No radius of which not enough is known is larger.
  double most_doubtful() const {
    std::size_t i = 0;
    while(is_known(i))
      ++i;
    return most_[i];
  }

  static constexpr double about = 0.997; // to choose by, clearances are known so well

  // Makes edges as narrow as the surface is seen from their ends, and leaves out those that cross
  // it. Those that are narrower than \p least stay as they are, and no more than \p most is looked
  // for around an end.
  void see_surface(Voronoi_graph& graph, double least, double most) const {
    std::vector<double> clearance(graph.nodes.size(), 0.);
    for_each_index(
        execution_, graph.nodes.size(),
        [&](std::size_t i) {
          if(const Ball_network::Node& n = graph.nodes[i]; n.radius >= least)
            clearance[i] = clearance_.at(n.place, (std::min)(n.radius, most), about);
        },
        256);
    for_each_index(
        execution_, graph.edges.size(),
        [&](std::size_t i) {
          if(Ball_network::Edge& e = graph.edges[i]; e.radius >= least)
            e.seen = e.radius * static_cast<float>(seen_part(graph, e, clearance, most));
        },
        256);
  }

  double seen_part(const Ball_network& graph,
                   const Ball_network::Edge& edge,
                   const std::vector<double>& clearance,
                   double most) const {
    const auto [a, b] = edge.nodes;
    const Ball_network::Node &n = graph.nodes[a], &m = graph.nodes[b];
    if(norm(n.place - m.place) >= about * (clearance[a] + clearance[b]) &&
       wall_.meets(n.place, m.place))
      return 0.;
    return (std::min)(clearance[a] / (std::min)(n.radius, most),
                      clearance[b] / (std::min)(m.radius, most));
  }

  // ---- answers

  bool is_inside(const std::vector<Vector>& curve) const {
    bool is_odd = false;
    faces_.for_each_above(curve[0], curve[1], [&](Index) { is_odd = !is_odd; });
    return is_odd;
  }

  Flat_measures assign() {
    Flat_measures measures;
    measures.pairs.resize(loops_.size() / 2);
    std::vector<std::vector<Vector>> curves(cycles_.size());
    std::vector<int> side(cycles_.size(), -1);
    for_each_index(
        execution_, cycles_.size(),
        [&](std::size_t i) {
          if(!trials_[i].is_wide)
            return;
          curves[i] = curve(i);
          side[i] = is_inside(curves[i]) ? 1 : 0;
        },
        1);
    for(const int inside : {0, 1})
      assign(side, inside, curves, measures);
    if(std::count(side.begin(), side.end(), -1) > 0 || cycles_.size() < loops_.size())
      measures.why = "some places would need too many points";
    return measures;
  }

  std::vector<Vector> curve(std::size_t cycle) const {
    const Cycle_trial& trial = trials_[cycle];
    return Ball_curve(clearance_, linked_, trial.radius / (1. - clearance_.tolerance()),
                      trial.curve)
        .tightened();
  }

  void assign(const std::vector<int>& side,
              int inside,
              std::vector<std::vector<Vector>>& curves,
              Flat_measures& measures) const {
    std::vector<std::size_t> chosen;
    for(std::size_t i = cycles_.size(); i-- > 0;)
      if(side[i] == inside)
        chosen.push_back(i); // the narrowest first
    std::vector<const Linking_row*> rows;
    for(std::size_t i : chosen)
      rows.push_back(&cycles_[i].row);
    const Paired_cycles paired(rows, lengths_, 2);
    std::vector<double> others; // the largest radii first, as cycles are in that order
    for(std::size_t k = 0; k < side.size(); ++k)
      if(side[k] == 1 - inside)
        others.push_back(trials_[k].radius);
    for(std::size_t k = 0; k < chosen.size(); ++k)
      if(const Index pair = paired.partners()[k]; pair != no_index) {
        const double most = most_beside(others, chosen.size() - k),
                     least = trials_[chosen[k]].radius;
        auto& ball = inside != 0 ? measures.pairs[pair].inside : measures.pairs[pair].outside;
        ball = Flat_ball{0.5 * (most + least), 0.5 * (most - least), std::move(curves[chosen[k]])};
      }
  }

  // The radius of the rank-th cycle on a side at most: just above it there is no place for so many,
  // beside those that are known to be on the other side.
  double most_beside(const std::vector<double>& others, std::size_t rank) const {
    const auto wider = [&](double radius) {
      return static_cast<std::size_t>(
          std::partition_point(others.begin(), others.end(),
                               [&](double other) { return other > radius; }) -
          others.begin());
    };
    std::size_t i = most_.size() - 1;
    while(i > 0 && i >= wider(most_[i]) + rank)
      --i;
    return most_[i];
  }

  Execution execution_;
  Face_tree faces_;
  Clearance clearance_;
  Wall wall_;
  Surface_points points_;
  std::vector<Surface_points::Request> requests_;
  std::vector<std::vector<Vector>> loops_;
  std::vector<double> lengths_; // by loop
  Cap_bounds caps_;
  std::vector<double> most_; // by cycle, its radius at most
  Linked_segments linked_;
  Cycle_trials tries_;
  std::size_t places_;            // of vertices
  std::size_t number_ = 0;        // of the widest cycles that are looked for among points
  int rounds_ = 0;                // after which bounds did not agree
  int effort_ = 0;                // rounds in which little was added
  double area_ = 0., sides_ = 0.; // of all faces
  Box<3> box_;
  std::vector<Widest_cycle> cycles_;
  std::vector<Cycle_trial> trials_; // by cycle
  std::vector<Leak> leaks_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_HANDLE_MEASURER_H
