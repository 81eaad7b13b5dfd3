// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LIMBS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LIMBS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Bulges.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Reach.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Edges_at.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_samples.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds the limbs of a solid: parts that reach far out from the cycles of its skeleton, or from its
largest ball.

The places on the surface that are farther from there than some distance fall apart into regions,
which join as the distance falls. A region is a limb if at some distance it is long against its
girth there. The less so, the more it tapers: the girth of a corner of a plate grows from nothing,
and is half as large in the mean, so that such a corner counts as half as long.
*/
class Limbs
{
public:
  /// \p roots are balls that the skeleton has even if it has no edges there.
  Limbs(const Ball_graph& graph,
        const Surface_samples& samples,
        const std::vector<std::pair<Index, Index>>& neighbors,
        const std::vector<Index>& roots,
        const std::vector<char>& is_taken)
      : graph_(graph)
      , areas_(samples.areas())
      , neighbors_(united(neighbors, graph.opposites))
      , neighbors_at_(areas_.size(), neighbors_)
      , starts_(balls_of_skeleton(graph, roots, is_taken))
      , reach_(graph, samples, neighbors, starts_)
      , paths_(graph.balls.size())
      , slenderness_(areas_.size(), 0.)
      , visit_(areas_.size(), 0) {
    for(Index b : starts_)
      paths_.reach(b, {0., no_index});
    grow();
  }

  /// takes the edges to ends that are given, and to bulges.
  void add(const std::vector<Index>& ends,
           double shortest_limb,
           double least_length,
           std::vector<char>& is_taken) {
    for(Index end : ends)
      take(end, is_taken);
    for(Index ball : bulges_outside(shortest_limb, least_length))
      take(ball, is_taken);
  }

