// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_CYCLE_TRIALS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_CYCLE_TRIALS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linked_segments.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linking_rank.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Voronoi_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Widest_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A place at which a ball does not fit, and the distance of the points around, or less.
struct Narrow_place
{
  Vector place;
  double distance;
};

/// What became of a cycle.
struct Cycle_trial
{
  double radius = 0.;               ///< for which there is room all along
  std::vector<Free_ball> curve;     ///< along which such a ball goes
  bool is_wide = false;             ///< whether there is such a one
  std::vector<Narrow_place> narrow; ///< what was in the way of one that is as wide as may be
  bool is_leak_known = false;       ///< where wider ones slip through the surface
};

/// Balls that fit all along cycles, or beside them, where those among the points are too large.
class Cycle_trials
{
public:
  /// \p gap is how much less than as wide as may be a cycle may be, as a part of that.
  Cycle_trials(const Clearance& clearance, const Linked_segments& linked, double gap)
      : clearance_(clearance)
      , linked_(linked)
      , gap_(gap) {}

  /// the largest of some radii, up to \p most, for which there is room.
  Cycle_trial trial(const Widest_cycle& whole, double most) const {
    const Widest_cycle cycle = thinned(whole);
    constexpr int most_halvings = 2;
    const auto try_part = [&](double part) {
      return of_class(cycle, (1. - part * (gap_ - clearance_.tolerance())) * most, part == 1.);
    };
    for(const double part : {0.125, 0.25, 0.5})
      if(Cycle_trial trial = try_part(part); trial.is_wide)
        return trial;
    Cycle_trial best = try_part(1.);
    if(best.is_wide)
      return best;
    for(const double part : {2., 4., 8., 16., 32., 48.}) {
      if(part * gap_ >= 1.)
        break;
      Cycle_trial trial = try_part(part);
      if(!trial.is_wide)
        continue;
      for(double low = 0.5 * part, high = part, step = 0.; step < most_halvings; ++step) {
        const double middle = 0.5 * (low + high);
        Cycle_trial larger = try_part(middle);
        (larger.is_wide ? high : low) = middle;
        if(larger.is_wide)
          trial = std::move(larger);
      }
      trial.narrow = std::move(best.narrow);
      return trial;
    }
    return best;
  }

  /// whether balls of a radius fit along a closed walk. Places where there is no room are moved to
  /// where there is: by that, it may get into another class. All that are narrow are found, or one
  /// if not all are asked for.
  Cycle_trial along(const Widest_cycle& cycle, double radius, bool is_all_asked_for) const {
    Cycle_trial trial;
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
    trial.is_wide = trial.narrow.empty();
    return trial;
  }

  Linking_row row_of(const std::vector<Free_ball>& curve) const {
    Linking_row row;
    for(std::size_t i = 0; i < curve.size(); ++i)
      linked_.add(curve[i].place, curve[i + 1 < curve.size() ? i + 1 : 0].place, row);
    add_up(row);
    return row;
  }

private:
  static constexpr int most_divisions = 5;

  // A cycle without most of its balls: those left out, and the way to the next, are well in the
  // one before.
  static Widest_cycle thinned(const Widest_cycle& cycle) {
    constexpr double part = 0.5, most_part = 2.;
    Widest_cycle thin = {cycle.radius, cycle.row, {cycle.balls.front()}};
    for(std::size_t i = 1; i < cycle.balls.size(); ++i) {
      const auto& [last, radius] = thin.balls.back();
      const double step = (std::min)(part * radius, most_part * cycle.radius);
      const Vector& next = cycle.balls[i + 1 < cycle.balls.size() ? i + 1 : 0].place;
      if(norm(cycle.balls[i].place - last) > step || norm(next - last) > step)
        thin.balls.push_back(cycle.balls[i]);
    }
    return thin;
  }

  Cycle_trial of_class(const Widest_cycle& cycle, double radius, bool is_all_asked_for) const {
    Cycle_trial trial = along(cycle, radius, is_all_asked_for);
    if(trial.is_wide && row_of(trial.curve) != cycle.row) {
      trial.is_wide = false;
      trial.narrow.push_back({cycle.balls.front().place, cycle.radius});
    }
    return trial;
  }

  using Edge = std::array<const Voronoi_graph::Node*, 2>;

  void connect(const Free_ball& to,
               int divisions,
               const Edge& edge,
               const Widest_cycle& cycle,
               double radius,
               Cycle_trial& trial) const {
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
  add_narrow(const Vector& p, const Edge& edge, const Widest_cycle& cycle, Cycle_trial& trial) {
    double distance = cycle.radius;
    for(const Voronoi_graph::Node* end : edge)
      distance = (std::max)(distance, end->radius - norm(p - end->place));
    add_narrow({p, distance}, trial);
    for(const Voronoi_graph::Node* end : edge)
      add_narrow({end->place, end->radius}, trial);
  }

  static void add_narrow(const Narrow_place& narrow, Cycle_trial& trial) {
    if(trial.narrow.empty() ||
       norm(narrow.place - trial.narrow.back().place) > 0.5 * narrow.distance)
      trial.narrow.push_back(narrow);
  }

  const Clearance& clearance_;
  const Linked_segments& linked_;
  double gap_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_CYCLE_TRIALS_H
