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
#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linked_segments.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Paired_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Surface_points.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Voronoi_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Widest_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/measure_handles.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <boost/math/constants/constants.hpp>

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

Points on the surface are no nearer to a ball than the surface is: so the widest cycles among the
points (`Widest_cycles`) are at least as wide as those of the surface, one by one, as long as no
cycle slips between points through a loop. That is one bound. The other is a cycle itself, if balls
of nearly its radius fit all along it (`Clearance`). Where one does not, points are too far apart:
more are taken there, and along the loops that it is linked with, as these bound what all such
cycles have to pass. So it goes on until the bounds agree.
*/
class Handle_measurer
{
public:
  Handle_measurer(Execution execution,
                  const Flat_mesh& mesh,
                  const std::vector<Vector>& places,
                  const std::vector<Polyline_pair>& pairs,
                  double precision)
      : execution_(execution)
      , gap_((std::min)(largest_gap, gap_of_precision * precision))
      , side_(std::sqrt(3. * gap_))
      , faces_(execution, mesh, span_of(places))
      , clearance_(faces_, gap_ / 12.)
      , wall_(mesh, span_of(places), faces_)
      , points_(execution, faces_)
      , loops_(loops_of(pairs))
      , linked_(execution, loops_)
      , finest_(loops_.size(), std::numeric_limits<double>::infinity()) {
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
    for(std::size_t l = 0; l < loops_.size(); ++l)
      refine_along(l, lengths_[l] / 12., 0.5);
    points_.refine(execution_, std::exchange(requests_, {}));
    const double number = double(most_at_first + places_);
    points_.refine_by_thickness(execution_, wall_, part_of_thickness,
                                (std::max)(std::sqrt(area_ / number), 0.1 * sides_ / number));
    points_.set_most(points_.points().size() + points_per_vertex * places_ + more_points);
    Voronoi_graph graph(box_.low, box_.high);
    std::size_t inserted = 0;
    std::size_t work = 0; // points of all rounds
    do {
      graph.insert(points_.points(), std::exchange(inserted, points_.points().size()));
      graph.build(execution_);
      find_cycles(graph);
      refine(inserted);
      work += inserted;
    } while(points_.points().size() > inserted && is_worth(work));
    return assign();
  }

private:
  static constexpr double gap_of_precision = 1.5, largest_gap = 0.3;
  static constexpr double part_of_thickness = 0.45, least_growth = 0.1;
  static constexpr std::size_t most_at_first = 20000;
  static constexpr int most_divisions = 5;
  static constexpr std::size_t work_per_vertex = 5, more_work = 400000;
  static constexpr std::size_t points_per_vertex = 3, more_points = 100000;

  /// A place at which a ball does not fit, and the distance of the points around, or less.
  struct Narrow_place
  {
    Vector place;
    double distance;
  };

  /// What became of a cycle.
  struct Trial
  {
    double radius = 0.;               ///< for which there is room all along
    std::vector<Free_ball> curve;     ///< along which such a ball goes
    bool is_wide = false;             ///< whether there is such a one
    std::vector<Narrow_place> narrow; ///< what was in the way of one that is as wide as may be
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

  // Points near a loop, which bounds where balls of a radius can pass; pieces of faces have sides
  // of this part of it.
  void refine_along(std::size_t loop, double radius, double part) {
    constexpr double reach = 1.2, least_gain = 0.9;
    if(part * radius > least_gain * finest_[loop])
      return;
    finest_[loop] = part * radius;
    for_each_place(loop, 0.5 * radius, [&](const Vector& p) {
      requests_.push_back({p, reach * radius, part * radius});
    });
    for_each_place(loop, part * radius, [&](const Vector& p) { points_.add(p); });
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
    return work < most ||
           (work < 2 * most &&
            std::any_of(trials_.begin(), trials_.end(), [](const Trial& t) { return !t.is_wide; }));
  }

  // More effort where little came of it.
  void refine(std::size_t before) {
    constexpr int most_effort = 8;
    do {
      refine();
      effort_ += points_.points().size() < (1. + least_growth) * double(before) ? 1 : 0;
    } while(points_.points().size() == before && is_any_narrow() && effort_ < most_effort);
  }

  bool is_any_narrow() const {
    return std::any_of(trials_.begin(), trials_.end(),
                       [](const Trial& trial) { return !trial.narrow.empty(); });
  }

