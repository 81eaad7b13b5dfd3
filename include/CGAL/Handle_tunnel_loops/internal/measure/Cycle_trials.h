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

#include <CGAL/Handle_tunnel_loops/internal/measure/Ball_network.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linked_segments.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linking_rank.h>
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

/// Where a way is narrow: a place, and a direction across the narrowest section there.
struct Throat_of_way
{
  Vector place, normal;
};

/// What became of a cycle.
struct Cycle_trial
{
  double radius = 0.;                  ///< for which there is room all along
  std::vector<Free_ball> curve;        ///< along which such a ball goes
  bool is_wide = false;                ///< whether there is such a one
  std::vector<Narrow_place> narrow;    ///< what was in the way of one that is as wide as may be
  std::optional<Throat_of_way> throat; ///< where a wider one did not pass
  bool is_leak_known = false;          ///< where wider ones slip through the surface
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
      return of_class(cycle, (1. - part * (gap_ - clearance_.tolerance())) * most,
                      part == 1. ? Places::JUDGE : Places::KEEP);
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

  /// What is done with the places of a walk.
  enum class Places {
    KEEP,   ///< those where there is room; the first that is narrow is found
    SPREAD, ///< they are moved to where there is more room than is needed
    JUDGE   ///< all that are narrow are found
  };

  /// whether balls of a radius fit along a closed walk. Places where there is no room are moved to
  /// where there is, or left out: by that, it may get into another class.
  Cycle_trial along(const Widest_cycle& cycle, double radius, Places places) const {
    Attempt attempt = {cycle, radius, places, {}};
    Cycle_trial& trial = attempt.trial;
    trial.radius = (1. - clearance_.tolerance()) * radius;
    const Ball_network::Node* before = nullptr;
    for(std::size_t i = 0; i < cycle.balls.size(); ++i) {
      const Ball_network::Node& ball = cycle.balls[i];
      if(attempt.is_over())
        return trial;
      const Vector& next = cycle.balls[i + 1 < cycle.balls.size() ? i + 1 : 0].place;
      if(places == Places::SPREAD && !trial.curve.empty() &&
         are_well_within(trial.curve.back(), ball.place, next))
        continue;
      if(const auto free = places == Places::SPREAD ? clearance_.with_more_room(ball.place, radius)
                                                    : clearance_.with_room(ball.place, radius))
      {
        if(before != nullptr)
          connect(*free, most_divisions, {before, &ball}, attempt);
        trial.curve.push_back(*free);
        before = &ball;
      } else if(places == Places::JUDGE)
        add_narrow(ball.place, {&ball, &ball}, cycle, trial);
    }
    const Ball_network::Node& first = cycle.balls.front();
    if(trial.curve.empty()) {
      add_narrow(first.place, {&first, &first}, cycle, trial);
      if(cycle.balls.size() > 1) {
        const Vector way = cycle.balls[1].place - first.place;
        trial.throat = throat(clearance_.uphill_across(way, first.place, radius), way);
      }
    } else
      connect(Free_ball(trial.curve.front()), most_divisions, {before, &first}, attempt);
    trial.is_wide = trial.narrow.empty();
    return trial;
  }

  /// moves a cycle by and by to where there is more room, up to a radius. It stays in its class.
  Cycle_trial widened(Cycle_trial trial, const Linking_row& row, double most) const {
    constexpr double first_growth = 0.5;
    const double least_growth = 0.25 * gap_,
                 enough = (1. - 0.25 * (gap_ - clearance_.tolerance())) * most;
    double known = trial.radius;
    for(double growth = enough / known - 1.; growth > least_growth && known < enough;) {
      const double radius = (std::min)((1. + growth) * known, enough);
      Cycle_trial wider = of_class(thinned(cycle_along(trial, row)), radius, Places::SPREAD);
      if(wider.is_wide) {
        known = radius;
        trial.radius = wider.radius;
        trial.curve = std::move(wider.curve);
      } else {
        growth = (std::min)(first_growth, 0.5 * growth);
        trial.throat = wider.throat ? wider.throat : trial.throat;
      }
    }
    return trial;
  }

