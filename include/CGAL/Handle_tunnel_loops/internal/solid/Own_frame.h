// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_OWN_FRAME_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_OWN_FRAME_H

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
too, the mesh is likely to look the same from all of them. If much of the surface has nearly one
normal, the first axis is turned to that, and if much has a normal at right angles to it, the second
to that: parts that are made of planes are likely to fill their boxes, however many faces they have.

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
    int exponent = 0;
    std::frexp(largest, &exponent);
    Own_frame frame;
    frame.scale_ = Power_of_two(exponent);
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
    const Vector longest = farthest(mesh, places, way);
    const auto off = [&](const Vector& axis) {
      return unit(farthest(mesh, places, [&](Index v) { return across(way(v), axis); }));
    };
    const Vector first = unit(longest), second = off(first);
    if(norm(second) > 0.) {
      axes_ = {first, second, cross(first, second)};
      turn_to_planes(mesh, places, off);
    }
    origin_ = mean;
    int exponent = 0;
    std::frexp(norm(longest), &exponent);
    second_scale_ = Power_of_two(exponent);
    is_rounded_ = true;
  }

  Vector into(const Vector& p) const {
    if(!is_rounded_)
      return scale_.divide(p);
    constexpr double cells = 0x1p34;
    const Vector way = second_scale_.divide(scale_.divide(p) - origin_);
    Vector q;
    for(int d = 0; d < 3; ++d)
      q[d] = 0.5 + std::nearbyint(dot(way, axes_[d]) * cells) / (2. * cells);
    return q;
  }

  Vector out_of(const Vector& p) const {
    if(!is_rounded_)
      return scale_.multiply(p);
    const Vector q = 2. * (p - Vector{0.5, 0.5, 0.5});
    const Vector way = q[0] * axes_[0] + q[1] * axes_[1] + q[2] * axes_[2];
    return scale_.multiply(origin_ + second_scale_.multiply(way));
  }

  /// a length in the unit of the caller.
  double length_out_of(double length) const {
    if(!is_rounded_)
      return scale_.multiply(length);
    return scale_.multiply(second_scale_.multiply(2. * length));
  }

private:
  // In two factors, as one of its own may be beyond all doubles.
  class Power_of_two
  {
  public:
    explicit Power_of_two(int exponent = 0)
        : half_(std::ldexp(1., exponent / 2))
        , rest_(std::ldexp(1., exponent - exponent / 2))
        , inverse_half_(1. / half_)
        , inverse_rest_(1. / rest_) {}

    template <typename T> T multiply(const T& x) const { return rest_ * (half_ * x); }
    template <typename T> T divide(const T& x) const { return inverse_rest_ * (inverse_half_ * x); }

  private:
    double half_, rest_, inverse_half_, inverse_rest_;
  };

  Own_frame() = default;

  // The part of a vector at right angles to an axis.
  static Vector across(const Vector& v, const Vector& axis) { return v - dot(v, axis) * axis; }

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

  // Calls `f(normal, corners)` for the faces, with twice the area as a vector and the sum of the
  // corners.
  template <typename Function>
  void
  for_each_face(const Flat_mesh& mesh, const std::vector<Vector>& places, const Function& f) const {
    for(Index v = 0; v < mesh.first_hub; ++v) {
      const Ring ring = mesh.ring(v);
      const Vector p = into(places[v]);
      for(Index i = 0; i < ring.size(); ++i) {
        const Index u = ring[i], w = ring[ring.next(i)];
        if(v > u || v > w || mesh.is_hub(u) || mesh.is_hub(w))
          continue;
        const Vector q = into(places[u]), r = into(places[w]);
        f(cross(q - p, r - p), p + q + r);
      }
    }
  }

  // Which of the bins a normal is in, whatever its sign. Of the normals of planes that are parallel
  // to axes, or at usual angles to them, none is where rounding decides.
  std::size_t bin(const Vector& normal) const {
    constexpr Vector a = {0.8137, 0.4421, 0.3774};
    const Vector n = {dot(normal, axes_[0]), dot(normal, axes_[1]), dot(normal, axes_[2])};
    const Vector turned = 2. * dot(n, a) / dot(a, a) * a - n;
    std::size_t d = 0;
    for(std::size_t k = 1; k < 3; ++k)
      if(std::abs(turned[k]) > std::abs(turned[d]))
        d = k;
    const auto cell = [&](std::size_t k) {
      const double part = 0.5 + 0.5 * turned[(d + k) % 3] / turned[d];
      return (std::min)(static_cast<std::size_t>((std::max)(part, 0.) * bins), bins - 1);
    };
    return (d * bins + cell(1)) * bins + cell(2);
  }

  // The normal that most of the surface has nearly, of that part of it where `is_possible(normal)`:
  // exactly that of the largest face there, and of several that of the first along a line.
  template <typename Predicate>
  Vector most_common_normal(const Flat_mesh& mesh,
                            const std::vector<Vector>& places,
                            const Predicate& is_possible) const {
    constexpr double equal = 1e-9, least_part = 0.05;
    struct Bin
    {
      double area = 0., place = 0.;
      Vector largest = {0., 0., 0.};
    };
    std::vector<Bin> all(3 * bins * bins);
    double area = 0.;
    for_each_face(mesh, places, [&](const Vector& normal, const Vector& corners) {
      const double size = norm(normal);
      area += size;
      if(!(size > 0.) || !is_possible(normal))
        return;
      Bin& there = all[bin(normal)];
      there.area += size;
      const double largest = norm(there.largest),
                   place = dot(corners, axes_[0] + 0.6171 * axes_[1] + 0.3731 * axes_[2]);
      if(size > (1. - equal) * largest && (size > (1. + equal) * largest || place > there.place)) {
        there.largest = normal;
        there.place = place;
      }
    });
    const Bin* best = &all.front();
    for(const Bin& b : all)
      if(b.area > (1. + equal) * best->area)
        best = &b;
    return best->area > least_part * area ? unit(best->largest) : Vector{0., 0., 0.};
  }

  // `off(axis)` is the direction of what is farthest from an axis.
  template <typename Function>
  void
  turn_to_planes(const Flat_mesh& mesh, const std::vector<Vector>& places, const Function& off) {
    constexpr double right_angle = 1e-3; // by cosine
    const Vector first = most_common_normal(mesh, places, [](const Vector&) { return true; });
    if(norm(first) == 0.)
      return;
    const Vector other = most_common_normal(mesh, places, [&](const Vector& normal) {
      return std::abs(dot(first, normal)) < right_angle * norm(normal);
    });
    const Vector second = norm(other) > 0. ? unit(across(other, first)) : off(first);
    if(norm(second) > 0.)
      axes_ = {first, second, cross(first, second)};
  }

  static constexpr std::size_t bins = 16; // of normals, along each side of a cube

  Power_of_two scale_, second_scale_;
  bool is_rounded_ = false;
  Vector origin_ = {0., 0., 0.};
  std::array<Vector, 3> axes_ = {{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_OWN_FRAME_H
