// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SEARCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SEARCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Polygon_in_space.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rim.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds the wall of the bore that a tunnel loop goes around: the faces that are reached from it
without passing a convex edge of the solid, if they are bounded by the mouths of the bore. Bores
that meet have one wall. If a mouth lies at the bottom of a counterbore, the wall of that belongs to
it.
*/
class Bore_search
{
public:
  /// \p outward is 1 if the faces point out of the solid, -1 if they point into it.
  Bore_search(const Surgery_mesh& mesh, double outward)
      : mesh_(mesh)
      , outward_(outward) {}

  /// of a bore that a loop goes around. Gives up where the wall is many times as
  /// large, or has many mouths. Near linear in its size.
  std::optional<Cut_region> wall_at(const Curve_off_vertices& loop) const {
    const std::vector<Index> faces = loop.faces();
    const std::size_t most = most_tried + 64 * faces.size();
    std::optional<Cut_region> wall = wall_of(flood(faces, most), loop, most);
    // At a mouth, some of the faces are beyond it.
    std::vector<Index> tried;
    std::size_t number = 0; // of faces reached in vain, but for those from where there is no end
    for(std::size_t i = 0; i < faces.size() && !wall && number < most_tried; ++i) {
      if(is_in(faces[i], tried))
        continue;
      Flood reached = flood({faces[i]}, most_tried);
      tried.insert(tried.end(), reached.faces.begin(), reached.faces.end());
      make_set(tried);
      if(reached.is_bounded) {
        number += reached.faces.size();
        wall = wall_of(std::move(reached), loop, most_tried + 64);
      }
    }
    return wall;
  }

private:
  static constexpr std::size_t most_tried = 4000;

  // What is reached without passing a convex edge.
  struct Flood
  {
    std::vector<Index> faces; // in ascending order
    bool is_bounded;          // these are all, and none of them is in a cap
  };

  // A counterbore may have so many faces.
  std::optional<Cut_region>
  wall_of(Flood reached, const Curve_off_vertices& loop, std::size_t most) const {
    if(!reached.is_bounded)
      return std::nullopt;
    std::optional<Cut_region> wall = Cut_region::wall(mesh_, std::move(reached.faces));
    constexpr std::size_t most_mouths = 16;
    if(!wall || wall->number_of_borders() > most_mouths)
      return std::nullopt;
    for(std::size_t border = 0; border < wall->number_of_borders();)
      if(std::optional<Cut_region> wider = with_counterbore(*wall, border, most)) {
        wall = std::move(wider);
        border = 0;
      } else
        ++border;
    constexpr double most_growth = 1.5;
    bool is_any_flush = false;
    for(std::size_t border = 0; border < wall->number_of_borders(); ++border)
      if(is_flush(rim_of(mesh_, *wall, border)))
        is_any_flush = true;
      else if(!(length(*wall, border) <= most_growth * loop.length()))
        return std::nullopt;
    return is_any_flush ? std::move(wall) : std::nullopt;
  }

  Flood flood(const std::vector<Index>& begin, std::size_t most) const {
    Flood flood{begin, true};
    std::vector<Index>& reached = flood.faces;
    std::unordered_set<Index> is_reached(begin.begin(), begin.end());
    for(std::size_t i = 0; i < reached.size() && flood.is_bounded; ++i) {
      flood.is_bounded = reached.size() <= most && !mesh_.is_in_cap(reached[i]);
      for(Index h : {3 * reached[i], 3 * reached[i] + 1, 3 * reached[i] + 2})
        if(!is_convex(h) && is_reached.insert(mesh_.face(mesh_.twin(h))).second)
          reached.push_back(mesh_.face(mesh_.twin(h)));
    }
    make_set(reached);
    return flood;
  }

  // By more than five degrees.
  bool is_convex(Index h) const {
    constexpr double cosine = 0.996;
    const Index g = mesh_.twin(h);
    const auto m = normal_of(mesh_, mesh_.face(h)), n = normal_of(mesh_, mesh_.face(g));
    const double lengths = m.squared_length() * n.squared_length();
    if(lengths == 0. || m * n >= cosine * std::sqrt(lengths))
      return false;
    const Surgery_mesh::Point &p = mesh_.point(mesh_.source(h)),
                              &q = mesh_.point(mesh_.target(mesh_.next(g)));
    double height = 0.; // of the other face above this one
    for(int axis = 0; axis < 3; ++axis)
      height += m[axis] * (q[axis] / 2. - p[axis] / 2.);
    return outward_ * height < 0.;
  }

  // A ring around a mouth, up to one that is flush with what is around it, and not much larger.
  std::optional<Cut_region>
  with_counterbore(const Cut_region& wall, std::size_t border, std::size_t most) const {
    constexpr double most_growth = 2.5;
    if(!Scaled_polygon(rim_of(mesh_, wall, border)).is_flat())
      return std::nullopt;
    std::vector<Index> beyond;
    for(Index h : wall.border(border))
      beyond.push_back(mesh_.face(mesh_.twin(h)));
    make_set(beyond);
    auto [ring, is_bounded] = flood(beyond, most);
    if(!is_bounded)
      return std::nullopt;
    const std::size_t number = wall.faces().size() + ring.size();
    ring.insert(ring.end(), wall.faces().begin(), wall.faces().end());
    make_set(ring);
    if(ring.size() != number)
      return std::nullopt; // it leads back to the wall
    std::optional<Cut_region> wider = Cut_region::wall(mesh_, std::move(ring));
    if(!wider || wider->number_of_borders() != wall.number_of_borders())
      return std::nullopt;
    const std::size_t outer = new_border(*wider, wall);
    if(outer == wider->number_of_borders() ||
       !(length(*wider, outer) <= most_growth * length(wall, border)))
      return std::nullopt;
    return is_flush(rim_of(mesh_, *wider, outer)) ? wider : std::nullopt;
  }

  // The first border that is none of another wall.
  std::size_t new_border(const Cut_region& wider, const Cut_region& wall) const {
    std::size_t i = 0;
    while(i < wider.number_of_borders() && wall.contains(mesh_.face(wider.border(i).front())))
      ++i;
    return i;
  }

  double length(const Cut_region& region, std::size_t border) const {
    double sum = 0.;
    for(Index h : region.border(border))
      sum += distance(mesh_, mesh_.source(h), mesh_.target(h));
    return sum;
  }

  const Surgery_mesh& mesh_;
  const double outward_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SEARCH_H
