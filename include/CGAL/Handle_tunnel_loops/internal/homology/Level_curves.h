// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LEVEL_CURVES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LEVEL_CURVES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Unimodular_system.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Curves of the class of a sum of loops that cross few edges. How often the loops cross an edge, with
signs, is a closed 1-form, the dual of their class. The harmonic form of the same class is the step
of a function with values on a circle; a level of that function is made of curves of the class, and
some level is about as short as the form is small: many loops that go out and back along each other
are gone.

The function is found by conjugate gradients, not to the end. It is rounded to integers before it
changes the form, so that the class of the curves does not depend on it.
*/
class Level_curves
{
public:
  /// \p a are coordinates in the loops.
  Level_curves(const Flat_mesh& mesh,
               const std::vector<Crossing_loop>& loops,
               const Class_vector& a)
      : mesh_(mesh)
      , form_(mesh.neighbor.size(), 0) {
    for(const auto& [i, factor] : a)
      for(const Crossing& c : loops[i]) {
        form_[place(c.left, c.right)] += factor;
        form_[place(c.right, c.left)] -= factor;
      }
    add_step_of(best_level(potential()));
  }

  std::int64_t number_of_crossings() const {
    return sum_of_positive([this](Index, Index p) { return form_[p]; });
  }

  /// the curves, but for those around single vertices.
  std::vector<Crossing_loop> curves() const {
    std::vector<std::int64_t> left = form_; // what is not in a curve yet, where it is positive
    std::vector<Crossing_loop> found;
    for_each_halfedge([&](Index u, Index p) {
      while(left[p] > 0) {
        Crossing_loop curve = curve_from(u, mesh_.neighbor[p], left);
        if(has_ends_of_its_own(curve, &Crossing::left) &&
           has_ends_of_its_own(curve, &Crossing::right))
          found.push_back(std::move(curve));
      }
    });
    return found;
  }

private:
  Index place(Index u, Index v) const { return mesh_.row_begin[u] + mesh_.position(u, v); }

  // ---- the function

  // calls `f(u, p)` for all halfedges, by the vertex where they begin and their place.
  template <typename Function> void for_each_halfedge(const Function& f) const {
    for(Index u = 0; u < mesh_.number_of_vertices(); ++u)
      for(Index p = mesh_.row_begin[u]; p < mesh_.row_begin[u + 1]; ++p)
        f(u, p);
  }

  // The function x for which the sum of the squares of form(u, v) + x(v) - x(u) is smallest, about.
  std::vector<double> potential() const {
    constexpr int most_steps = 256;
    constexpr double accuracy = 3e-3;
    const std::size_t n = mesh_.number_of_vertices();
    std::vector<double> x(n, 0.), rest(n, 0.), direction, image(n);
    for_each_halfedge([&](Index u, Index p) { rest[u] += double(form_[p]); });
    direction = rest;
    double square = product(rest, rest);
    const double enough = accuracy * accuracy * square;
    for(int step = 0; step < most_steps && square > enough; ++step) {
      apply_laplacian(direction, image);
      const double stride = square / product(direction, image), before = square;
      for(std::size_t u = 0; u < n; ++u) {
        x[u] += stride * direction[u];
        rest[u] -= stride * image[u];
      }
      square = product(rest, rest);
      for(std::size_t u = 0; u < n; ++u)
        direction[u] = rest[u] + square / before * direction[u];
    }
    return x;
  }

  void apply_laplacian(const std::vector<double>& x, std::vector<double>& image) const {
    std::fill(image.begin(), image.end(), 0.);
    for_each_halfedge([&](Index u, Index p) { image[u] += x[u] - x[mesh_.neighbor[p]]; });
  }

  static double product(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.;
    for(std::size_t i = 0; i < a.size(); ++i)
      sum += a[i] * b[i];
    return sum;
  }

  // ---- levels

  // The function rounded down, from the height at which the form then has the fewest crossings.
  std::vector<std::int64_t> best_level(const std::vector<double>& x) const {
    constexpr int heights = 16;
    std::vector<std::int64_t> best, level(x.size());
    std::int64_t fewest = 0;
    for(int h = 0; h < heights; ++h) {
      for(std::size_t u = 0; u < x.size(); ++u)
        level[u] = static_cast<std::int64_t>(std::floor(x[u] + double(h) / heights));
      const std::int64_t crossings = crossings_with(level);
      if(h == 0 || crossings < fewest) {
        fewest = crossings;
        best = level;
      }
    }
    return best;
  }

  // Of the form and the step of a function.
  std::int64_t crossings_with(const std::vector<std::int64_t>& level) const {
    return sum_of_positive(
        [&](Index u, Index p) { return form_[p] + level[mesh_.neighbor[p]] - level[u]; });
  }

  // Of two halfedges of an edge one counts.
  template <typename Form> std::int64_t sum_of_positive(const Form& form) const {
    std::int64_t sum = 0;
    for_each_halfedge([&](Index u, Index p) { sum += (std::max)(form(u, p), std::int64_t(0)); });
    return sum;
  }

  void add_step_of(const std::vector<std::int64_t>& level) {
    for_each_halfedge([&](Index u, Index p) { form_[p] += level[mesh_.neighbor[p]] - level[u]; });
  }

  // ---- curves

  // Takes a curve out of what is left, beginning with the crossing of an edge.
  Crossing_loop curve_from(Index u, Index v, std::vector<std::int64_t>& left) const {
    Crossing_loop curve;
    Crossing c = {u, v, 0.5};
    do {
      --left[place(c.left, c.right)];
      curve.push_back(c);
      c = next(c, {u, v, 0.5}, left);
    } while(c.left != u || c.right != v);
    return curve;
  }

  // What comes in leaves by one of the two other edges, since the form is closed: by the first one,
  // if that is one of them and the curve could end there.
  Crossing
  next(const Crossing& c, const Crossing& first, const std::vector<std::int64_t>& left) const {
    const Index apex = after(mesh_.ring(c.left), mesh_.ring(c.right), c.left, c.right);
    const Crossing past_left = {c.left, apex, 0.5}, past_right = {apex, c.right, 0.5};
    for(const Crossing& way : {past_left, past_right})
      if(way.left == first.left && way.right == first.right)
        return way;
    const bool is_left = left[place(c.left, apex)] > 0;
    CGAL_assertion_msg(is_left || left[place(apex, c.right)] > 0, "the form is closed");
    return is_left ? past_left : past_right;
  }

  static bool has_ends_of_its_own(const Crossing_loop& curve, Crossing_end end) {
    return std::any_of(curve.begin(), curve.end(),
                       [&](const Crossing& c) { return c.*end != curve.front().*end; });
  }

  const Flat_mesh& mesh_;
  std::vector<std::int64_t> form_; // by halfedge: crossings with its source to the left, with signs
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LEVEL_CURVES_H