  /// the curve of a trial.
  static Widest_cycle cycle_along(const Cycle_trial& trial, const Linking_row& row) {
    Widest_cycle cycle = {trial.radius, row, {}};
    for(const Free_ball& ball : trial.curve)
      cycle.balls.push_back({ball.place, ball.radius});
    return cycle;
  }

  Linking_row row_of(const std::vector<Free_ball>& curve) const {
    Linking_row row;
    for(std::size_t i = 0; i < curve.size(); ++i)
      linked_.add(curve[i].place, curve[i + 1 < curve.size() ? i + 1 : 0].place, row);
    add_up(row);
    return row;
  }

private:
  static constexpr int most_divisions = 8;

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

  Cycle_trial of_class(const Widest_cycle& cycle, double radius, Places places) const {
    Cycle_trial trial = along(cycle, radius, places);
    if(trial.is_wide && row_of(trial.curve) != cycle.row) {
      trial.is_wide = false;
      trial.narrow.push_back({cycle.balls.front().place, cycle.radius});
    }
    return trial;
  }

  using Edge = std::array<const Ball_network::Node*, 2>;

  struct Attempt
  {
    const Widest_cycle& cycle;
    double radius;
    Places places;
    Cycle_trial trial;

    bool is_over() const { return places != Places::JUDGE && !trial.narrow.empty(); }
  };

  void connect(const Free_ball& to, int divisions, const Edge& edge, Attempt& attempt) const {
    Cycle_trial& trial = attempt.trial;
    if(attempt.is_over())
      return;
    const auto narrow = clearance_.narrow_between(trial.curve.back(), to, attempt.radius);
    if(!narrow)
      return;
    const auto free = divisions > 0 ? between(*narrow, to, attempt.radius, trial) : std::nullopt;
    if(!free) {
      add_narrow(*narrow, edge, attempt.cycle, trial);
      return;
    }
    connect(*free, divisions - 1, edge, attempt);
    trial.curve.push_back(*free);
    connect(to, divisions - 1, edge, attempt);
  }

  // A ball beside a place between the last one and another, in the plane between these if there is
  // room. If there is none, that is a throat.
  std::optional<Free_ball>
  between(const Vector& place, const Free_ball& to, double radius, Cycle_trial& trial) const {
    const Vector way = to.place - trial.curve.back().place;
    const Clearance::Ridge ridge = clearance_.uphill_across(way, place, radius);
    if(ridge.room >= radius)
      return Free_ball{ridge.place, ridge.room};
    const auto free = clearance_.with_room(place, radius);
    if(!free && !trial.throat)
      trial.throat = throat(ridge, way);
    return free;
  }

  // The narrowest section is about that through the places that are near.
  static Throat_of_way throat(const Clearance::Ridge& ridge, const Vector& way) {
    constexpr double apart = 0.3, least_slope = 0.3;
    std::array<Vector, 2> axes;
    std::size_t size = 0;
    const auto flattened = [&](Vector v) {
      for(std::size_t k = 0; k < size; ++k)
        v = v - dot(v, axes[k]) * axes[k];
      return v;
    };
    for(std::size_t i = 1; i < ridge.size && size < axes.size(); ++i)
      if(const Vector axis = flattened(ridge.touched[i] - ridge.touched[0]);
         norm(axis) > apart * ridge.room)
        axes[size++] = unit(axis);
    const Vector normal = flattened(way);
    return {ridge.place, norm(normal) > least_slope * norm(way) ? normal : way};
  }

  // A place where there is no room, and the balls around: between points that are too far apart
  // they are too large.
  static void
  add_narrow(const Vector& p, const Edge& edge, const Widest_cycle& cycle, Cycle_trial& trial) {
    double distance = cycle.radius;
    for(const Ball_network::Node* end : edge)
      distance = (std::max)(distance, end->radius - norm(p - end->place));
    add_narrow({p, distance}, trial);
    for(const Ball_network::Node* end : edge)
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
