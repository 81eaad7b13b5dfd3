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
#include <iterator>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds the wall of the bore that a tunnel loop goes around: the faces that are reached from it
without passing a convex edge of the solid, if they are bounded by the mouths of the bore. If a
mouth lies at the bottom of a counterbore, the wall of that belongs to it. Where bores meet there
are convex edges; if so wanted, what is beyond a mouth in no plane belongs to the wall, too. One
mouth lies in a plane, or all but does: what is rounded everywhere is no bore.
*/
class Bore_search
{
public:
  /// \p outward is 1 if the faces point out of the solid, -1 if they point into it.
  Bore_search(const Surgery_mesh& mesh, double outward, bool takes_bores_that_meet)
      : mesh_(mesh)
      , outward_(outward)
      , takes_bores_that_meet_(takes_bores_that_meet) {}

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
    while(std::optional<Cut_region> wider = widened(*wall, most)) {
      wall = std::move(wider);
      if(wall->number_of_borders() > most_mouths)
        return std::nullopt;
    }
    return are_mouths_closed_well(*wall, loop.length()) ? std::move(wall) : std::nullopt;
  }

  bool is_flush_at(const Cut_region& wall, std::size_t border) const {
    return is_flush(rim_of(mesh_, wall, border));
  }

  std::size_t number_of_flush_mouths(const Cut_region& wall) const {
    std::size_t number = 0;
    for(std::size_t border = 0; border < wall.number_of_borders(); ++border)
      number += is_flush_at(wall, border);
    return number;
  }

  // Whether each is flush; or at least one is nearly so, and the others are narrow.
  bool are_mouths_closed_well(const Cut_region& wall, double length_of_loop) const {
    constexpr double most_growth = 1.5;
    if(takes_bores_that_meet_)
      return number_of_flush_mouths(wall) == wall.number_of_borders();
    bool is_any_flush = false;
    for(std::size_t border = 0; border < wall.number_of_borders(); ++border) {
      const bool is_flush = is_flush_at(wall, border);
      is_any_flush |= is_flush || is_nearly_flush(rim_of(mesh_, wall, border));
      if(!is_flush && !(length(wall, border) <= most_growth * length_of_loop))
        return false;
    }
    return is_any_flush;
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

  // With what is beyond one of the mouths, if that belongs to it. What has no mouth in a plane is
  // no bore that others could meet.
  std::optional<Cut_region> widened(const Cut_region& wall, std::size_t most) const {
    const bool may_meet = takes_bores_that_meet_ && number_of_flush_mouths(wall) > 0;
    for(std::size_t border = 0; border < wall.number_of_borders(); ++border) {
      std::optional<Cut_region> wider = with_counterbore(wall, border, most);
      if(!wider && may_meet)
        wider = with_bore_that_meets(wall, border, most);
      if(wider)
        return wider;
    }
    return std::nullopt;
  }

  // A ring around a mouth, up to one that is flush with what is around it, and not much larger.
  std::optional<Cut_region>
  with_counterbore(const Cut_region& wall, std::size_t border, std::size_t most) const {
    if(!Scaled_polygon(rim_of(mesh_, wall, border)).is_flat())
      return std::nullopt;
    std::optional<Cut_region> wider = with_faces_beyond(wall, border, most);
    if(!wider || wider->number_of_borders() != wall.number_of_borders())
      return std::nullopt;
    const std::vector<std::size_t> outer = new_borders(*wider, wall);
    const bool is_ring = outer.size() == 1 && is_not_much_longer(*wider, outer[0], wall, border);
    return is_ring && is_flush_at(*wider, outer[0]) ? wider : std::nullopt;
  }

  // Another bore leads to mouths of its own. If there is only one of these, and much larger, it is
  // the edge of a pocket.
  std::optional<Cut_region>
  with_bore_that_meets(const Cut_region& wall, std::size_t border, std::size_t most) const {
    if(is_flush_at(wall, border))
      return std::nullopt;
    std::optional<Cut_region> wider = with_faces_beyond(wall, border, most);
    if(!wider)
      return std::nullopt;
    const std::vector<std::size_t> outer = new_borders(*wider, wall);
    const bool is_pocket = outer.size() == 1 && !is_not_much_longer(*wider, outer[0], wall, border);
    return is_pocket ? std::nullopt : wider;
  }

  std::optional<Cut_region>
  with_faces_beyond(const Cut_region& wall, std::size_t border, std::size_t most) const {
    std::vector<Index> beyond;
    for(Index h : wall.border(border))
      beyond.push_back(mesh_.face(mesh_.twin(h)));
    make_set(beyond);
    const auto [faces, is_bounded] = flood(beyond, most);
    if(!is_bounded)
      return std::nullopt;
    std::vector<Index> all;
    std::set_union(wall.faces().begin(), wall.faces().end(), faces.begin(), faces.end(),
                   std::back_inserter(all));
    const bool leads_back = all.size() != wall.faces().size() + faces.size();
    return leads_back || all.size() > most ? std::nullopt : Cut_region::wall(mesh_, std::move(all));
  }

  // The borders that are none of another wall.
  std::vector<std::size_t> new_borders(const Cut_region& wider, const Cut_region& wall) const {
    std::vector<std::size_t> borders;
    for(std::size_t i = 0; i < wider.number_of_borders(); ++i)
      if(!wall.contains(mesh_.face(wider.border(i).front())))
        borders.push_back(i);
    return borders;
  }

  bool is_not_much_longer(const Cut_region& wider,
                          std::size_t outer,
                          const Cut_region& wall,
                          std::size_t border) const {
    constexpr double most_growth = 2.5;
    return length(wider, outer) <= most_growth * length(wall, border);
  }

  double length(const Cut_region& region, std::size_t border) const {
    double sum = 0.;
    for(Index h : region.border(border))
      sum += distance(mesh_, mesh_.source(h), mesh_.target(h));
    return sum;
  }

  const Surgery_mesh& mesh_;
  const double outward_;
  const bool takes_bores_that_meet_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SEARCH_H
