// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Tubes.h"
#include "closed_tube.h"
#include "kinds.h"
#include "mesh_of_field.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// The segments of one or two parallel torus knots, and of rungs between them. All that does not
/// meet is `width` apart or more.
class Knotted_ladder
{
public:
  Knotted_ladder(const Torus_knot& knot, std::size_t rungs)
      : knot_(knot)
      , rungs_(rungs) {
    // Between the ladder and its next turn there is as much room as between its sides.
    const double turns = 2. * width / knot.distance(knot.period());
    const double length_of_rungs = width * static_cast<double>(rungs);
    scale_ = (std::max)(turns, length_of_rungs / (2. * CGAL_PI * knot.least_speed()));
    moved_ = width / (scale_ * knot.distance_along_torus(1.));
    choose_steps();
    add_side(0.);
    if(rungs == 0)
      return;
    add_side(moved_);
    for(std::size_t i = 0; i < rungs; ++i)
      add_rung(node(i * steps_ / rungs, 0.));
  }

  const std::vector<Tubes::Segment>& segments() const { return segments_; }

  double length() const {
    double sum = 0.;
    for(const auto& [a, b] : segments_)
      sum += generators::length(b - a);
    return sum;
  }

private:
  static constexpr double width = 0.85, step_length = 0.5;

  void choose_steps() {
    const Curve_by_length side([this](double t) { return scale_ * knot_.point(t, 0.); });
    steps_ = static_cast<std::size_t>(std::ceil(side.length() / step_length));
    if(rungs_ > 0)
      steps_ = rungs_ * ((steps_ + rungs_ - 1) / rungs_);
  }

  Vector node(std::size_t i, double moved) const {
    return scale_ * knot_.point(2. * CGAL_PI * (i % steps_) / steps_, moved);
  }

  void add_side(double moved) {
    for(std::size_t i = 0; i < steps_; ++i)
      segments_.emplace_back(node(i, moved), node(i + 1, moved));
  }

  /// to the nearest node of the other side.
  void add_rung(const Vector& from) {
    Vector nearest = node(0, moved_);
    for(std::size_t i = 1; i < steps_; ++i) {
      const Vector to = node(i, moved_);
      if((to - from).squared_length() < (nearest - from).squared_length())
        nearest = to;
    }
    segments_.emplace_back(from, nearest);
  }

  const Torus_knot& knot_;
  std::size_t rungs_, steps_;
  double scale_, moved_;
  std::vector<Tubes::Segment> segments_;
};

Soup make_ladder(const Request& request) {
  constexpr double tube_radius = 0.22, faces_per_length = 200.;
  require_least_genus(request, "ladder", 1);
  const Torus_knot knot(request.p, request.q);
  const Knotted_ladder ladder(knot, request.genus - 1);
  require_faces(request, "ladder",
                static_cast<std::size_t>(std::ceil(faces_per_length * ladder.length())));
  return mesh_of_field(Tubes(ladder.segments(), tube_radius), request, "ladder");
}

} // namespace

const Kind ladder_kind = {
    "ladder",
    "a ladder with g - 1 rungs along a torus knot (p, q), its ends joined, and for g = 1 one side "
    "alone; any genus g from 1, from some ten thousand faces",
    make_ladder, GENUS | TORUS_KNOT, 20000};

} // namespace CGAL::Handle_tunnel_loops::generators
