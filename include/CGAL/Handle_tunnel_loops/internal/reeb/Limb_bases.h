// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_LIMB_BASES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_LIMB_BASES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/depths_in_parts.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/length_across.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/measure_parts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Lets parts that are limbs begin where a person says that they do: where the girth jumps.

Where contours part, at a saddle, is as much a matter of where the function began: those that come
to a leg from the side part far down on it. Hence regions grow around the tips of limbs, by distance
on the surface. The length of their border to the power of 3/2 over their area falls along a limb,
also on a cone, and rises where they come out on a body. A limb is the region where it is least
before it rises for good; but a part of which it is even less stays. What a limb leaves of its part
goes to a part beside it of which more is left, or that is no limb, if it is not far more than that.
*/
class Limb_bases
{
public:
  /// \p part_of_vertex has the hubs, too. Both must outlive the object.
  Limb_bases(const Flat_mesh& mesh, std::vector<Index>& part_of_vertex)
      : mesh_(mesh)
      , part_(part_of_vertex)
      , paths_(part_of_vertex.size())
      , is_inner_(inner_halves(mesh, part_of_vertex))
      , is_claimed_(part_of_vertex.size(), 0)
      , is_in_region_(part_of_vertex.size(), 0) {
    for(Index v = 0; v < part_.size(); ++v)
      areas_.push_back(area_around(mesh, v));
  }

  /// \p tips has a vertex for each part that is a limb, `no_index` for others.
  void run(const std::vector<Index>& tips) {
    const std::vector<double> areas = areas_of_parts(tips.size());
    std::vector<double> borders(tips.size(), 0.);
    for(const Shared_border& border : shared_borders(mesh_, part_))
      for(const Index part : {border.part, border.other})
        borders[part] += border.length;
    std::vector<std::vector<Index>> limbs;
    for(Index part = 0; part < tips.size(); ++part)
      limbs.push_back(tips[part] == no_index
                          ? std::vector<Index>()
                          : limb(part, tips[part], areas[part], value(borders[part], areas[part])));
    for(Index part = 0; part < tips.size(); ++part)
      for(const Index v : limbs[part])
        if(is_claimed_[v] == 0) {
          is_claimed_[v] = 1;
          part_[v] = part;
        }
    give_away_rests(limbs, tips);
  }

private:
  struct Label
  {
    double distance = (std::numeric_limits<double>::max)();
    Index part = no_index;
  };

  // Of what no limb has claimed.
  std::vector<double> areas_of_parts(std::size_t number) const {
    std::vector<double> areas(number, 0.);
    for(Index v = 0; v < part_.size(); ++v)
      if(is_claimed_[v] == 0)
        areas[part_[v]] += areas_[v];
    return areas;
  }

  static double value(double girth, double area) { return girth * std::sqrt(girth) / area; }

  // Lengths of borders are means, while the region becomes a little larger. It does not grow into
  // the inner half of another part, but into half of its own at least: an end may be flat, or
  // ragged. Empty if the part itself is better.
  std::vector<Index> limb(Index part, Index tip, double area_of_part, double value_of_part) {
    constexpr double first_part = 0.05, step = 1.1, rise = 1.5;
    std::vector<Index> region;
    std::size_t size = 0; // of the limb
    double girth = 0., area = 0., least = (std::numeric_limits<double>::max)();
    double sum = 0., began = 0.; // of border and area, from this area on
    bool goes_on = true;
    paths_.clear();
    paths_.reach(tip, {0.});
    const auto visit = [&](Index v) {
      goes_on = is_inner_[v] == 0 || part_[v] == part;
      if(!goes_on)
        return;
      is_in_region_[v] = 1;
      region.push_back(v);
      for(const Index u : mesh_.ring(v))
        girth += (is_in_region_[u] != 0 ? -1. : 1.) * length_across(mesh_, v, u);
      area += areas_[v];
      sum += girth * areas_[v];
      reach_beside(v, [](Index) { return true; });
      if(began > 0. && area < step * began)
        return;
      if(began > 0.) {
        const double now = value(sum / (area - began), area);
        goes_on = now < rise * least || 2. * area < area_of_part;
        if(now < least) {
          least = now;
          size = region.size();
        }
      }
      began = area < first_part * area_of_part ? 0. : area;
      sum = 0.;
    };
    paths_.grow([&](double) { return goes_on; }, visit);
    for(const Index v : region)
      is_in_region_[v] = 0;
    region.resize(size);
    if(!(least < value_of_part))
      region.clear();
    return region;
  }

  void give_away_rests(const std::vector<std::vector<Index>>& limbs,
                       const std::vector<Index>& tips) {
    const std::vector<double> rests = areas_of_parts(limbs.size());
    std::vector<char> gives(limbs.size(), 0);
    constexpr double body = 4.; // how much more counts what is left of a part that is no limb
    for(Index v = 0; v < part_.size(); ++v)
      for(const Index u : mesh_.ring(v))
        if(const Index part = part_[v], other = part_[u];
           is_claimed_[v] == 0 && is_claimed_[u] == 0 && !limbs[part].empty() &&
           rests[part] < (tips[other] == no_index ? body : 1.) * rests[other] && part != other)
          gives[part] = 1;
    paths_.clear();
    for(Index v = 0; v < part_.size(); ++v)
      if(is_claimed_[v] == 0 && gives[part_[v]] == 0)
        paths_.reach(v, {0., part_[v]});
    paths_.grow([this](Index v) {
      part_[v] = paths_[v].part;
      reach_beside(v, [this](Index u) { return is_claimed_[u] == 0; });
    });
  }

  template <typename Predicate> void reach_beside(Index v, const Predicate& may_go_to) {
    for(const Index u : mesh_.ring(v)) {
      const double sum = paths_[v].distance + mesh_.edge_length(v, u);
      if(may_go_to(u) && sum < paths_[u].distance)
        paths_.reach(u, {sum, paths_[v].part});
    }
  }

  const Flat_mesh& mesh_;
  std::vector<Index>& part_;
  Shortest_paths<Label> paths_;
  std::vector<double> areas_;      // by vertex, as all that follows
  std::vector<char> is_inner_;     // of its part
  std::vector<char> is_claimed_;   // by a limb
  std::vector<char> is_in_region_; // that grows
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_LIMB_BASES_H
