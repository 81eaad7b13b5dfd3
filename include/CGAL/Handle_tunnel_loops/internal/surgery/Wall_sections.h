// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_WALL_SECTIONS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_WALL_SECTIONS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Bore_section.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Principal_axes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rim.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Divides the wall of a bore into sections: where it bends by more than a hexagon does, and then, as a
countersink may bend less, into what lies along an axis, and the rest, which is no section. What
goes on almost straight where that ends is curved along the axis, and no section, too.
*/
class Wall_sections
{
  using Vector = Simple_cartesian<double>::Vector_3;

public:
  /// of faces given in ascending order.
  Wall_sections(const Surgery_mesh& mesh, const std::vector<Index>& wall)
      : mesh_(mesh)
      , wall_(wall) {}

  /// linear in the size of the wall.
  std::vector<Bore_section> operator()() const {
    constexpr double of_hexagon = 0.48; // the cosine of a little more than 60 degrees
    std::vector<Bore_section> sections;
    for(const std::vector<Index>&part :
        parts_of(wall_, [&](Index f, Index g) { return bend_by_less(f, g, of_hexagon); }))
      for(const Vector& axis : axes_of(part))
        for(std::vector<Index>& straight : straight_parts(part, axis))
          sections.emplace_back(mesh_, std::move(straight), axis);
    return sections;
  }

private:
  static constexpr double sine_of_straight = 0.01; // half a degree

  // What hangs together by pairs of neighbours that are connected.
  template <typename Predicate>
  std::vector<std::vector<Index>> parts_of(const std::vector<Index>& faces,
                                           const Predicate& are_connected) const {
    std::vector<std::vector<Index>> parts;
    std::unordered_set<Index> is_taken;
    for(Index first : faces) {
      if(!is_taken.insert(first).second)
        continue;
      std::vector<Index> part = {first};
      for(std::size_t i = 0; i < part.size(); ++i)
        for_each_neighbor(part[i], [&](Index g) {
          if(is_in(g, faces) && are_connected(part[i], g) && is_taken.insert(g).second)
            part.push_back(g);
        });
      make_set(part);
      parts.push_back(std::move(part));
    }
    return parts;
  }

  template <typename Function> void for_each_neighbor(Index f, const Function& function) const {
    for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
      function(mesh_.face(mesh_.twin(h)));
  }

  bool bend_by_less(Index f, Index g, double cosine) const {
    const auto m = normal_of(mesh_, f), n = normal_of(mesh_, g);
    return m * n >= cosine * std::sqrt(m.squared_length() * n.squared_length());
  }

  bool lies_along(Index f, const Vector& axis, double sine) const {
    const Vector n = area_of(mesh_, f);
    return std::abs(axis * n) <= sine * std::sqrt(n.squared_length());
  }

  // The one that the faces lie along that do so roughly.
  Vector improved(const std::vector<Index>& faces, const Vector& axis, double sine) const {
    const auto [x, y, z] = Principal_axes::least_of_directions([&](const auto& f) {
      for(Index face : faces)
        if(lies_along(face, axis, sine)) {
          const Vector n = weighted(area_of(mesh_, face));
          f(Principal_axes::Vector{n.x(), n.y(), n.z()});
        }
    });
    return {x, y, z};
  }

  // Among them is that of a wall around an axis: one of the principal axes of its normals, and once
  // what is oblique is left out, nothing else.
  std::vector<Vector> axes_of(const std::vector<Index>& faces) const {
    const Principal_axes::Axes axes = Principal_axes::of_directions([&](const auto& f) {
      for(Index face : faces) {
        const Vector n = weighted(area_of(mesh_, face));
        f(Principal_axes::Vector{n.x(), n.y(), n.z()});
      }
    });
    std::vector<Vector> improved_axes;
    for(const auto& [x, y, z] : axes) {
      improved_axes.emplace_back(x, y, z);
      for(const double sine : {0.3, 0.1, 0.03, sine_of_straight})
        improved_axes.back() = improved(faces, improved_axes.back(), sine);
    }
    return improved_axes;
  }

  // As long as the square root of the area: squares are moments.
  static Vector weighted(const Vector& area) {
    const double length = std::sqrt(area.squared_length());
    return length > 0. ? area / std::sqrt(length) : area;
  }

  std::vector<std::vector<Index>> straight_parts(const std::vector<Index>& faces,
                                                 const Vector& axis) const {
    constexpr double smooth = 0.94; // the cosine of twenty degrees
    std::vector<Index> along;
    for(Index f : faces)
      if(lies_along(f, axis, sine_of_straight))
        along.push_back(f);
    std::vector<std::vector<Index>> parts;
    for(std::vector<Index>& part : parts_of(along, [](Index, Index) { return true; })) {
      bool goes_on = false;
      for(Index f : part)
        for_each_neighbor(f, [&](Index g) {
          goes_on |= is_in(g, faces) && !is_in(g, part) && bend_by_less(f, g, smooth);
        });
      if(!goes_on)
        parts.push_back(std::move(part));
    }
    return parts;
  }

  const Surgery_mesh& mesh_;
  const std::vector<Index>& wall_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_WALL_SECTIONS_H