  void refine() {
    for(std::size_t i = 0; i < cycles_.size(); ++i)
      if(!trials_[i].narrow.empty())
        refine_for(i);
    points_.refine(execution_, std::exchange(requests_, {}));
    if(!cycles_.empty())
      close_loops(1.9 * most_.back());
  }

  // So that no cycle slips through between points of a loop, as long as these are not too many.
  void close_loops(double distance) {
    const double all = std::accumulate(lengths_.begin(), lengths_.end(), 0.);
    const double least = all / static_cast<double>(places_ + more_points);
    for(std::size_t l = 0; l < loops_.size(); ++l)
      for_each_place(l, (std::max)(distance, least), [&](const Vector& p) { points_.add(p); });
  }

  // Along the loops, which tell where balls do not pass; where one nearly does; and where points
  // are passed. Denser, and farther around, the less came of it in the rounds before.
  void refine_for(std::size_t cycle) {
    const double part = side_ * std::pow(0.7, (std::min)(effort_, 4));
    for(const std::vector<Index>* loops : {&loop_of_, &loop_at_most_})
      if(const Index loop = (*loops)[cycle]; loop != no_index)
        refine_along(loop, (std::min)(most_[cycle], largest_radius(loop)), part);
    for(const std::vector<Narrow_place>* places : {&trials_[cycle].narrow, &leaks_[cycle]})
      refine_at(*places, most_[cycle], part);
  }

  void refine_at(const std::vector<Narrow_place>& places, double radius, double part) {
    constexpr double part_of_distance = 0.35, much = 1.5, wide_reach = 6., largest_side = 0.8;
    const double reach = 1.1 * std::pow(1.25, (std::min)(effort_, 4));
    for(const Narrow_place& n : places) {
      const bool is_tight = n.distance < much * radius;
      requests_.push_back(
          {n.place, reach * n.distance, is_tight ? part * radius : part_of_distance * n.distance});
      if(is_tight) // no ball of that radius is to slip through farther away, either
        requests_.push_back({n.place, wide_reach * reach * n.distance, largest_side * radius});
    }
  }

  // Of a ball that passes through a loop, unless that is far from plane.
  double largest_radius(std::size_t loop) const {
    return lengths_[loop] / boost::math::double_constants::two_pi;
  }

  // ---- cycles

  // The widest among the points tell how wide cycles are at most. Where one of them is not, others
  // are looked for that do not cross the surface, and are wide as that is seen.
  void find_cycles(Voronoi_graph& graph) {
    cycles_ = Widest_cycles(execution_, graph, linked_).find(loops_.size());
    most_.clear();
    for(const Widest_cycle& cycle : cycles_)
      most_.push_back(cycle.radius);
    trials_ = trials(cycles_);
    loop_at_most_ = loops_to_pass();
    leaks_.clear();
    for(const Trial& trial : trials_)
      leaks_.push_back(trial.narrow);
    const auto last = std::find_if(trials_.rbegin(), trials_.rend(),
                                   [](const Trial& trial) { return !trial.narrow.empty(); });
    if(last != trials_.rend()) {
      see_surface(graph, least_seen * most_[static_cast<std::size_t>(trials_.rend() - last) - 1]);
      std::vector<Widest_cycle> others =
          Widest_cycles(execution_, graph, linked_).find(loops_.size());
      if(others.size() == cycles_.size())
        take_wider_ones(std::move(others));
    }
    loop_of_ = loops_to_pass();
  }

  // Of the cycles and these, the ones that have most room and are independent.
  void take_wider_ones(std::vector<Widest_cycle> cycles) {
    std::vector<Trial> found = trials(cycles);
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
        judge(most_[cycles_.size()], cycles[i], found[i]);
        cycles_.push_back(std::move(cycles[i]));
        trials_.push_back(std::move(found[i]));
      }
  }

  // Whether a cycle is as wide as it may be, which may be another radius than was tried.
  void judge(double most, const Widest_cycle& cycle, Trial& trial) const {
    if(trial.is_wide && trial.radius >= (1. - gap_) * most)
      trial.narrow.clear();
    else if(trial.narrow.empty())
      trial.narrow.push_back({cycle.balls.front().place, cycle.balls.front().radius});
  }

  // A way between points that are far apart may lead through narrow ones, beside which there is
  // room.
  static constexpr double least_seen = 0.5;
  static constexpr double about = 0.97; // to choose by, clearances are known so well

