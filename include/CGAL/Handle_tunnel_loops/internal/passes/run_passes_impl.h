// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_RUN_PASSES_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_RUN_PASSES_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Offset_classifier.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Coarse_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Field_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Host_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

CGAL_HTL_CORE std::unique_ptr<Passes> host_passes(Execution execution,
                                                  const Flat_mesh& mesh,
                                                  std::vector<Index> seeds,
                                                  const Pass_options& options,
                                                  std::string fallback) {
  return std::make_unique<Field_passes<Host_backend>>(
      execution, mesh, std::move(seeds), options, [execution, &mesh, fallback] {
        return std::make_unique<Host_backend>(execution, mesh, fallback);
      });
}

CGAL_HTL_CORE std::unique_ptr<Passes> coarse_passes(Execution execution,
                                                    const Flat_mesh& mesh,
                                                    std::vector<Index> seeds,
                                                    const Pass_options& options,
                                                    Make_passes make) {
  if(!Coarse_passes::do_pay(mesh))
    return make(mesh, std::move(seeds), options);
  return std::make_unique<Coarse_passes>(execution, mesh, std::move(seeds), options, make);
}

CGAL_HTL_CORE void run_initial_pass(Passes& passes, Progress& progress, Statistics& statistics) {
  progress.run(Stage::INITIAL, [&] { passes.initial_pass(progress, statistics); });
}

CGAL_HTL_CORE std::vector<Flat_pair> run_passes(Passes& passes,
                                                const Pass_options& options,
                                                Progress& progress,
                                                Statistics& statistics) {
  run_initial_pass(passes, progress, statistics);
  progress.run(Stage::TUNNEL, [&] { passes.tunnel_pass(progress, statistics); });
  if(options.do_refine_handles)
    progress.run(Stage::REFINE, [&] { passes.refinement_pass(progress, statistics); });
  if(options.do_tighten)
    progress.run(Stage::SHORTEN, [&] { passes.shorten(progress); });
  return passes.take_pairs();
}

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
  check_constants(options.field_constants);
  std::vector<Index> start = sources;
  if(sources.empty() && mesh.genus > 0)
    start = vertices_beside_handles(mesh, run_passes(passes, options, progress, statistics));
  progress.start(Stage::DIFFUSION);
  const std::vector<Index> seeds = seeds_of_others(mesh, start);
  if(!seeds.empty())
    for(Index v : vertices_reached_last(mesh, seeds, passes.diffusion(seeds, progress, statistics)))
      start.push_back(v);
  std::vector<Time> times = passes.diffusion(start, progress, statistics);
  progress.end(Stage::DIFFUSION);
  return times;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_RUN_PASSES_IMPL_H
