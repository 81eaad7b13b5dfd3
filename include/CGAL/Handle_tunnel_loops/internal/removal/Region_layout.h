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

#include <CGAL/Handle_tunnel_loops/internal/removal/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Removal_proposal.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/closed_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// How a region is laid along the loops of a handle.
struct Way_of_removal
{
  enum Style {
    STRIP,            ///< the faces at a loop, and some rings more
    BESIDE_LEFT,      ///< those at a loop some rings beside it
    BESIDE_RIGHT,     ///< ... on its other side
    SUBDIVIDED_STRIP, ///< the faces at a loop after a subdivision
    WHOLE,            ///< the faces at both loops, and some rings more
    KNOB              ///< the same, of a handle that sits on the surface like a knob on a lid
  };
  Style style;
  std::size_t choice; ///< the loop
  int rings;

  bool takes_both_loops() const { return style == WHOLE || style == KNOB; }
};

/// all ways, the first one first.
inline std::vector<Way_of_removal> ways_of_removal(std::size_t number_of_choices) {
  using Way = Way_of_removal;
  std::vector<Way> ways;
  if(number_of_choices == 2)
    ways.push_back({Way::KNOB, 0, 8});
  for(std::size_t i = 0; i < number_of_choices; ++i)
    ways.insert(ways.end(), {{Way::STRIP, i, 3},
                             {Way::STRIP, i, 0},
                             {Way::BESIDE_LEFT, i, 4},
                             {Way::BESIDE_RIGHT, i, 4}});
  if(number_of_choices == 2)
    for(int rings : {0, 1, 2, 4, 8, 12})
      ways.push_back({Way::WHOLE, 0, rings});
  for(std::size_t i = 0; i < number_of_choices; ++i)
    ways.push_back({Way::SUBDIVIDED_STRIP, i, 0});
  return ways;
}

/// The normals, as long as the areas, of the faces just beyond a border.
class Normals_around
{
  using Vector = Surgery_mesh::Kernel::Vector_3;

public:
  Normals_around(const Surgery_mesh& mesh, const Cut_region& region) {
    for(Index h : region.border(0)) {
      const Surgery_mesh::Face& c = mesh.corners(mesh.face(mesh.twin(h)));
      normals_.push_back(CGAL::normal(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2])));
      sum_ = sum_ + normals_.back();
      sum_of_areas_ += std::sqrt(normals_.back().squared_length());
    }
  }

  /// whether each is within 60 degrees of their mean.
  bool are_alike() const {
    return std::all_of(normals_.begin(), normals_.end(), [&](const Vector& n) {
      const double product = n * sum_;
      return product > 0. && 4. * product * product >= n.squared_length() * sum_.squared_length();
    });
  }

  /// whether they do not all but cancel.
  bool have_a_direction() const { return 2. * std::sqrt(sum_.squared_length()) >= sum_of_areas_; }

private:
  std::vector<Vector> normals_;
  Vector sum_ = CGAL::NULL_VECTOR;
  double sum_of_areas_ = 0.;
};

/// Lays out the regions of a round so that no two of them share a vertex, and that none takes away
/// more than it must of the loops of others.
class Region_layout
{
public:
  explicit Region_layout(const Surgery_mesh& mesh)
      : mesh_(mesh)
      , is_claimed_(mesh.vertex_bound(), 0)
      , number_of_walks_at_(mesh.vertex_bound(), 0) {}

  /// has wider regions stay clear of a loop, or (-1) not any more.
  void reserve(const Closed_walk& walk, int by) {
    for(Index v : walk)
      number_of_walks_at_[v] += by;
  }

  /// what a way says, if there is such a region.
  std::optional<Removal_proposal> proposal(const Way_of_removal& way,
                                           const std::vector<Closed_walk>& walks) const {
    if(way.style == Way_of_removal::SUBDIVIDED_STRIP)
      return Removal_proposal::subdivided(mesh_, walks[way.choice]);
    std::optional<Cut_region> region = this->region(way, walks);
    if(!region)
      return std::nullopt;
    return Removal_proposal(mesh_, std::move(*region));
  }

  /// whether no other region of the round is near; then it becomes one of them.
  bool claim(const Removal_proposal& proposal) {
    if(has_vertex(proposal.out(), [this](Index v) { return is_claimed_[v] != 0; }))
      return false;
    for(Index f : proposal.out())
      for(Index v : mesh_.corners(f))
        is_claimed_[v] = 1;
    return true;
  }

private:
  std::optional<Cut_region> region(const Way_of_removal& way,
                                   const std::vector<Closed_walk>& walks) const {
    if(!way.takes_both_loops())
      return strip(way, walks[way.choice]);
    std::vector<Index> vertices;
    for(const Closed_walk& walk : walks)
      vertices.insert(vertices.end(), walk.begin(), walk.end());
    if(way.style == Way_of_removal::WHOLE)
      return Cut_region::whole(mesh_, vertices, way.rings);
    return is_compact(walks) ? knob(vertices, way.rings) : std::nullopt;
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
  std::optional<Cut_region> knob(const std::vector<Index>& vertices, int most_rings) const {
    int number_of_misses = 0;
    for(int rings = 1; rings <= most_rings && number_of_misses < 2; ++rings) {
      std::optional<Cut_region> region = Cut_region::whole(mesh_, vertices, rings);
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

  std::optional<Cut_region> strip(const Way_of_removal& way, const Closed_walk& walk) const {
    const std::optional<Cut_region> region = around(walk, way.rings);
    if(way.style == Way_of_removal::STRIP || !region)
      return region;
    if(region->number_of_borders() == 1)
      return std::nullopt;
    const std::size_t border = way.style == Way_of_removal::BESIDE_LEFT ? 0 : 1;
    return Cut_region::around(mesh_, region->vertices_of(mesh_, border));
  }

  // As many rings as fit.
  std::optional<Cut_region> around(const std::vector<Index>& vertices, int rings) const {
    std::optional<Cut_region> region = Cut_region::around(mesh_, vertices);
    for(int ring = 0; region && ring < rings; ++ring)
      for(std::size_t border = 0; border < region->number_of_borders(); ++border)
        if(std::optional<Cut_region> wider = region->wider(mesh_, border))
          if(is_fit(*wider, border, vertices.size()))
            region = std::move(wider);
    return region;
  }

  bool is_fit(const Cut_region& region, std::size_t border, std::size_t length_of_walk) const {
    const bool is_strip = region.number_of_borders() == 2;
    if(is_strip && 4 * region.border(border).size() > 5 * length_of_walk + 8)
      return false;
    return !has_vertex(region.faces(),
                       [this](Index v) { return is_claimed_[v] || number_of_walks_at_[v] > 0; });
  }

  template <typename Predicate>
  bool has_vertex(const std::vector<Index>& faces, const Predicate& predicate) const {
    return std::any_of(faces.begin(), faces.end(), [&](Index f) {
      const Surgery_mesh::Face& c = mesh_.corners(f);
      return std::any_of(c.begin(), c.end(), predicate);
    });
  }

  const Surgery_mesh& mesh_;
  // By vertex.
  std::vector<char> is_claimed_;
  std::vector<int> number_of_walks_at_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REGION_LAYOUT_H