  // Makes edges as narrow as the surface is seen from their ends, and leaves out those that cross
  // it. Those that are narrower than \p least stay as they are.
  void see_surface(Voronoi_graph& graph, double least) const {
    std::vector<double> clearance(graph.nodes.size(), 0.);
    for_each_index(
        execution_, graph.nodes.size(),
        [&](std::size_t i) {
          if(const Voronoi_graph::Node& n = graph.nodes[i]; n.radius >= least)
            clearance[i] = clearance_.at(n.place, n.radius, about);
        },
        256);
    for_each_index(
        execution_, graph.edges.size(),
        [&](std::size_t i) {
          if(Voronoi_graph::Edge& e = graph.edges[i]; e.radius >= least)
            e.radius *= static_cast<float>(seen_part(graph, e, clearance));
        },
        256);
  }

  double seen_part(const Voronoi_graph& graph,
                   const Voronoi_graph::Edge& edge,
                   const std::vector<double>& clearance) const {
    const auto [a, b] = edge.nodes;
    const Voronoi_graph::Node &n = graph.nodes[a], &m = graph.nodes[b];
    if(norm(n.place - m.place) >= about * (clearance[a] + clearance[b]) &&
       wall_.meets(n.place, m.place))
      return 0.;
    return (std::min)(clearance[a] / n.radius, clearance[b] / m.radius);
  }

  // For each cycle a loop of its own that it is linked with, for the narrow ones the short ones.
  // What is known of the ways there bounds them one by one.
  std::vector<Index> loops_to_pass() const {
    std::vector<const Linking_row*> rows;
    for(auto c = cycles_.rbegin(); c != cycles_.rend(); ++c)
      rows.push_back(&c->row);
    std::vector<Index> loops = Paired_cycles(rows, lengths_, 1).partners();
    std::reverse(loops.begin(), loops.end());
    return loops;
  }

  std::vector<Trial> trials(const std::vector<Widest_cycle>& cycles) const {
    std::vector<Trial> found(cycles.size());
    for_each_index(
        execution_, cycles.size(),
        [&](std::size_t i) { found[i] = trial(thinned(cycles[i]), most_[i]); }, 1);
    return found;
  }

  // A cycle without most of its balls: those left out, and the way to the next, are well in the
  // one before.
  static Widest_cycle thinned(const Widest_cycle& cycle) {
    constexpr double part = 0.5, most_part = 2.;
    Widest_cycle thin = {cycle.radius, cycle.row, {cycle.balls.front()}};
    for(std::size_t i = 1; i < cycle.balls.size(); ++i) {
      const auto& [last, radius] = thin.balls.back();
      const double step = (std::min)(part * radius, most_part * cycle.radius);
      const Vector &next = cycle.balls[i + 1 < cycle.balls.size() ? i + 1 : 0].place;
      if(norm(cycle.balls[i].place - last) > step || norm(next - last) > step)
        thin.balls.push_back(cycle.balls[i]);
    }
    return thin;
  }

  // The largest of some radii for which there is room.
  Trial trial(const Widest_cycle& cycle, double most) const {
    const auto try_part = [&](double part) {
      return try_radius(cycle, (1. - part * (gap_ - clearance_.tolerance())) * most, part == 1.);
    };
    for(const double part : {0.125, 0.25, 0.5})
      if(Trial trial = try_part(part); trial.is_wide)
        return trial;
    Trial best = try_part(1.);
    if(best.is_wide)
      return best;
    for(const double part : {2., 4., 8., 16., 32., 48.}) {
      if(part * gap_ >= 1.)
        break;
      Trial trial = try_part(part);
      if(trial.is_wide) {
        trial.narrow = std::move(best.narrow);
        return trial;
      }
    }
    return best;
  }

  // Places of the cycle where there is no room are moved to where there is. All that are narrow are
  // found, or none if that is not asked for.
  Trial try_radius(const Widest_cycle& cycle, double radius, bool is_all_asked_for) const {
    Trial trial;
    trial.radius = (1. - clearance_.tolerance()) * radius;
    const Voronoi_graph::Node* before = &cycle.balls.back();
    for(const Voronoi_graph::Node& ball : cycle.balls) {
      const auto free = clearance_.with_room(ball.place, radius);
      if(!free)
        add_narrow(ball.place, {before, &ball}, cycle, trial);
      else if(!trial.curve.empty())
        connect(*free, most_divisions, {before, &ball}, cycle, radius, trial);
      if(free)
        trial.curve.push_back(*free);
      if(!trial.narrow.empty() && !is_all_asked_for)
        return trial;
      before = &ball;
    }
    if(!trial.curve.empty()) {
      const Free_ball first = trial.curve.front();
      connect(first, most_divisions, {before, &cycle.balls.front()}, cycle, radius, trial);
    }
    if(trial.narrow.empty() && !is_of_class(trial.curve, cycle.row))
      trial.narrow.push_back({cycle.balls.front().place, cycle.radius});
    trial.is_wide = trial.narrow.empty();
    return trial;
  }

