// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_LAYOUT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_LAYOUT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Bore_search.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Growing_faces.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Handle_surgery.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Region_choice.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rings_around.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Lays out the regions of a round so that no two of them share a vertex, and that none takes away
/// more than it must of the loops of others. Regions are proposed by many threads at a time as long
/// as none is claimed.
class Region_layout
{
public:
  Region_layout(const Surgery_mesh& mesh, const Concave_pieces& pieces)
      : mesh_(mesh)
      , pieces_(pieces)
      , is_claimed_(mesh.vertex_bound(), 0)
      , number_of_walks_at_(mesh.vertex_bound(), 0)
      , marks_([&mesh] { return std::make_unique<Face_marks>(mesh); }) {}

  /// has the wider regions of others stay clear of the vertices of a loop, each once.
  void reserve(const std::vector<Index>& vertices) {
    for(Index v : vertices)
      ++number_of_walks_at_[v];
  }

  /// with the region that is chosen, if there is such a one. \p curve is beside the loop of the
  /// choice, if there is one, \p reserved are the vertices that are reserved for this handle, in
  /// ascending order, \p rings are around its walks.
  std::optional<Handle_surgery> surgery(const Region_choice& choice,
                                        const std::optional<Curve_off_vertices>& curve,
                                        const std::vector<Closed_walk>& walks,
                                        const std::vector<Index>& reserved,
                                        Rings_around& rings) const {
    if(choice.style == Region_choice::STRIP)
      return curve ? std::optional<Handle_surgery>(std::in_place, mesh_, *curve) : std::nullopt;
    std::optional<Cut_region> region = this->region(choice, curve, walks, reserved, rings);
    if(!region)
      return std::nullopt;
    return Handle_surgery(mesh_, std::move(*region));
  }

  /// of some vertices.
  Rings_around rings_around(std::vector<Index> vertices) const {
    return Rings_around(mesh_, marks_, std::move(vertices));
  }

  /// whether no region of the round that is claimed shares one of these vertices.
  bool is_free(const std::vector<Index>& vertices) const {
    return std::none_of(vertices.begin(), vertices.end(),
                        [this](Index v) { return is_claimed_[v]; });
  }

  /// makes one that has these vertices one of the round.
  void claim(const std::vector<Index>& vertices) {
    for(Index v : vertices)
      is_claimed_[v] = 1;
  }

private:
  std::optional<Cut_region> region(const Region_choice& choice,
                                   const std::optional<Curve_off_vertices>& curve,
                                   const std::vector<Closed_walk>& walks,
                                   const std::vector<Index>& reserved,
                                   Rings_around& rings) const {
    if(choice.style == Region_choice::BORE)
      return curve ? bore(*curve, choice.rings > 0) : std::nullopt;
    if(choice.style == Region_choice::RINGS)
      return around(walks[choice.loop], choice.rings, reserved);
    if(choice.style == Region_choice::WHOLE)
      return rings.region(choice.rings);
    return is_compact(walks) ? knob(rings, choice.rings) : std::nullopt;
  }

  std::optional<Cut_region> bore(const Curve_off_vertices& curve,
                                 bool takes_bores_that_meet) const {
    Bore_search::Walls walls = Bore_search(mesh_, pieces_).walls_at(curve);
    return takes_bores_that_meet && walls.joined ? std::move(walls.joined) : std::move(walls.alone);
  }

  // Whether no loop is many times as long as another one, as between two shells.
  static bool is_compact(const std::vector<Closed_walk>& walks) {
    const auto is_shorter = [](const Closed_walk& a, const Closed_walk& b) {
      return a.size() < b.size();
    };
    const auto [least, most] = std::minmax_element(walks.begin(), walks.end(), is_shorter);
    return most->size() <= 8 * least->size();
  }

  // The first ring around two loops beyond which the surface is like a lid. Nothing is left of the
  // handle if a disc takes the place of what is within.
  std::optional<Cut_region> knob(Rings_around& rings, int most_rings) const {
    int number_of_misses = 0;
    for(int ring = 1; ring <= most_rings && number_of_misses < 2; ++ring) {
      std::optional<Cut_region> region = rings.region(ring);
      if(!region) { // there is more than a handle
        ++number_of_misses;
        continue;
      }
      const Normals around = normals_around(*region);
      if(are_alike(around))
        return region;
      if(do_cancel(around))
        break; // and so they will for further rings
    }
    return std::nullopt;
  }

  using Normals = std::vector<Surgery_mesh::Kernel::Vector_3>;

  // Twice as long as the areas, of the faces just beyond the border; some may have none.
  Normals normals_around(const Cut_region& region) const {
    Normals normals;
    for(Index h : region.border(0)) {
      const Surgery_mesh::Face& c = mesh_.corners(mesh_.face(mesh_.twin(h)));
      const Surgery_mesh::Point& p = mesh_.point(c[0]);
      normals.push_back(CGAL::cross_product(mesh_.point(c[1]) - p, mesh_.point(c[2]) - p));
    }
    return normals;
  }

  static Normals::value_type sum(const Normals& normals) {
    return std::accumulate(normals.begin(), normals.end(), Normals::value_type(NULL_VECTOR));
  }

  // Whether each is within 60 degrees of their mean.
  static bool are_alike(const Normals& normals) {
    const auto mean = sum(normals);
    return std::all_of(normals.begin(), normals.end(), [&](const auto& n) {
      const double product = n * mean;
      return product > 0. && 4. * product * product >= n.squared_length() * mean.squared_length();
    });
  }

  // Whether they have all but no direction.
  static bool do_cancel(const Normals& normals) {
    double sum_of_areas = 0.;
    for(const auto& n : normals)
      sum_of_areas += std::sqrt(n.squared_length());
    return !(2. * std::sqrt(sum(normals).squared_length()) >= sum_of_areas);
  }

  // As many rings as fit.
  std::optional<Cut_region>
  around(const Closed_walk& vertices, int rings, const std::vector<Index>& reserved) const {
    std::optional<Cut_region> region = Cut_region::around(mesh_, vertices);
    for(int ring = 0; region && ring < rings; ++ring)
      for(std::size_t border = 0; border < region->number_of_borders(); ++border)
        if(std::optional<Cut_region> wider = region->wider(mesh_, border))
          if(is_fit(*wider, border, vertices.size(), reserved))
            region = std::move(wider);
    return region;
  }

  bool is_fit(const Cut_region& region,
              std::size_t border,
              std::size_t length_of_walk,
              const std::vector<Index>& reserved) const {
    const bool is_strip = region.number_of_borders() == 2;
    if(is_strip && 4 * region.border(border).size() > 5 * length_of_walk + 8)
      return false;
    const Closed_walk ring = region.vertices_of(mesh_, border);
    return std::none_of(ring.begin(), ring.end(), [&](Index v) {
      return is_claimed_[v] || number_of_walks_at_[v] > 1 ||
             (number_of_walks_at_[v] == 1 && !is_in(v, reserved));
    });
  }

  const Surgery_mesh& mesh_;
  const Concave_pieces& pieces_;
  // By vertex.
  std::vector<char> is_claimed_;
  std::vector<Index> number_of_walks_at_;
  mutable Rings_around::Marks marks_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_LAYOUT_H
