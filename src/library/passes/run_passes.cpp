// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Offset_classifier.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Coarse_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Field_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Host_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/diffusion.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

std::shared_ptr<Passes> host_passes(Execution execution,
                                    const Flat_mesh& mesh,
                                    std::vector<Index> seeds,
                                    const Pass_options& options,
                                    std::string fallback) {
  return std::make_unique<Field_passes<Host_backend>>(
      execution, mesh, std::move(seeds), options, [execution, &mesh, fallback] {
        return std::make_unique<Host_backend>(execution, mesh, fallback);
      });
}

std::shared_ptr<Passes> coarse_passes(Execution execution,
                                      const Flat_mesh& mesh,
                                      std::vector<Index> seeds,
                                      const Pass_options& options,
                                      Make_passes make) {
  if(!Coarse_passes::do_pay(mesh))
    return make(mesh, std::move(seeds), options);
  return std::make_unique<Coarse_passes>(execution, mesh, std::move(seeds), options, make);
}

void run_initial_pass(Passes& passes, Progress& progress, Statistics& statistics) {
  progress.run(Stage::INITIAL, [&] { passes.initial_pass(progress, statistics); });
}

std::vector<Flat_pair> run_passes(Passes& passes,
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
static std::vector<Index> vertices_beside_handles(const Flat_mesh& mesh,
                                                  const std::vector<Flat_pair>& pairs) {
  const Offset_growth growth(mesh);
  std::vector<Index> vertices;
  for(const Flat_pair& pair : pairs)
    for(const Crossing& c : growth(pair.handle) >= growth(pair.tunnel) ? pair.handle : pair.tunnel)
      vertices.insert(vertices.end(), {c.left, c.right});
  return vertices;
}

/// the seeds of the components that none of the vertices is in.
static std::vector<Index> seeds_of_others(const Flat_mesh& mesh,
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
static std::vector<Index> vertices_reached_last(const Flat_mesh& mesh,
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

std::vector<Time> diffusion_times(Passes& passes,
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

std::vector<std::uint32_t> times_of_diffusion(const Flat_mesh& mesh,
                                              Make_passes make_passes,
                                              const Solver_options& given,
                                              const std::vector<Index>& sources,
                                              const std::function<bool(double)>& callback,
                                              Statistics& statistics) {
  Pass_options options;
  options.field_constants = given.field_constants;
  options.literal_rules = given.literal_rules;
  options.device = given.device;
  options.do_coarsen = given.do_coarsen;
  // The diffusion hardly depends on the exact starting curve.
  options.do_tighten = false;
  options.fields_of_refinement = 4;
  const auto nothing = [](Stage) {};
  Progress progress(callback, nothing, nothing, statistics, Progress::stages_of_diffusion());
  const auto passes = make_passes(mesh, mesh.seeds, options);
  return diffusion_times(*passes, options, mesh, sources, progress, statistics);
}

double ticks_per_step_of_diffusion() { return ticks_per_step; }

} // namespace CGAL::Handle_tunnel_loops::internal
