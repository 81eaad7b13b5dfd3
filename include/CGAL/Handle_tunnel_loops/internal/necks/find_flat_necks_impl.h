// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_FIND_FLAT_NECKS_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_FIND_FLAT_NECKS_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/necks/Narrow_places.h>
#include <CGAL/Handle_tunnel_loops/internal/necks/Neck_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/necks/contour_above.h>
#include <CGAL/Handle_tunnel_loops/internal/necks/edge_distances.h>
#include <CGAL/Handle_tunnel_loops/internal/necks/find_flat_necks.h>
#include <CGAL/Handle_tunnel_loops/internal/necks/simple_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/necks/vertex_areas.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_sweep.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Looks for necks on the contours of the distance from a place in each component. Far from it
/// compared with the length of a neck they pass through the neck all but straight.
class Neck_search
{
public:
  Neck_search(const Flat_mesh& mesh,
              const std::vector<double>& vertex_areas,
              const Neck_limits& limits)
      : mesh_(mesh)
      , vertex_areas_(vertex_areas)
      , limits_(limits) {}

  /// necks that may meet.
  std::vector<Flat_neck> run(Execution execution, const std::vector<float>& distance) const {
    const Sweep_order order(
        execution, mesh_, [&](Index v) { return ordering_key(static_cast<double>(distance[v])); });
    const std::vector<Star> stars = sweep_stars(execution, mesh_, order);
    const std::uint64_t most_steps = 8 * std::uint64_t(mesh_.neighbor.size());
    constexpr double no_samples = std::numeric_limits<float>::max();
    const Flat_reeb_graph graph = Reeb_sweep(mesh_, order, stars, most_steps, no_samples).run();
    Narrow_places places(mesh_, order, stars, graph, vertex_areas_,
                         oblique * limits_.maximal_length, negligible * limits_.minimal_share);
    std::vector<Flat_neck> necks;
    Loop_tightening tightening(mesh_);
    for(Index v : places.find())
      add_if_neck(contour_above(mesh_, order, distance, v), tightening, necks);
    return necks;
  }

private:
  /// by how much a contour close to a neck may be longer than it.
  static constexpr double oblique = 4.;

  /// of the smallest piece: what is not looked at along the way.
  static constexpr double negligible = 0.1;

  void add_if_neck(const Crossing_loop& contour,
                   Loop_tightening& tightening,
                   std::vector<Flat_neck>& necks) const {
    Crossing_loop tight = contour;
    tightening.tighten(tight);
    if(tight.empty())
      return;
    for(const Crossing_loop& loop : {tight, contour}) {
      const double size = length(mesh_, loop);
      if(size < limits_.maximal_length && is_simple(loop)) {
        necks.push_back({loop, size, 0.});
        return;
      }
    }
  }

  const Flat_mesh& mesh_;
  const std::vector<double>& vertex_areas_;
  Neck_limits limits_;
};

/// keeps disjoint necks between pieces that are large enough, short ones rather than long ones.
inline std::vector<Flat_neck> choose_necks(const Flat_mesh& mesh,
                                           const std::vector<double>& vertex_areas,
                                           double minimal_share,
                                           std::vector<Flat_neck> found) {
  std::stable_sort(found.begin(), found.end(),
                   [](const Flat_neck& a, const Flat_neck& b) { return a.length < b.length; });
  Disjoint_loops disjoint(mesh);
  std::vector<Crossing_loop> loops;
  for(Flat_neck& neck : found)
    if(disjoint.take(neck.loop))
      loops.push_back(std::move(neck.loop));
  if(loops.empty())
    return {};
  Neck_pieces pieces(mesh, loops, vertex_areas);
  const bool all_separate = pieces.is_forest();
  CGAL_assertion_msg(all_separate, "each contour on a bridge of the Reeb graph separates");
  if(!all_separate)
    return {};
  const std::vector<char> is_kept = pieces.kept(minimal_share);
  const std::vector<double> shares = pieces.smaller_shares(is_kept);
  std::vector<Flat_neck> necks;
  for(std::size_t i = 0; i < loops.size(); ++i)
    if(is_kept[i] != 0) {
      const double size = length(mesh, loops[i]);
      necks.push_back({std::move(loops[i]), size, shares[i]});
    }
  return necks;
}

/// the distances from any place, from one furthest from there, and from one furthest from that: a
/// neck on which, or around which, one of the contours is not as it should be is far from another.
inline std::array<std::vector<float>, 3> distances_from_ends(const Flat_mesh& mesh) {
  std::array<std::vector<float>, 3> distances;
  std::vector<Index> sources = mesh.seeds;
  for(std::vector<float>& distance : distances) {
    distance = edge_distances(mesh, sources);
    sources = furthest_vertices(mesh, distance);
  }
  return distances;
}

CGAL_HTL_CORE std::vector<Flat_neck>
find_flat_necks(Execution execution, const Flat_mesh& mesh, const Neck_limits& limits) {
  const std::vector<double> areas = vertex_areas(execution, mesh);
  const std::array<std::vector<float>, 3> distances = distances_from_ends(mesh);
  const Neck_search search(mesh, areas, limits);
  std::array<std::vector<Flat_neck>, 3> found;
  for_each_index(
      execution, found.size(),
      [&](std::size_t i) { found[i] = search.run(execution, distances[i]); }, 1);
  std::vector<Flat_neck> all;
  for(std::vector<Flat_neck>& necks : found)
    std::move(necks.begin(), necks.end(), std::back_inserter(all));
  return choose_necks(mesh, areas, limits.minimal_share, std::move(all));
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_NECKS_FIND_FLAT_NECKS_IMPL_H
