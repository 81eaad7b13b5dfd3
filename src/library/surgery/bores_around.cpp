// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/surgery/bores_around.h>

#include <CGAL/Handle_tunnel_loops/internal/surgery/Bore_search.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Bore_section.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Concave_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Shape_judge.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Wall_sections.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What is all around the axis of a bore, and the cylinder through it.
struct Round_section
{
  Bore_section section;
  Cylinder cylinder;
};

/// of faces given in ascending order.
static void add_round_sections(const Surgery_mesh& mesh,
                               const std::vector<Index>& faces,
                               std::vector<Round_section>& round) {
  for(const Bore_section& section : Wall_sections(mesh, faces)())
    if(const std::optional<Cylinder> cylinder = section.cylinder())
      round.push_back({section, *cylinder});
}

/// in the wall of bores that meet. The edges where they do may bend so little that the wall of one
/// would seem to go on in that of another: its axis would not be known.
static std::vector<Round_section> round_sections_between_edges(const Surgery_mesh& mesh,
                                                               const Concave_pieces& pieces,
                                                               const Cut_region& wall) {
  std::map<Index, std::vector<Index>> faces; // by piece
  for(Index f : wall.faces())
    faces[pieces.piece(f)].push_back(f);
  std::vector<Round_section> round;
  for(const auto& piece : faces)
    add_round_sections(mesh, piece.second, round);
  return round;
}

/// of a part of a bore, by all parts that it meets: they are of one drilling if they lie on the
/// cylinder through the longest of them, which is known best.
static Cylinder drilling(const Round_section& part, std::vector<Round_section> parts) {
  for(parts.push_back(part);;) {
    Cylinder whole = std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
                       return std::tie(a.cylinder.length, b.cylinder.first_face) <
                              std::tie(b.cylinder.length, a.cylinder.first_face);
                     })->cylinder;
    bool is_found = false;
    std::vector<Round_section> others;
    for(const Round_section& other : parts)
      if(other.section.extend(whole))
        is_found |= other.cylinder.first_face == part.cylinder.first_face;
      else
        others.push_back(other);
    if(is_found)
      return whole;
    parts.swap(others);
  }
}

/// beside a loop, or else beside the shortest walk along it.
static std::optional<Curve_off_vertices> curve_along(const Surgery_mesh& mesh,
                                                     const std::vector<Place_on_edge>& places) {
  std::optional<Curve_off_vertices> curve = Curve_off_vertices::beside(mesh, places);
  if(!curve)
    curve = Curve_off_vertices::beside(
        mesh, places_of(simple_part(led_off_boundary(mesh, walk_beside(mesh, places)))));
  return curve;
}

std::vector<std::optional<Cylinder>>
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
        if(!walls.alone && !walls.joined)
          return;
        std::vector<Round_section> sections;
        add_round_sections(mesh, (walls.alone ? walls.alone : walls.joined)->faces(), sections);
        const auto narrowest =
            std::min_element(sections.begin(), sections.end(), [](const auto& a, const auto& b) {
              return a.cylinder.diameter < b.cylinder.diameter;
            });
        if(narrowest != sections.end())
          bores[i] =
              walls.joined
                  ? drilling(*narrowest, round_sections_between_edges(mesh, pieces, *walls.joined))
                  : narrowest->cylinder;
      },
      1);
  return bores;
}

} // namespace CGAL::Handle_tunnel_loops::internal
