// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_ARRIVALS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_ARRIVALS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::reference {

/// A vertex passes when the field, one minus the base layer, comes to this value.
constexpr double threshold = 0.5;

/// Edges that may not be crossed, by position in `Flat_mesh::neighbor`.
using Barred_edges = std::vector<char>;

inline std::size_t slot(const Flat_mesh& mesh, Index u, Index w) {
  CGAL_precondition_msg(mesh.ring(u).position(w) < mesh.ring(u).size(), "they are neighbors");
  return mesh.row_begin[u] + mesh.ring(u).position(w);
}

/*!
The order in which a field reaches the vertices.

A vertex is reached when it has passed the threshold and a neighbor has been reached. Several
vertices may pass in one step of the field; each has its moment in the step, by linear
interpolation, and they are reached in the order of these moments, later ones waiting for a neighbor
where they have to. So the reached vertices are connected at any time, and the sources are the only
minima of the order.
*/
class Arrivals
{
public:
  explicit Arrivals(const Flat_mesh& mesh, const Barred_edges& walls = Barred_edges())
      : mesh_(mesh)
      , walls_(walls)
      , time_(mesh.number_of_vertices(), (std::numeric_limits<double>::max)())
      , rank_(mesh.number_of_vertices(), no_index) {}

  bool is_reached(Index v) const { return rank_[v] != no_index; }

  /// the place of `v` in the order.
  Index rank(Index v) const { return rank_[v]; }

  /// the moment at which `v` was reached, in steps.
  double time(Index v) const { return time_[v]; }

  /// the same of all vertices.
  const std::vector<double>& times() const { return time_; }

  std::size_t number_of_reached() const { return count_; }
  std::size_t number_of_steps() const { return step_; }

  /// the number of vertices that passed the threshold in a step in which the front did not come to
  /// them.
  std::size_t number_of_early_vertices() const { return early_; }

  bool is_wall(Index u, Index i) const { return !walls_.empty() && walls_[mesh_.row_begin[u] + i]; }

  /// `v` is reached, now and whatever its value.
  void reach(Index v) { reach(v, static_cast<double>(step_)); }

  /// compares the values before and after a step, and calls `reached(v)` for each vertex that is
  /// reached in it, in order.
  template <typename Values, typename Reached>
  void advance(const Values& before, const Values& after, const Reached& reached) {
    ++step_;
    const auto push = [&](Index v, double earliest) {
      if(!is_reached(v) && after[v] >= threshold)
        queue_.emplace((std::max)(earliest, moment(before[v], after[v])), v);
    };
    for(Index v = 0; v < rank_.size(); ++v)
      if(!is_reached(v) && after[v] >= threshold && has_reached_neighbor(v))
        push(v, 0.);
    while(!queue_.empty()) {
      const auto [late, v] = queue_.top();
      queue_.pop();
      if(is_reached(v))
        continue;
      reach(v, static_cast<double>(step_ - 1) + late);
      reached(v);
      const Ring ring = mesh_.ring(v);
      for(Index i = 0; i < ring.size(); ++i)
        if(!is_wall(v, i))
          push(ring[i], late);
    }
    for(Index v = 0; v < rank_.size(); ++v)
      early_ += !is_reached(v) && before[v] < threshold && after[v] >= threshold;
  }

  /// reaches all vertices beside reached ones, whatever their values, the largest first.
  template <typename Values, typename Reached>
  void push_on(const Values& values, const Reached& reached) {
    std::vector<Index> next;
    for(Index v = 0; v < rank_.size(); ++v)
      if(!is_reached(v) && has_reached_neighbor(v))
        next.push_back(v);
    std::stable_sort(next.begin(), next.end(),
                     [&](Index u, Index v) { return values[u] > values[v]; });
    for(const Index v : next) {
      reach(v);
      reached(v);
    }
  }

  bool has_reached_neighbor(Index v) const {
    const Ring ring = mesh_.ring(v);
    for(Index i = 0; i < ring.size(); ++i)
      if(is_reached(ring[i]) && !is_wall(v, i))
        return true;
    return false;
  }

private:
  using Moment = std::pair<double, Index>;

  static double moment(double before, double after) {
    return before < threshold ? (threshold - before) / (after - before) : 0.;
  }

  void reach(Index v, double time) {
    CGAL_precondition_msg(!is_reached(v), "a vertex is reached once");
    time_[v] = time;
    rank_[v] = static_cast<Index>(count_++);
  }

  const Flat_mesh& mesh_;
  Barred_edges walls_;
  std::vector<double> time_;
  std::vector<Index> rank_;
  std::priority_queue<Moment, std::vector<Moment>, std::greater<>> queue_;
  std::size_t count_ = 0, step_ = 0, early_ = 0;
};

/// is called where a field to the letter does not come on; no rule of the paper says what to do
/// then.
[[noreturn]] inline void fail_at_rest(std::size_t number_of_covered, std::size_t number) {
  throw Literal_failure_exception("the field came to rest when " +
                                  std::to_string(number_of_covered) + " of " +
                                  std::to_string(number) + " vertices were covered");
}

} // namespace CGAL::Handle_tunnel_loops::internal::reference

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_ARRIVALS_H
