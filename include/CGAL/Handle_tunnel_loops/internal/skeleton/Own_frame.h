// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_OWN_FRAME_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_OWN_FRAME_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
A frame that turns with a mesh, whatever the numbers of its vertices: its origin is their mean, one
axis points to the vertex that is farthest from there, another to the vertex that is farthest from
this axis. Of several that are equally far it is the one with the longest edges; if these are equal,
too, the mesh is likely to look the same from all of them.

Coordinates in it are between 0 and 1, and rounded so far that those of a mesh that has been turned,
and rounded by that, are the same but for few.
*/
class Own_frame
{
public:
  /// the frame of the caller, scaled by a power of two; nothing is rounded.
  static Own_frame of_caller(const std::vector<Vector>& places) {
    double largest = 0.;
    for(const Vector& p : places)
      for(double x : p)
        largest = (std::max)(largest, std::abs(x));
    Own_frame frame;
    std::frexp(largest, &frame.exponent_);
    return frame;
  }

  /// \p places are those of the vertices, hubs included.
  Own_frame(const Flat_mesh& mesh, const std::vector<Vector>& places)
      : Own_frame(of_caller(places)) {
    const Index n = mesh.first_hub;
    Vector mean = {0., 0., 0.};
    for(Index v = 0; v < n; ++v)
      mean = mean + (1. / n) * into(places[v]);
    const auto way = [&](Index v) { return into(places[v]) - mean; };
    const Vector longest = farthest(mesh, places, way), first = unit(longest);
    const Vector second =
        unit(farthest(mesh, places, [&](Index v) { return way(v) - dot(way(v), first) * first; }));
    origin_ = mean;
    if(norm(second) > 0.)
      axes_ = {first, second, cross(first, second)};
    std::frexp(norm(longest), &second_exponent_);
    is_rounded_ = true;
  }

  Vector into(const Vector& p) const {
    if(!is_rounded_)
      return scaled(p, -exponent_);
    constexpr double cells = 0x1p34;
    const Vector way = scaled(scaled(p, -exponent_) - origin_, -second_exponent_);
    Vector q;
    for(int d = 0; d < 3; ++d)
      q[d] = 0.5 + std::nearbyint(dot(way, axes_[d]) * cells) / (2. * cells);
    return q;
  }

  Vector out_of(const Vector& p) const {
    if(!is_rounded_)
      return scaled(p, exponent_);
    const Vector q = 2. * (p - Vector{0.5, 0.5, 0.5});
    const Vector way = q[0] * axes_[0] + q[1] * axes_[1] + q[2] * axes_[2];
    return scaled(origin_ + scaled(way, second_exponent_), exponent_);
  }

  /// a length in the unit of the caller.
  double length_out_of(double length) const {
    return std::ldexp(length, exponent_ + (is_rounded_ ? 1 + second_exponent_ : 0));
  }

private:
  Own_frame() = default;

  static Vector scaled(Vector p, int exponent) {
    for(double& x : p)
      x = std::ldexp(x, exponent);
    return p;
  }

  static Vector unit(const Vector& v) {
    const double length = norm(v);
    return length > 0. ? (1. / length) * v : Vector{0., 0., 0.};
  }

  // The longest of the vectors of vertices.
  template <typename Way>
  Vector farthest(const Flat_mesh& mesh, const std::vector<Vector>& places, const Way& way) const {
    constexpr double equal = 1. - 1e-9;
    double most = 0.;
    for(Index v = 0; v < mesh.first_hub; ++v)
      most = (std::max)(most, norm(way(v)));
    Vector best = {0., 0., 0.};
    double longest_edges = -1.;
    for(Index v = 0; v < mesh.first_hub; ++v)
      if(const Vector w = way(v); norm(w) >= equal * most) {
        double edges = 0.;
        for(Index u : mesh.ring(v))
          edges += norm(into(places[u]) - into(places[v]));
        if(edges * equal > longest_edges) {
          longest_edges = edges;
          best = w;
        }
      }
    return best;
  }

  int exponent_ = 0, second_exponent_ = 0;
  bool is_rounded_ = false;
  Vector origin_ = {0., 0., 0.};
  std::array<Vector, 3> axes_ = {{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_OWN_FRAME_H
