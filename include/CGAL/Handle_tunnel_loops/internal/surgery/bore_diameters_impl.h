// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_DIAMETERS_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_DIAMETERS_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Bore_search.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Bore_section.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Shape_judge.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/bore_diameters.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// of the wall of a bore.
inline std::optional<double> narrowest_diameter(const Surgery_mesh& mesh, const Cut_region& wall) {
  std::optional<double> least;
  for(const Bore_section& section : sections_of(mesh, wall.faces()))
    if(const std::optional<double> diameter = section.diameter();
       diameter && (!least || *diameter < *least))
      least = diameter;
  return least;
}

/// beside a loop, or else beside the shortest walk along it.
inline std::optional<Curve_off_vertices> curve_along(const Surgery_mesh& mesh,
                                                     const std::vector<Place_on_edge>& places) {
  std::optional<Curve_off_vertices> curve = Curve_off_vertices::beside(mesh, places);
  if(!curve)
    curve = Curve_off_vertices::beside(
        mesh, places_of(simple_part(led_off_boundary(mesh, walk_beside(mesh, places)))));
  return curve;
}

CGAL_HTL_CORE std::vector<std::optional<double>> bore_diameters(
    Execution execution, const Surgery_mesh& mesh, const std::vector<Removal_task>& tasks) {
  std::vector<std::optional<double>> diameters(tasks.size());
  const Concave_pieces pieces(execution, mesh, Shape_judge(mesh, false).outward());
  for_each_index(
      execution, tasks.size(),
      [&](std::size_t i) {
        const auto curve = curve_along(mesh, tasks[i].choices.front().places);
        if(!curve)
          return;
        // Alone, if it can be: the others that it meets have diameters of their own.
        const auto walls = Bore_search(mesh, pieces).walls_at(*curve);
        if(const auto& wall = walls.alone ? walls.alone : walls.joined)
          diameters[i] = narrowest_diameter(mesh, *wall);
      },
      1);
  return diameters;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_DIAMETERS_IMPL_H
