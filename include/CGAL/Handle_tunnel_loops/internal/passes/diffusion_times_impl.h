// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DIFFUSION_TIMES_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DIFFUSION_TIMES_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Offset_classifier.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/diffusion_times.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// the vertices on both sides of the handle loops.
inline std::vector<Index> vertices_beside_handles(const Flat_mesh& mesh,
                                                  const std::vector<Flat_pair>& pairs) {
  const Offset_growth growth(mesh);
  std::vector<Index> vertices;
  for(const Flat_pair& pair : pairs)
    for(const Crossing& c : growth(pair.handle) >= growth(pair.tunnel) ? pair.handle : pair.tunnel)
      vertices.insert(vertices.end(), {c.left, c.right});
  return vertices;
}

/// the seeds of the components that none of the vertices is in.
inline std::vector<Index> seeds_of_others(const Flat_mesh& mesh,
                                          const std::vector<Index>& vertices) {
  std::vector<Index> seeds;
  std::vector<char> has_vertex(mesh.seeds.size(), 0);
  for(Index v : vertices)
    has_vertex[mesh.component[v]] = 1;
  for(Index component = 0; component < mesh.seeds.size(); ++component)
    if(!has_vertex[component])
      seeds.push_back(mesh.seeds[component]);
  return seeds;
}

/// for each of the seeds the vertex of its component that a front from there reaches last, by its
/// times: the end of a limb, where there are limbs.
inline std::vector<Index> vertices_reached_last(const Flat_mesh& mesh,
                                                const std::vector<Index>& seeds,
                                                const std::vector<Time>& times) {
  const auto is_later = [&](Index v, Index u) {
    return times[v] != times[u] ? times[v] > times[u] : mesh.original[v] < mesh.original[u];
  };
  std::vector<Index> last = mesh.seeds; // by component
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    Index& u = last[mesh.component[v]];
    if(times[v] != never && is_later(v, u))
      u = v;
  }
  std::vector<Index> vertices;
  for(Index seed : seeds)
    vertices.push_back(last[mesh.component[seed]]);
  return vertices;
}

CGAL_HTL_CORE std::vector<Time> diffusion_times(Passes& passes,
                                                const Pass_options& options,
                                                const Flat_mesh& mesh,
                                                const std::vector<Index>& sources,
                                                Progress& progress,
                                                Statistics& statistics) {
  std::vector<Index> start = sources;
  if(sources.empty() && mesh.genus > 0)
    start = vertices_beside_handles(mesh, Loop_pipeline(passes, options, progress).run(statistics));
  progress.start(Stage::DIFFUSION);
  const std::vector<Index> seeds = seeds_of_others(mesh, start);
  if(!seeds.empty())
    for(Index v : vertices_reached_last(mesh, seeds, passes.diffusion(seeds, progress, statistics)))
      start.push_back(v);
  std::vector<Time> times = passes.diffusion(start, progress, statistics);
  progress.end(Stage::DIFFUSION);
  return times;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_DIFFUSION_TIMES_IMPL_H
