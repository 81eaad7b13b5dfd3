// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REGION_LAYOUT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REGION_LAYOUT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Normals_around.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_proposal.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Way_of_removal.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/make_set.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Lays out the regions of a round so that no two of them share a vertex, and that none takes away
/// more than it must of the loops of others. Regions are proposed by many threads at a time as long
/// as none is claimed.
class Region_layout
{
public:
  explicit Region_layout(const Surgery_mesh& mesh)
      : mesh_(mesh)
      , is_claimed_(mesh.vertex_bound(), 0)
      , number_of_walks_at_(mesh.vertex_bound(), 0) {}

  /// has the wider regions of others stay clear of the vertices of a loop, each once.
  void reserve(const std::vector<Index>& vertices) {
    for(Index v : vertices)
      ++number_of_walks_at_[v];
  }

  /// what a way says, if there is such a region. \p reserved are the vertices that are reserved
  /// for this handle, in ascending order.
  std::optional<Removal_proposal> proposal(const Way_of_removal& way,
                                           const std::vector<Closed_walk>& walks,
                                           const std::vector<Index>& reserved) const {
    if(way.style == Way_of_removal::SUBDIVIDED_STRIP)
      return Removal_proposal::subdivided(mesh_, walks[way.choice]);
    std::optional<Cut_region> region = this->region(way, walks, reserved);
    if(!region)
      return std::nullopt;
    return Removal_proposal(mesh_, std::move(*region));
  }

  /// whether no region of the round that is claimed shares a vertex with it.
  bool is_free(const Removal_proposal& proposal) const {
    return std::none_of(proposal.out().begin(), proposal.out().end(), [this](Index f) {
      const Surgery_mesh::Face& c = mesh_.corners(f);
      return is_claimed_[c[0]] || is_claimed_[c[1]] || is_claimed_[c[2]];
    });
  }

  /// makes one that has these vertices one of the round.
  void claim(const std::vector<Index>& vertices) {
    for(Index v : vertices)
      is_claimed_[v] = 1;
  }

private:
  std::optional<Cut_region> region(const Way_of_removal& way,
                                   const std::vector<Closed_walk>& walks,
                                   const std::vector<Index>& reserved) const {
    if(!way.takes_both_loops())
      return strip(way, walks[way.choice], reserved);
    std::vector<Index> vertices;
    for(const Closed_walk& walk : walks)
      vertices.insert(vertices.end(), walk.begin(), walk.end());
    std::vector<Index> faces = Cut_region::faces_at(mesh_, vertices);
    if(way.style == Way_of_removal::KNOB)
      return is_compact(walks) ? knob(std::move(faces), way.rings) : std::nullopt;
    for(int ring = 0; ring < way.rings; ++ring)
      faces = Cut_region::with_ring(mesh_, faces);
    return Cut_region::whole(mesh_, std::move(faces));
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
  std::optional<Cut_region> knob(std::vector<Index> faces, int most_rings) const {
    int number_of_misses = 0;
    for(int ring = 0; ring < most_rings && number_of_misses < 2; ++ring) {
      faces = Cut_region::with_ring(mesh_, faces);
      std::optional<Cut_region> region = Cut_region::whole(mesh_, faces);
      if(!region) { // there is more than a handle
        ++number_of_misses;
        continue;
      }
      const Normals_around around(mesh_, *region);
      if(around.are_alike())
        return region;
      if(!around.have_a_direction())
        break; // nor will further rings
    }
    return std::nullopt;
  }

  std::optional<Cut_region> strip(const Way_of_removal& way,
                                  const Closed_walk& walk,
                                  const std::vector<Index>& reserved) const {
    const std::optional<Cut_region> region = around(walk, way.rings, reserved);
    if(way.style == Way_of_removal::STRIP || !region)
      return region;
    if(region->number_of_borders() == 1)
      return std::nullopt;
    const std::size_t border = way.style == Way_of_removal::BESIDE_LEFT ? 0 : 1;
    return Cut_region::around(mesh_, region->vertices_of(mesh_, border));
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
  // By vertex.
  std::vector<char> is_claimed_;
  std::vector<Index> number_of_walks_at_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REGION_LAYOUT_H
