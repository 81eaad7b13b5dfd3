// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NARROW_BAND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NARROW_BAND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/phase_field.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// No wall anywhere.
struct No_walls
{
  static bool may_have_wall(Index) { return false; }
  static bool is_wall(Index, Index) { return false; }
};

/*!
The single-layer field in a narrow band: explicit Euler steps on the vertices where the field may
change, and the time at which each vertex was reached.

A vertex counts as reached when its value has passed the threshold *and* a neighbour was reached in
an earlier step. Hence every vertex that is no source has an earlier neighbour, and the arrival time
has no minimum but the sources: the count of handles rests on that alone.

The object can be used again and again; `reset()` costs as much as the region that was touched.
*/
class Narrow_band
{
public:
  Narrow_band(const Flat_mesh& mesh, const std::vector<float>& speed, const Step_coefficients& k)
    : mesh_(mesh)
    , speed_(speed)
    , coefficients_(k)
    , value_(mesh.number_of_vertices(), 0.f)
    , time_(mesh.number_of_vertices(), never)
    , is_active_(mesh.number_of_vertices(), 0) {}

  /// makes `v` a source: its value is one for ever.
  template <typename Walls> void add_source(Index v, Time time, const Walls& walls)
  {
    if(value_[v] == 1.f)
      return;
    if(!is_active_[v])
      touch(v);
    is_active_[v] = 2; // no longer updated, even if it is in the band already
    value_[v] = 1.f;
    time_[v] = time;
    ++number_of_reached_;
    sources_.push_back(v);
    (void)walls;
  }

  /// to be called after the last source was added.
  template <typename Walls> void start(const Walls& walls)
  {
    for(Index v : sources_)
      activate_neighbors(v, walls);
    sources_.clear();
  }

  /// makes one step and calls `reached(v)` for each vertex that was reached in it. Returns false
  /// if there is nothing left to update.
  template <typename Walls, typename Reached> bool step(const Walls& walls, const Reached& reached)
  {
    if(band_.empty())
      return false;
    ++step_;
    compute(walls);
    const std::size_t reached_before = number_of_reached_;
    commit(walls, reached);
    if(number_of_reached_ != reached_before)
      last_progress_ = step_;
    else if(step_ - last_progress_ > patience)
      push_on(walls, reached);
    return true;
  }

  Time time(Index v) const { return time_[v]; }
  std::vector<Time>& times() { return time_; }
  std::size_t number_of_reached() const { return number_of_reached_; }
  std::size_t number_of_updates() const { return number_of_updates_; }
  Time number_of_steps() const { return step_; }

  void reset()
  {
    for(Index v : touched_) {
      value_[v] = 0.f;
      time_[v] = never;
      is_active_[v] = 0;
    }
    touched_.clear();
    band_.clear();
    sources_.clear();
    step_ = last_progress_ = 0;
    number_of_reached_ = 0;
  }

private:
  // A front that moves at all passes a vertex in far fewer steps.
  static constexpr Time patience = 64;

  void touch(Index v)
  {
    is_active_[v] = 1;
    touched_.push_back(v);
  }

  template <typename Walls> void activate_neighbors(Index v, const Walls& walls)
  {
    const bool near_wall = walls.may_have_wall(v);
    for(Index u : mesh_.ring(v))
      if(!is_active_[u] && !(near_wall && walls.is_wall(v, u))) {
        touch(u);
        band_.push_back(u);
      }
  }

  template <typename Walls> float mean_of_neighbors(Index v, const Walls& walls) const
  {
    const Ring ring = mesh_.ring(v);
    float sum = 0.f;
    if(!walls.may_have_wall(v)) {
      for(Index u : ring)
        sum += value_[u];
      return sum / static_cast<float>(ring.size());
    }
    int count = 0;
    for(Index u : ring)
      if(!walls.is_wall(v, u)) {
        sum += value_[u];
        ++count;
      }
    return count == 0 ? 0.f : sum / static_cast<float>(count);
  }

  template <typename Walls> void compute(const Walls& walls)
  {
    next_.resize(band_.size());
    number_of_updates_ += band_.size();
    for(std::size_t i = 0; i < band_.size(); ++i) {
      const Index v = band_[i];
      next_[i] = stepped_value(value_[v], mean_of_neighbors(v, walls), speed_[v], coefficients_);
    }
  }

  template <typename Walls, typename Reached>
  void commit(const Walls& walls, const Reached& reached)
  {
    const std::size_t size = band_.size();
    std::size_t kept = 0;
    for(std::size_t i = 0; i < size; ++i) {
      const Index v = band_[i];
      if(is_active_[v] == 2)
        continue;
      const float before = value_[v], after = next_[i];
      value_[v] = after;
      if(after >= front_threshold && time_[v] == never && has_earlier_neighbor(v, walls)) {
        time_[v] = crossing_time(before, after, step_);
        ++number_of_reached_;
        reached(v);
      }
      if(before == 0.f && after > 0.f)
        activate_neighbors(v, walls);
      if(after < 1.f || time_[v] == never)
        band_[kept++] = v;
    }
    // What was activated meanwhile stands behind the old band.
    kept = std::copy(band_.begin() + size, band_.end(), band_.begin() + kept) - band_.begin();
    band_.resize(kept);
  }

  template <typename Walls> bool has_earlier_neighbor(Index v, const Walls& walls) const
  {
    const Time now = (step_ - 1) * ticks_per_step;
    const bool near_wall = walls.may_have_wall(v);
    for(Index u : mesh_.ring(v))
      if(time_[u] <= now && !(near_wall && walls.is_wall(v, u)))
        return true;
    return false;
  }

  // On a mesh that is coarser than the front is wide, the front can come to rest: a vertex of high
  // degree with one reached neighbour, say. Then all that it touches is declared reached.
  template <typename Walls, typename Reached>
  void push_on(const Walls& walls, const Reached& reached)
  {
    ++step_;
    last_progress_ = step_;
    const std::vector<Index> band = band_;
    for(Index v : band)
      if(time_[v] == never && has_earlier_neighbor(v, walls)) {
        time_[v] = step_ * ticks_per_step;
        ++number_of_reached_;
        if(value_[v] == 0.f)
          activate_neighbors(v, walls);
        value_[v] = 1.f;
        is_active_[v] = 2;
        reached(v);
      }
  }

  const Flat_mesh& mesh_;
  const std::vector<float>& speed_;
  Step_coefficients coefficients_;
  std::vector<float> value_;
  std::vector<Time> time_;
  std::vector<std::uint8_t> is_active_;
  std::vector<Index> band_;
  std::vector<Index> sources_;
  std::vector<Index> touched_;
  std::vector<float> next_;
  Time step_ = 0;
  Time last_progress_ = 0;
  std::size_t number_of_reached_ = 0;
  std::size_t number_of_updates_ = 0;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NARROW_BAND_H
