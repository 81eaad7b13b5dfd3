// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORES_AROUND_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORES_AROUND_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Bore_search.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Bore_section.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Shape_judge.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Wall_sections.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/bores_around.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// in the wall of a bore.
inline std::optional<Cylinder> narrowest_cylinder(const Surgery_mesh& mesh,
                                                  const Cut_region& wall) {
  std::optional<Cylinder> narrowest;
  for(const Bore_section& section : Wall_sections(mesh, wall.faces())())
    if(const std::optional<Cylinder> cylinder = section.cylinder();
       cylinder && (!narrowest || cylinder->diameter < narrowest->diameter))
      narrowest = cylinder;
  return narrowest;
}

/// with all that goes on along the same axis beyond the bores that it meets, but for a hundredth of
/// the diameter, by which a bore may fail to be round, too.
inline Cylinder drilling(const Surgery_mesh& mesh, const Cylinder& part, const Cut_region& wall) {
  Cylinder all = part;
  for(const Bore_section& section : Wall_sections(mesh, wall.faces())())
    if(const std::optional<Cylinder> cylinder = section.cylinder();
       cylinder && part.distance(*cylinder) <= 0.01 * part.diameter)
      all.extend(*cylinder);
  return all;
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

CGAL_HTL_CORE std::vector<std::optional<Cylinder>>
bores_around(Execution execution,
             const Surgery_mesh& mesh,
             const std::vector<std::vector<Place_on_edge>>& loops) {
  std::vector<std::optional<Cylinder>> bores(loops.size());
  const Concave_pieces pieces(execution, mesh, Shape_judge(mesh, false).outward());
  for_each_index(
      execution, loops.size(),
      [&](std::size_t i) {
        const auto curve = curve_along(mesh, loops[i]);
        if(!curve)
          return;
        // Alone, if it can be: the others that it meets have diameters of their own.
        const auto walls = Bore_search(mesh, pieces).walls_at(*curve);
        if(const auto& wall = walls.alone ? walls.alone : walls.joined)
          bores[i] = narrowest_cylinder(mesh, *wall);
        if(bores[i] && walls.joined)
          bores[i] = drilling(mesh, *bores[i], *walls.joined);
      },
      1);
  return bores;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORES_AROUND_IMPL_H
