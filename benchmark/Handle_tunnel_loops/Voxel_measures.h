// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_VOXEL_MEASURES_H
#define BENCHMARK_VOXEL_MEASURES_H

#include "Pulled_line.h"
#include "Threading_cycles.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

/*!
\file Voxel_measures.h
Thicknesses and clear widths by definition, with bounds that hold: by code that shares nothing with
what computes them but the loops.

Let \f$ X_r \f$ be the places at least \f$ r \f$ from the surface, and \f$ w_1 \ge w_2 \ge \ldots
\f$ the radii at which the rank of the linking numbers of the cycles in \f$ X_r \f$ with all loops
grows, inside and outside.

- From above: voxels that may hold a place of \f$ X_r \f$, and that the surface does not meet, cover
\f$ X_r \f$ (outside the largest cube there is nothing to go around). So all cycles of \f$ X_r \f$
are cycles of voxels that touch, and the i-th birth of those is not below \f$ w_i \f$.
- From below: i independent cycles that keep a distance from the surface show that \f$ w_i \f$ is
not less than that. Those of voxels are pulled away from the surface, their distances found with
steps as small as it takes, and their linking numbers computed anew.

Where the bounds are apart, the voxels are divided that decide.
*/

namespace voxel_measures {

/// Between which diameters a measure is.
struct Interval
{
  double lower, upper;
};

/// In falling order.
struct Measures
{
  std::vector<Interval> thickness, clear_width;
};

class Voxel_measures
{
public:
  using Is_inside = std::function<bool(const Point&)>;

  /// \param loops a basis of the surface's homology
  /// \param is_inside tells on which side of the surface a place is that is not on it
  Voxel_measures(std::vector<Triangle> triangles,
                 const std::vector<Line>& loops,
                 Is_inside is_inside,
                 unsigned seed = 0)
      : random_(seed)
      , surface_(std::move(triangles))
      , cones_(loops, random_)
      , voxels_(surface_, cones_, random_)
      , is_inside_(std::move(is_inside)) {
    const CGAL::Bbox_3 box = surface_.box();
    least_ =
        (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
    stop_ = 1e-3 * least_;
  }

  /// makes the intervals narrower until no upper bound is above the lower one by more than a part
  /// of it, or after a number of rounds, or voxels.
  void refine(double tolerance, int most_rounds, std::size_t most_voxels) {
    for(int round = 0; round < most_rounds && find_cycles(tolerance, most_voxels); ++round) {
      const std::vector<std::uint32_t> deciding = find_deciding(tolerance);
      if(deciding.empty() || voxels_.size() > most_voxels)
        return;
      for(const std::uint32_t v : deciding)
        voxels_.divide(v);
    }
  }

  /// As many as could be found, of as many as there are loops.
  Measures measures() const {
    Measures result;
    for(const bool is_inside : {true, false}) {
      auto& list = is_inside ? result.thickness : result.clear_width;
      const std::vector<double> lower = lower_bounds(is_inside);
      std::size_t i = 0;
      for(const double upper : upper_[is_inside])
        list.push_back({i < lower.size() ? 2. * lower[i] : 0., 2. * upper}), ++i;
    }
    return result;
  }

  std::size_t number_of_voxels() const { return voxels_.size(); }

private:
  /// A cycle that keeps away from the surface.
  struct Clear_cycle
  {
    double clearance;
    bool is_inside;
    std::vector<int> row;
  };

  // As far down as it takes for all of them. Returns false if there would be too many voxels.
  bool find_cycles(double tolerance, std::size_t most_voxels) {
    Threading_cycles threading(voxels_, cones_);
    for(;; least_ *= 0.8) {
      if(!voxels_.settle(least_, most_voxels) || least_ < stop_)
        return false;
      cycles_ = threading.find(least_);
      if(cycles_.size() == cones_.number_of_loops())
        break;
    }
    std::array<std::vector<double>, 2> upper;
    for(const Threading_cycle& cycle : cycles_) {
      const bool is_inside = is_inside_(cycle.line[0]);
      upper[is_inside].push_back(cycle.most);
      const std::vector<double> lower = lower_bounds(is_inside);
      const std::size_t i = upper[is_inside].size() - 1;
      if(i < lower.size() && cycle.most <= (1. + tolerance) * lower[i])
        continue;
      const Pulled_line pulled(surface_, cycle.line, cycle.most);
      if(const double room = clearance(surface_, pulled.line()); room > 0.)
        clear_.push_back({room, is_inside, cones_.linking(pulled.line())});
    }
    for(const bool is_inside : {false, true})
      for(std::size_t i = 0; i < upper[is_inside].size(); ++i)
        if(i >= upper_[is_inside].size())
          upper_[is_inside].push_back(upper[is_inside][i]);
        else
          upper_[is_inside][i] = (std::min)(upper_[is_inside][i], upper[is_inside][i]);
    return true;
  }

  std::vector<double> lower_bounds(bool is_inside) const {
    std::vector<const Clear_cycle*> order;
    for(const Clear_cycle& c : clear_)
      if(c.is_inside == is_inside)
        order.push_back(&c);
    std::stable_sort(order.begin(), order.end(),
                     [](auto a, auto b) { return a->clearance > b->clearance; });
    Independent_rows rows;
    std::vector<double> bounds;
    for(const Clear_cycle* c : order)
      if(rows.add(c->row))
        bounds.push_back(c->clearance);
    return bounds;
  }

  // The voxels of which a smaller upper bound would tell most.
  std::vector<std::uint32_t> find_deciding(double tolerance) const {
    std::array<std::size_t, 2> number{};
    const std::array<std::vector<double>, 2> lower = {lower_bounds(false), lower_bounds(true)};
    std::set<std::uint32_t> deciding;
    for(const Threading_cycle& cycle : cycles_) {
      const bool is_inside = is_inside_(cycle.line[0]);
      const std::size_t i = number[is_inside]++;
      const double proved = i < lower[is_inside].size() ? lower[is_inside][i] : 0.;
      if(cycle.most <= (1. + tolerance) * proved)
        continue;
      const auto is_open = [&](std::uint32_t v) {
        return voxels_[v].known < cycle.most && voxels_[v].most > (1. + tolerance) * proved;
      };
      const std::size_t before = deciding.size();
      for(const std::uint32_t v : cycle.voxels)
        if(is_open(v)) {
          deciding.insert(v);
          voxels_.visit_touching(v, [&](std::uint32_t w) {
            if(is_open(w))
              deciding.insert(w);
          });
        }
      if(deciding.size() == before) // the way between the voxels is narrow
        deciding.insert(cycle.voxels.begin(), cycle.voxels.end());
    }
    return {deciding.begin(), deciding.end()};
  }

  CGAL::Random random_;
  Triangle_tree surface_;
  Loop_cones cones_;
  Voxel_tree voxels_;
  Is_inside is_inside_;
  double least_, stop_;
  std::vector<Threading_cycle> cycles_;
  std::vector<Clear_cycle> clear_;           ///< all that were ever found
  std::array<std::vector<double>, 2> upper_; ///< by side, 1 for inside
};

} // namespace voxel_measures

#endif // BENCHMARK_VOXEL_MEASURES_H
