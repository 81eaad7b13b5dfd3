// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_SINGLE_FIELD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_SINGLE_FIELD_H

#include <CGAL/license/Handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/internal/reference/laplacian.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/*!
One field over the whole mesh, with walls (paper, section 5): the base layer is one minus its value,
and the equation of the layers becomes
\f[ \dot\varphi = \frac{\mu}{2} \left[ a^2 \nabla^2 \varphi + e \sqrt{\varphi (1 - \varphi)}
    - w (1 - 2 \varphi) \right]. \f]
Sources keep the value one.
*/
class Single_field
{
public:
  Single_field(const Flat_mesh& mesh,
               const Field_constants& constants,
               const Barred_edges& walls,
               const Literal_rules& rules = Literal_rules())
      : constants_(constants)
      , is_rest_failure_(rules.are_of_fields())
      , factor_(time_step(constants) * constants.mobility / 2.)
      , laplacian_(laplacian(mesh, rules, walls))
      , phi_(Eigen::ArrayXd::Zero(laplacian_.cols()))
      , arrivals_(mesh, walls) {}

  void add_source(Index v) {
    if(arrivals_.is_reached(v))
      return;
    sources_.push_back(v);
    phi_[v] = 1.;
    arrivals_.reach(v);
  }

  bool is_source(Index v) const { return arrivals_.rank(v) < sources_.size(); }

  const Arrivals& arrivals() const { return arrivals_; }

  /// makes steps until all of the targets are reached, but only a third more than until the first
  /// is; stops when all that can be reached from the sources is covered. Returns the targets
  /// reached, in their order.
  std::vector<Index> run_until(const std::vector<char>& is_target) {
    const auto number_of_targets =
        static_cast<std::size_t>(std::count(is_target.begin(), is_target.end(), 1));
    std::vector<Index> targets;
    std::size_t last_step = (std::numeric_limits<std::size_t>::max)();
    const auto reached = [&](Index v) {
      if(!is_target[v])
        return;
      if(targets.empty())
        last_step = arrivals_.number_of_steps() * 4 / 3;
      targets.push_back(v);
    };
    bool goes_on = true;
    while(goes_on && (targets.empty() || targets.size() < number_of_targets) &&
          arrivals_.number_of_steps() < last_step)
      goes_on = advance(reached);
    return targets;
  }

  /// makes steps until so many vertices are reached, or the field is at rest for good; calls
  /// `advanced()` after each.
  template <typename Advanced> void run(std::size_t number_of_vertices, const Advanced& advanced) {
    while(arrivals_.number_of_reached() < number_of_vertices && advance([](Index) {}))
      advanced();
  }

private:
  // Makes a step, and pushes on what has come to rest. Returns false if that is for good.
  template <typename Reached> bool advance(const Reached& reached) {
    const std::size_t reached_before = arrivals_.number_of_reached();
    step(reached);
    steps_at_rest_ = arrivals_.number_of_reached() == reached_before ? steps_at_rest_ + 1 : 0;
    if(steps_at_rest_ < patience(constants_))
      return true;
    steps_at_rest_ = 0;
    return !is_rest_failure_ && push_on(reached);
  }

  template <typename Reached> void step(const Reached& reached) {
    const Eigen::ArrayXd before = phi_;
    const Eigen::ArrayXd diffusion = (laplacian_ * phi_.matrix()).array();
    const Field_constants& c = constants_;
    phi_ += factor_ *
            (c.gradient_coefficient * diffusion +
             c.driving_force * (before * (1. - before)).sqrt() - c.penalty * (1. - 2. * before));
    phi_ = phi_.max(0.).min(1.);
    for(Index v : sources_)
      phi_[v] = 1.;
    arrivals_.advance(before, phi_, reached);
  }

  // What the field touches while it is at rest is declared covered. Returns whether there was any.
  template <typename Reached> bool push_on(const Reached& reached) {
    const std::size_t reached_before = arrivals_.number_of_reached();
    arrivals_.push_on(phi_, [&](Index v) {
      phi_[v] = 1.;
      reached(v);
    });
    return arrivals_.number_of_reached() != reached_before;
  }

  Field_constants constants_;
  bool is_rest_failure_;
  double factor_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> laplacian_;
  Eigen::ArrayXd phi_;
  Arrivals arrivals_;
  std::vector<Index> sources_;
  std::size_t steps_at_rest_ = 0;
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_SINGLE_FIELD_H