  using Edge = std::array<const Voronoi_graph::Node*, 2>;

  void connect(const Free_ball& to,
               int divisions,
               const Edge& edge,
               const Widest_cycle& cycle,
               double radius,
               Trial& trial) const {
    const auto narrow = clearance_.narrow_between(trial.curve.back(), to, radius);
    if(!narrow)
      return;
    const auto free = divisions > 0 ? clearance_.with_room(*narrow, radius) : std::nullopt;
    if(!free) {
      add_narrow(*narrow, edge, cycle, trial);
      return;
    }
    connect(*free, divisions - 1, edge, cycle, radius, trial);
    trial.curve.push_back(*free);
    connect(to, divisions - 1, edge, cycle, radius, trial);
  }

  // A place where there is no room, and the balls around: between points that are too far apart
  // they are too large.
  static void
  add_narrow(const Vector& p, const Edge& edge, const Widest_cycle& cycle, Trial& trial) {
    double distance = cycle.radius;
    for(const Voronoi_graph::Node* end : edge)
      distance = (std::max)(distance, end->radius - norm(p - end->place));
    add_narrow({p, distance}, trial);
    for(const Voronoi_graph::Node* end : edge)
      add_narrow({end->place, end->radius}, trial);
  }

  static void add_narrow(const Narrow_place& narrow, Trial& trial) {
    if(trial.narrow.empty() ||
       norm(narrow.place - trial.narrow.back().place) > 0.5 * narrow.distance)
      trial.narrow.push_back(narrow);
  }

  bool is_of_class(const std::vector<Free_ball>& curve, const Linking_row& wanted) const {
    Linking_row row;
    for(std::size_t i = 0; i < curve.size(); ++i)
      linked_.add(curve[i].place, curve[i + 1 < curve.size() ? i + 1 : 0].place, row);
    add_up(row);
    return row == wanted;
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
    return Ball_curve(clearance_, linked_, trials_[cycle].radius, trials_[cycle].curve).tightened();
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
    for(std::size_t k = 0; k < chosen.size(); ++k)
      if(const Index pair = paired.partners()[k]; pair != no_index) {
        const double most = most_on_side(side, inside, chosen.size() - k),
                     least = trials_[chosen[k]].radius;
        auto& ball = inside != 0 ? measures.pairs[pair].inside : measures.pairs[pair].outside;
        ball = Flat_ball{0.5 * (most + least), 0.5 * (most - least), std::move(curves[chosen[k]])};
      }
  }

  // The radius of the rank-th cycle on a side at most: just above it there is no place for so many,
  // beside those that are known to be on the other side.
  double most_on_side(const std::vector<int>& side, int inside, std::size_t rank) const {
    const auto others = [&](double radius) {
      std::size_t count = 0;
      for(std::size_t k = 0; k < side.size(); ++k)
        count += side[k] == 1 - inside && trials_[k].radius > radius ? 1 : 0;
      return count;
    };
    std::size_t i = most_.size() - 1;
    while(i > 0 && i >= others(most_[i]) + rank)
      --i;
    return most_[i];
  }

  Execution execution_;
  double gap_;  // that the bounds may have, as a part of the upper one
  double side_; // of pieces of faces, as a part of the radius
  Face_tree faces_;
  Clearance clearance_;
  Wall wall_;
  Surface_points points_;
  std::vector<Surface_points::Request> requests_;
  std::vector<std::vector<Vector>> loops_;
  std::vector<double> lengths_; // by loop
  Linked_segments linked_;
  std::vector<double> finest_; // by loop, sides of pieces around it
  std::size_t places_;
  int effort_ = 0;                // rounds in which little was added
  double area_ = 0., sides_ = 0.; // of all faces
  Box<3> box_;
  std::vector<Widest_cycle> cycles_;
  std::vector<double> most_;                     // by cycle, its radius at most
  std::vector<Index> loop_of_, loop_at_most_;    // by cycle, and by that of this radius
  std::vector<Trial> trials_;                    // by cycle
  std::vector<std::vector<Narrow_place>> leaks_; // of cycles that are wider than there is room
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_HANDLE_MEASURER_H
