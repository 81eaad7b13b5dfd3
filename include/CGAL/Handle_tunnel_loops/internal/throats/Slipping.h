// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_SLIPPING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_SLIPPING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/Front_on_side.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
How much longer a loop must become before it slips away: on the easier side of it the front that
runs from there over the surface becomes so long, before it is shorter than the loop.

Both fronts run as far as it takes to know which side is the easier one; so the time goes with what
is about a loop, not with the whole surface.
*/
class Slipping
{
public:
  explicit Slipping(const Flat_mesh& mesh)
      : mesh_(mesh)
      , cut_(mesh)
      , left_(mesh)
      , right_(mesh) {}

  /// whether a loop becomes longer by a barrier, as a part of its length, before it slips away.
  bool is_held(const Crossing_loop& loop, double size, double barrier) {
    start(loop, size, barrier);
    run(size,
        [&] { return (is_settled(left_) && is_settled(right_)) || slips(left_) || slips(right_); });
    return !slips(left_) && !slips(right_);
  }

  /// how much longer a loop must become before it slips away, as a part of its length; infinite if
  /// it does not before it is \p most_times as long. Not known if fronts would have to pass more
  /// than \p most_vertices.
  std::optional<double>
  prominence(const Crossing_loop& loop, double size, double most_times, std::size_t most_vertices) {
    start(loop, size, most_times);
    const auto is_easier = [](const Front_on_side& side, const Front_on_side& other) {
      return side.has_slipped() && other.longest() >= side.longest();
    };
    const auto is_known = [&] {
      return (is_settled(left_) && is_settled(right_)) || is_easier(left_, right_) ||
             is_easier(right_, left_);
    };
    run(size, [&] {
      return is_known() || left_.passed().size() + right_.passed().size() > most_vertices;
    });
    if(!is_known())
      return {};
    return (std::max)((std::min)(way_off(left_), way_off(right_)) / size - 1., 0.);
  }

  /// whether a loop can slide to another one without becoming as long as a barrier: curves between
  /// them are where the distances from both have a ratio.
  bool slides(const Crossing_loop& loop, const Crossing_loop& other, double size, double barrier) {
    cut_.start(loop);
    cut_.add(other);
    for(const bool is_left : {true, false})
      for(const bool is_left_of_other : {true, false})
        if(is_filled(left_, loop, is_left, other, is_left_of_other, size) &&
           is_filled(right_, other, is_left_of_other, loop, is_left, size) &&
           longest_between() < barrier * size)
          return true;
    return false;
  }

  /// calls `f(v)` for the vertices to both sides that come before a barrier.
  template <typename Function> void for_each_in_place(const Function& f) const {
    left_.for_each_before_barrier(f);
    right_.for_each_before_barrier(f);
  }

private:
  void start(const Crossing_loop& loop, double size, double barrier) {
    cut_.start(loop);
    left_.start(cut_, loop, true, size, barrier * size);
    right_.start(cut_, loop, false, size, barrier * size);
  }

  // Both sides at once, further and further.
  template <typename IsDone> void run(double size, const IsDone& is_done) {
    for(double distance = size / 32.; !is_done(); distance *= 1.25)
      for(Front_on_side* side : {&left_, &right_})
        if(!side->is_decided())
          side->run_to(distance);
  }

  // Whether a front passes all that is between a loop and another one, and soon after it has come
  // to that: then there is no way out from there.
  bool is_filled(Front_on_side& front,
                 const Crossing_loop& loop,
                 bool is_left,
                 const Crossing_loop& other,
                 bool is_left_of_other,
                 double size) {
    constexpr double most_times = 3., a_while = 1.5;
    front.start(cut_, loop, is_left, size, most_times * size);
    const auto has_arrived = [&] {
      return std::all_of(other.begin(), other.end(), [&](const Crossing& c) {
        const Index v = is_left_of_other ? c.left : c.right;
        return mesh_.is_hub(v) || front.has_passed(v);
      });
    };
    double distance = size / 32.;
    for(front.run_to(distance); !has_arrived(); front.run_to(distance *= 1.25))
      if(front.has_met_barrier() || front.has_passed_all())
        return false;
    front.run_to(a_while * distance);
    return front.has_passed_all();
  }

  double longest_between() {
    lengths_.start(2.);
    for(const Index v : left_.passed()) {
      const Ring ring = mesh_.ring(v);
      for(Index p = 0; p < ring.size(); ++p) {
        const Index a = ring[p], b = ring[ring.next(p)];
        if(v < a && v < b && is_between(v, a) && is_between(v, b) && is_between(a, b))
          lengths_.add({corner(v), corner(a), corner(b)});
      }
    }
    double longest = 0.;
    for(std::size_t bin = 0; bin < lengths_.number_of_bins(); ++bin)
      longest = (std::max)(longest, lengths_.mean(bin));
    return longest;
  }

  bool is_between(Index u, Index v) const {
    return left_.has_passed(u) && left_.has_passed(v) && right_.has_passed(u) &&
           right_.has_passed(v) && !cut_.is_crossed(u, v);
  }

  Length_by_distance::Corner corner(Index v) const {
    const double d = left_.distance(v), e = right_.distance(v);
    return {mesh_.points[v], d + e > 0. ? d / (d + e) : 0.};
  }

  static bool is_settled(const Front_on_side& side) {
    return side.has_met_barrier() || side.is_decided();
  }

  static bool slips(const Front_on_side& side) {
    return side.has_slipped() && !side.has_met_barrier();
  }

  static double way_off(const Front_on_side& side) {
    return slips(side) ? side.longest() : std::numeric_limits<double>::infinity();
  }

  const Flat_mesh& mesh_;
  Cut_along_loop cut_;
  Front_on_side left_, right_;
  Length_by_distance lengths_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_SLIPPING_H
