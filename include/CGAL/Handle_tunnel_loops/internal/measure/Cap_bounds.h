// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_CAP_BOUNDS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_CAP_BOUNDS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Cycle_trials.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Linking_rank.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Plane_section.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Room_in_caps.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/Widest_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
How wide independent cycles are at most, by caps: of the loops, and across narrow places of cycles
that are known.

Those that are wider than the room in a cap pass it 0 times in sum. So beside n caps that are
independent, as numbers of passages of cycles tell, there are only as many independent cycles wider
than all of these as there are others: of caps with least room (a greedy choice, as in a matroid)
the k-th largest bounds the k-th widest cycle.
*/
class Cap_bounds
{
public:
  /// \p tolerance is how much less a bound might be, as a part.
  Cap_bounds(Execution execution,
             const Face_tree& faces,
             const Clearance& clearance,
             Span<const Vector> points,
             const std::vector<std::vector<Vector>>& loops,
             double tolerance)
      : execution_(execution)
      , faces_(faces)
      , points_(points)
      , room_(faces, clearance, tolerance)
      , of_loop_(loops.size()) {
    for_each_index(
        execution, loops.size(), [&](std::size_t l) { of_loop_[l] = room_.of_loop(loops[l]); }, 1);
    most_ = of_loop_;
    std::sort(most_.begin(), most_.end(), std::greater<>());
  }

  /// the largest first.
  const std::vector<double>& most() const { return most_; }

  double of_loop(Index loop) const { return of_loop_[loop]; }

  /// of a cycle alone, by the loops through which it is led.
  double of_cycle(const Linking_row& row) const {
    double least = most_.front();
    for(const auto& [loop, number] : row)
      least = (std::min)(least, of_loop_[loop]);
    return least;
  }

  /// adds caps across throats of cycles that are less wide than a part of what is known alone, and
  /// forgets these throats.
  void add_sections(double part,
                    const std::vector<Widest_cycle>& cycles,
                    std::vector<Cycle_trial>& trials) {
    std::vector<Section_cap> found(trials.size());
    for_each_index(
        execution_, trials.size(),
        [&](std::size_t i) {
          const double known = of_cycle(cycles[i].row);
          if(const auto throat = std::exchange(trials[i].throat, std::nullopt);
             throat && trials[i].radius < part * known)
            found[i] = section(*throat, known);
        },
        1);
    for(Section_cap& cap : found)
      if(cap.section)
        sections_.push_back(std::move(cap));
    find_most(cycles, trials);
  }

private:
  struct Section_cap
  {
    double radius = 0.;
    std::unique_ptr<Plane_section> section;
  };

  struct Cap
  {
    double radius;
    Linking_row row; // by cycle
  };

  Section_cap section(const Throat_of_way& throat, double known) const {
    auto section = std::make_unique<Plane_section>(faces_, points_, throat.place, throat.normal);
    if(section->triangles().empty())
      return {};
    const double radius = room_.of_triangles(section->triangles(), known);
    return radius < known ? Section_cap{radius, std::move(section)} : Section_cap{};
  }

  void find_most(const std::vector<Widest_cycle>& cycles, const std::vector<Cycle_trial>& trials) {
    std::vector<Cap> caps;
    for(const double radius : of_loop_)
      caps.push_back({radius, {}});
    for(const Section_cap& cap : sections_)
      caps.push_back({cap.radius, {}});
    for(Index j = 0; j < cycles.size(); ++j) {
      if(!trials[j].is_wide) // what passes sections is its curve
        continue;
      for(const auto& [loop, number] : cycles[j].row)
        caps[loop].row.emplace_back(j, number);
      for(std::size_t s = 0; s < sections_.size(); ++s)
        if(const int number = sections_[s].section->passages(trials[j].curve); number != 0)
          caps[of_loop_.size() + s].row.emplace_back(j, number);
    }
    std::stable_sort(caps.begin(), caps.end(),
                     [](const Cap& a, const Cap& b) { return a.radius < b.radius; });
    most_.clear();
    Linking_rank rank;
    for(const Cap& cap : caps)
      if(rank.add(cap.row))
        most_.push_back(cap.radius);
    // Of classes for which no cycle is known, nothing else is known.
    most_.resize(of_loop_.size(), *std::max_element(of_loop_.begin(), of_loop_.end()));
    std::sort(most_.begin(), most_.end(), std::greater<>());
  }

  Execution execution_;
  const Face_tree& faces_;
  Span<const Vector> points_;
  Room_in_caps room_;
  std::vector<double> of_loop_, most_;
  std::vector<Section_cap> sections_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_CAP_BOUNDS_H
