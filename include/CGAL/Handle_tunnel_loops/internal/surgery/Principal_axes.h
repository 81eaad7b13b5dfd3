// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PRINCIPAL_AXES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PRINCIPAL_AXES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Handle_tunnel_loops::internal {

/// Three orthonormal vectors along which points, or directions, vary most and least; in no order.
class Principal_axes
{
public:
  using Vector = std::array<double, 3>;
  using Axes = std::array<Vector, 3>;

  /// of points, about their mean; `for_each(f)` calls `f(p)` for each.
  template <typename For_each> static Axes of_points(const For_each& for_each) {
    Vector mean = {0., 0., 0.};
    double number = 0.;
    for_each([&](const Vector& p) {
      number += 1.;
      for(std::size_t i = 0; i < 3; ++i)
        mean[i] += p[i];
    });
    for(double& x : mean)
      x /= number;
    return of_directions([&](const auto& f) {
      for_each([&](const Vector& p) { f(Vector{p[0] - mean[0], p[1] - mean[1], p[2] - mean[2]}); });
    });
  }

  /// of directions, each as important as the square of its length.
  template <typename For_each> static Axes of_directions(const For_each& for_each) {
    Axes moments{};
    for_each([&](const Vector& d) {
      for(std::size_t i = 0; i < 3; ++i)
        for(std::size_t j = 0; j < 3; ++j)
          moments[i][j] += d[i] * d[j];
    });
    return diagonalize(moments);
  }

  /// the one along which directions vary least.
  template <typename For_each> static Vector least_of_directions(const For_each& for_each) {
    const Axes axes = of_directions(for_each);
    std::array<double, 3> moments = {0., 0., 0.};
    for_each([&](const Vector& d) {
      for(std::size_t i = 0; i < 3; ++i) {
        const double along = axes[i][0] * d[0] + axes[i][1] * d[1] + axes[i][2] * d[2];
        moments[i] += along * along;
      }
    });
    return axes[static_cast<std::size_t>(std::min_element(moments.begin(), moments.end()) -
                                         moments.begin())];
  }

private:
  // Jacobi's method: a few rounds of rotations. Axes stay orthonormal, whatever is left beside the
  // diagonal.
  static Axes diagonalize(Axes& m) {
    Axes axes = {{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
    constexpr int number_of_rounds = 6;
    for(int round = 0; round < number_of_rounds; ++round) {
      rotate(m, axes, 0, 1);
      rotate(m, axes, 0, 2);
      rotate(m, axes, 1, 2);
    }
    return axes;
  }

  // By the smaller angle that makes the entry zero.
  static void rotate(Axes& m, Axes& axes, std::size_t p, std::size_t q) {
    const double difference = m[q][q] - m[p][p], twice = 2. * std::abs(m[p][q]);
    const double root = std::sqrt(difference * difference + twice * twice);
    if(!(twice > 0.) || !(root > 0.))
      return;
    const double tangent = twice / (std::abs(difference) + root);
    const double c = 1. / std::sqrt(tangent * tangent + 1.);
    const double s = (difference < 0.) == (m[p][q] < 0.) ? c * tangent : -c * tangent;
    for(std::size_t k = 0; k < 3; ++k) {
      const double x = m[k][p], y = m[k][q];
      m[k][p] = c * x - s * y;
      m[k][q] = s * x + c * y;
    }
    const auto turn = [c, s](Vector& a, Vector& b) {
      for(std::size_t k = 0; k < 3; ++k) {
        const double x = a[k], y = b[k];
        a[k] = c * x - s * y;
        b[k] = s * x + c * y;
      }
    };
    turn(m[p], m[q]);
    turn(axes[p], axes[q]);
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_PRINCIPAL_AXES_H