  /// takes the edges to the ends of limbs. Returns whether there are any: what is left may be limbs
  /// of these.
  bool add_ends(double shortest_limb, double least_length, std::vector<char>& is_taken) {
    examine_regions(least_length);
    const std::vector<Index> found = tips(least_slenderness(shortest_limb));
    for(Index tip : found)
      take(end_of_limb(graph_.ball_of_sample[tip]), is_taken);
    return !found.empty();
  }

private:
  struct Label
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index edge = no_index;
  };

  // What is no farther from the end of a limb.
  struct Part
  {
    double distance = 0., area = 0., extent = 0.; // times the area
    std::size_t samples = 1;
  };

  template <typename Function> void for_each_beside(Index sample, const Function& f) const {
    for(Index i : neighbors_at_[sample]) {
      const auto& [a, b] = neighbors_[i];
      f(a == sample ? b : a);
    }
  }

  // ---- regions

  bool is_farther(Index a, Index b) const {
    return std::make_pair(reach_[b], a) < std::make_pair(reach_[a], b);
  }

  // The farthest first.
  std::vector<Index> samples_in_order() const {
    std::vector<Index> order(reach_.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::sort(order.begin(), order.end(), [this](Index a, Index b) { return is_farther(a, b); });
    return order;
  }

  void examine_regions(double least_length) {
    std::vector<Index> top(reach_.size(), no_index); // by representative
    Sets_of_indices sets(reach_.size());
    const std::vector<Index> order = samples_in_order();
    for(Index s : order) {
      if(!(reach_[s] < std::numeric_limits<double>::infinity()))
        continue;
      top[s] = s;
      for_each_beside(s, [&](Index other) {
        if(top[other] == no_index)
          return;
        const Index a = sets.find(s), b = sets.find(other);
        if(a == b)
          return;
        const Index higher = is_farther(top[a], top[b]) ? top[a] : top[b],
                    lower = higher == top[a] ? top[b] : top[a];
        if(reach_[lower] - reach_[s] > least_length)
          for(Index tip : {lower, higher})
            examine(tip, reach_[s], least_length);
        sets.unite(a, b);
        top[sets.find(a)] = higher;
      });
    }
    for(Index s : order)
      if(top[s] != no_index && sets.find(s) == s)
        examine(top[s], 0., least_length);
  }

  // Finds how slender the region around the end of a limb is, where it is most so, down to a
  // distance.
  void examine(Index tip, double level, double least_length) {
    constexpr double step = 1.1, beyond_start = 1.1, two_pi = 6.283185307179586;
    constexpr std::size_t least_samples = 16; // of which fewer tell no girth
    const double base = (std::max)(level, beyond_start * reach_.extent_at_start(tip)),
                 most = reach_[tip] - base;
    if(!reach_.is_beyond_start(tip) || !(most > least_length))
      return;
    const std::vector<Part> region = region_beyond(tip, base);
    for(double length = most; length > least_length; length /= step) {
      const Part part = part_within(region, length);
      if(part.samples < least_samples)
        break;
      if(const double around = girth(region, length); around > 0.) {
        const double mean = part.area / length;
        slenderness_[tip] =
            (std::max)(slenderness_[tip], two_pi * length / around * (std::min)(1., mean / around));
      }
    }
  }

  // Around the end of a limb.
  std::vector<Part> region_beyond(Index tip, double level) {
    std::vector<Part> region;
    std::vector<Index> reached = {tip};
    visit_[tip] = ++number_of_visits_;
    for(std::size_t i = 0; i < reached.size(); ++i) {
      const Index s = reached[i];
      region.push_back({reach_[tip] - reach_[s], areas_[s], areas_[s] * reach_.extent(s)});
      for_each_beside(s, [&](Index other) {
        if(reach_[other] > level && visit_[other] != number_of_visits_) {
          visit_[other] = number_of_visits_;
          reached.push_back(other);
        }
      });
    }
    std::stable_sort(region.begin(), region.end(),
                     [](const Part& a, const Part& b) { return a.distance < b.distance; });
    for(std::size_t i = 1; i < region.size(); ++i) {
      region[i].area += region[i - 1].area;
      region[i].extent += region[i - 1].extent;
      region[i].samples += region[i - 1].samples;
    }
    return region;
  }

  static Part part_within(const std::vector<Part>& region, double distance) {
    const auto it = std::upper_bound(region.begin(), region.end(), distance,
                                     [](double d, const Part& part) { return d < part.distance; });
    return it == region.begin() ? Part() : *(it - 1);
  }

  // So far from the end of a limb: the derivative of the area, by what is beyond. But no less than
  // can be told from how far regions of samples extend.
  static double girth(const std::vector<Part>& region, double length) {
    constexpr double pi = 3.141592653589793;
    const Part all = part_within(region, length);
    const double half = part_within(region, 0.5 * length).area,
                 most = part_within(region, 0.75 * length).area;
    return (std::max)({2. * (all.area - half) / length,
                       2. * (3. * all.area - 4. * most + half) / length,
                       pi * all.extent / all.area});
  }

  // ---- limbs

  // About what is asked for: where that tells best between limbs, of which many may be alike.
  double least_slenderness(double asked) const {
    constexpr double most = 1.1;
    std::vector<double> values = {asked / most, asked * most};
    for(double value : slenderness_)
      if(value > values[0] && value < values[1])
        values.push_back(value);
    std::sort(values.begin(), values.end());
    double least = asked, widest = 0.;
    for(std::size_t i = 1; i < values.size(); ++i)
      if(values[i] > widest * values[i - 1]) {
        widest = values[i] / values[i - 1];
        least = std::sqrt(values[i]) * std::sqrt(values[i - 1]);
      }
    return least;
  }

  // The farthest first.
  std::vector<Index> tips(double least_slenderness) const {
    std::vector<Index> tips;
    for(Index s : samples_in_order())
      if(slenderness_[s] > least_slenderness)
        tips.push_back(s);
    return tips;
  }

  void grow() {
    graph_.grow(
        paths_, [this](Index e) { return Inner_cycles::cost(graph_, e); },
        [](const Label&, double distance, Index e) {
          return Label{distance, e};
        });
  }

  // Larger than the skeleton is where the way to them begins, out of it, and far.
  std::vector<Index> bulges_outside(double shortest_limb, double least_length) const {
    constexpr double ratio = 2.;
    std::vector<Index> balls = Bulges(graph_, starts_).balls();
    const auto is_no_limb = [&](Index ball) {
      const Inner_ball &bulge = graph_.balls[ball], &start = graph_.balls[start_of_way(ball)];
      const double length = norm(bulge.centre - start.centre);
      return bulge.radius < ratio * start.radius ||
             length < (std::max)(bulge.radius, least_length) ||
             length + bulge.radius < shortest_limb * start.radius;
    };
    balls.erase(std::remove_if(balls.begin(), balls.end(), is_no_limb), balls.end());
    return balls;
  }

  Index start_of_way(Index ball) const {
    graph_.for_each_back(paths_, ball, [&](Index before, Index) { ball = before; });
    return ball;
  }

  // Takes the way to a ball. Ways to others may go on from there.
  void take(Index ball, std::vector<char>& is_taken) {
    std::vector<Index> way = {ball};
    graph_.for_each_back(paths_, ball, [&](Index before, Index e) {
      is_taken[e] = 1;
      way.push_back(before);
    });
    for(Index b : way)
      paths_.reach(b, {0., no_index});
    grow();
  }

  // On the way to the tip, where that does not turn into a corner of a flat end yet: the larger a
  // ball is against what is left of the way, the more of the limb ends there.
  Index end_of_limb(Index tip) const {
    constexpr double times = 2.;
    const Inner_ball& start = graph_.balls[start_of_way(tip)];
    Index end = tip;
    double left = 0., most = times * graph_.balls[tip].radius;
    graph_.for_each_back(paths_, tip, [&](Index b, Index e) {
      const Inner_ball& ball = graph_.balls[b];
      left += graph_.length(e);
      if(const double value = times * ball.radius - left;
         value > most && norm(ball.centre - start.centre) > start.radius)
      {
        most = value;
        end = b;
      }
    });
    return end;
  }

  const Ball_graph& graph_;
  std::vector<double> areas_;                      // by sample
  std::vector<std::pair<Index, Index>> neighbors_; // of samples
  Edges_at neighbors_at_;                          // by sample
  std::vector<Index> starts_;                      // balls
  Reach reach_;
  Shortest_paths<Label> paths_;
  std::vector<double> slenderness_; // by sample, of the limb that ends there
  std::vector<Index> visit_;        // by sample, the last one
  Index number_of_visits_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_LIMBS_H
