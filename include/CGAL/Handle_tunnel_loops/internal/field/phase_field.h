// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_PHASE_FIELD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_PHASE_FIELD_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

#include <cfloat>
#include <cmath>
#include <cstdint>
#include <stdexcept>

/// \file phase_field.h
/// The formulas of the field at one vertex, for host and device alike.

namespace CGAL::Handle_tunnel_loops::internal {

/// A vertex is reached when its value passes this threshold.
constexpr float front_threshold = 0.5f;

/// The coefficients of one explicit Euler step of the single-layer equation
/// dphi/dt = (mu/2) [ a^2 L phi + e sqrt(phi (1 - phi)) - w (1 - 2 phi) ],
/// with L phi = 4 (mean of the neighbours - phi), which is the Laplacian in local edge lengths.
struct Step_coefficients
{
  float diffusion;
  float drive;
  float penalty;
  float settled = 1.f;  ///< a value that comes so far is set to one
  float slowness = 1.f; ///< so many steps are as much time as one of the largest
  /// When no vertex was reached for more than so many steps, the field is pushed on: a front that
  /// moves at all passes a vertex in far fewer steps.
  std::uint32_t patience = 64;
};

/// No step is smaller: what a value changes by has to be large against its rounding, and the steps
/// of a field have to be numbers of 25 bits.
constexpr double smallest_step = 1. / 1024.;

/// how many steps are as much time as so many of the largest.
inline std::uint32_t steps_of(std::uint32_t number_of_largest_steps, const Step_coefficients& k) {
  return static_cast<std::uint32_t>(
      std::ceil(static_cast<double>(number_of_largest_steps) * k.slowness));
}

/// The largest stable step makes the new value a mean of the neighbours, diffusion = 1.
inline Step_coefficients step_coefficients(const Field_constants& c) {
  const double largest_step = 1. / (0.5 * c.mobility * 4. * c.gradient_coefficient);
  const double factor = c.step * largest_step * 0.5 * c.mobility;
  Step_coefficients k = {static_cast<float>(factor * 4. * c.gradient_coefficient),
                         static_cast<float>(factor * c.driving_force),
                         static_cast<float>(factor * c.penalty)};
  k.slowness = static_cast<float>(1. / c.step);
  k.patience = steps_of(k.patience, k);
  return k;
}

/// The coefficients for the loop passes, which need the way that a front takes, not its profile: a
/// value that has come so far behind the front is updated no more.
inline Step_coefficients coefficients_for_searching(Step_coefficients k) {
  k.settled = 0.8f;
  return k;
}

/// the mean of at most eight neighbours, from the reciprocal of their number: `value(i)` is the
/// value of neighbour i, and zero where there is none.
template <typename Value>
CGAL_HTL_HOST_DEVICE float stencil_mean(float weight, const Value& value) {
  return rounded_product(weight, ((value(0) + value(1)) + (value(2) + value(3))) +
                                     ((value(4) + value(5)) + (value(6) + value(7))));
}

/// What is summed of vertices with many neighbours: values as whole numbers, whose sum is the same
/// in any order. So it can be kept, and changed where a value changes.
CGAL_HTL_HOST_DEVICE inline std::uint64_t whole_value(float value) {
  return static_cast<std::uint64_t>(value * 0x1p32f);
}

/// the mean of so many values, from their sum.
CGAL_HTL_HOST_DEVICE inline float mean_of_whole_values(std::uint64_t sum, Index number) {
  return static_cast<float>(static_cast<double>(sum) / (static_cast<double>(number) * 0x1p32));
}

/// the value after one step.
CGAL_HTL_HOST_DEVICE inline float
stepped_value(float phi, float mean_of_neighbors, const Step_coefficients& k) {
  const float change = rounded_product(k.diffusion, mean_of_neighbors - phi) +
                       rounded_product(k.drive, std::sqrt(phi * (1.f - phi))) -
                       rounded_product(k.penalty, 1.f - 2.f * phi);
  const float value = phi + change;
  const float positive = value > 0.f ? value : 0.f; // in this form it compiles to no branch
  return positive < k.settled ? positive : 1.f;
}

/// Arrival times are integers, so that their order is exact however long a run is.
using Time = std::uint32_t;
constexpr Time never = 0xffffffffu;
constexpr Time ticks_per_step = 128;

/// A vertex may not pass the threshold before a neighbour has; it stays at this value.
constexpr float just_below_threshold = 0.499f;

/// the moment, after `step - 1` and at the latest at `step`, at which the value passed the
/// threshold.
CGAL_HTL_HOST_DEVICE inline Time crossing_time(float before, float after, Time step) {
  const float late = before < front_threshold ? (after - front_threshold) / (after - before) : 1.f;
  return step * ticks_per_step - static_cast<Time>(late * (ticks_per_step - 2));
}

/// the step of a moment that `crossing_time()` gives; 0 for the sources, which are there before.
CGAL_HTL_HOST_DEVICE inline Time step_of(Time time) {
  return (time + (ticks_per_step - 2)) / ticks_per_step;
}

/// the order in which vertices are reached: by time, ties by number.
CGAL_HTL_HOST_DEVICE inline std::uint64_t arrival_key(Time time, std::uint32_t v) {
  return std::uint64_t(time) << 32 | v;
}

/// the earlier neighbour of `v` down the steepest edge, among those that are allowed; `v` itself if
/// there is none. To follow the earliest neighbour instead would drift along the longer edges, and
/// wind around the loop from which the field came.
template <typename Mesh, typename Time_of, typename Is_allowed>
CGAL_HTL_HOST_DEVICE Index
steepest_descent(const Mesh& mesh, Index v, const Time_of& time, const Is_allowed& is_allowed) {
  const Ring ring = mesh.ring(v);
  const Time own_time = time(v);
  Index next = v;
  double steepest = 0.;
  for(Index begin = 0; begin < ring.size(); begin += stencil_width) {
    Time times[stencil_width]; // asked for before any of them is looked at
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i)
      times[i] = begin + i < ring.size() ? time(ring[begin + i]) : never;
    CGAL_HTL_UNROLL
    for(Index i = 0; i < stencil_width; ++i) {
      if(times[i] >= own_time || !is_allowed(ring[begin + i]))
        continue;
      const Index u = ring[begin + i];
      const double drop = own_time - times[i], distance = mesh.edge_length(u, v);
      const double slope = distance > 0. ? drop / distance : DBL_MAX;
      if(slope > steepest) {
        steepest = slope;
        next = u;
      }
    }
  }
  return next;
}

/// throws `std::invalid_argument` if no front would move with these constants, or too slowly.
inline void check_constants(const Field_constants& c) {
  const bool are_finite = std::isfinite(c.mobility) && std::isfinite(c.gradient_coefficient) &&
                          std::isfinite(c.penalty) && std::isfinite(c.driving_force);
  if(!(are_finite && c.mobility > 0. && c.gradient_coefficient > 0. && c.penalty > 0. &&
       c.driving_force > c.penalty))
    throw std::invalid_argument("the field's constants must be positive, and the driving force "
                                "must be larger than the penalty");
  if(!(c.step >= smallest_step && c.step <= 1.))
    throw std::invalid_argument("the field's time step must be in [1/1024, 1]");
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_PHASE_FIELD_H
