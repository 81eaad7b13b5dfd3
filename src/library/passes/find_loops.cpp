// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/certify.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/find_right_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Loops_on_arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Pair_relations.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What the passes find, and a coarse mesh for searches, if there is one.
struct Found_pairs
{
  std::vector<Flat_pair> pairs;
  std::shared_ptr<const Coarse_mesh> coarse;
};

/// the passes, as far as there is anything to do for them.
static Found_pairs pairs_of_passes(const Flat_mesh& mesh,
                                   const Loop_request& request,
                                   Progress& progress,
                                   Statistics& statistics) {
  Found_pairs found;
  if(mesh.genus == 0 && !request.passes.asks_for_fronts())
    return found;
  const auto passes = request.make_passes(mesh, request.seeds, request.passes);
  if(mesh.genus == 0)
    run_initial_pass(*passes, progress, statistics);
  else
    found.pairs = run_passes(*passes, request.passes, progress, statistics);
  request.put_swept_vertices(passes->take_swept_vertices());
  found.coarse = passes->coarse_mesh_for_searches(found.pairs);
  return found;
}

/// throws `std::invalid_argument` if there is no such search.
static void check_search(const Class_options& options) {
  constexpr double most_effort = 1000.;
  if(!(options.search_effort >= 0. && options.search_effort <= most_effort))
    throw std::invalid_argument("the search effort must be in [0, 1000]");
  if(!(options.maximum_running_time >= 0.))
    throw std::invalid_argument("the maximum running time must not be negative");
}

Certificate find_loops(Execution execution,
                       const Flat_mesh& mesh,
                       const Loop_request& request,
                       Caller_mesh& caller,
                       Progress& progress,
                       Statistics& statistics) {
  check_constants(request.passes.field_constants);
  check_search(request.classes);
  progress.time().limit(request.classes.maximum_running_time -
                        statistics.seconds_of(Stage::ADAPTOR));
  Class_options classes = request.classes;
  if(request.passes.literal_rules.finite_offset)
    classes.offset =
        request.passes.literal_rules.offset * mesh.in_units_of_caller(mean_edge_length(mesh));
  auto [pairs, coarse] = pairs_of_passes(mesh, request, progress, statistics);
  execution = execution.watched_by(progress);
  if(mesh.genus == 0 && mesh.number_of_hubs > 0) { // there is nothing to certify
    progress.run(Stage::CONVERT, [] {});
    progress.run(Stage::CLASSIFY, [] {});
    return Certificate::of_no_loops(classes.kind, classes.do_link);
  }
  const Flat_surface surface(mesh, caller.coordinates(execution));
  Pair_relations pair_relations(surface);
  std::optional<Loop_relations> relations;
  if(!pairs.empty())
    progress.run(Stage::CLASSES, [&, &pairs = pairs, &coarse = coarse] {
      relations = find_right_classes(
          execution, mesh, classes,
          [&](const std::vector<Flat_pair>& now, const Known_relations* known) {
            return known == nullptr ? pair_relations.relate(execution, now, true)
                                    : pair_relations.relate(execution, now, *known);
          },
          pairs, progress, coarse.get());
    });
  statistics.was_ended_by_time = progress.time().has_been_refused();
  progress.run(Stage::CONVERT, [&, &pairs = pairs] { caller.convert(execution, pairs); });
  if(!relations)
    relations = pair_relations.relate(execution, pairs, classes.do_link);
  Naming naming = certify_and_name(
      execution, [&](bool with_points) { return caller.triangles(execution, with_points); },
      caller.listed_loops(), classes.kind, classes.offset, std::move(*relations), progress);
  for(std::size_t k = 0; k < naming.is_exchanged.size(); ++k)
    if(naming.is_exchanged[k])
      caller.exchange(k);
  if(!naming.certificate)
    throw Uncertified_loops_exception("the loops found are not certified: " +
                                      naming.certificate.failure);
  return std::move(naming.certificate);
}

Certificate find_loops(Execution execution,
                       const Flat_mesh& mesh,
                       const Loop_request& request,
                       Caller_mesh& caller,
                       const Listeners& listeners,
                       Statistics& statistics) {
  Progress progress(listeners.callback, listeners.start_stage, listeners.end_stage, statistics,
                    Progress::stages_of_loops());
  return find_loops(execution, mesh, request, caller, progress, statistics);
}

std::vector<Flat_pair> loops_on_arrays(Execution execution,
                                       const Flat_mesh& mesh,
                                       std::vector<Simple_cartesian<double>::Point_3> coordinates,
                                       Loop_request request,
                                       const std::function<bool(double)>& callback) {
  return Loops_on_arrays(std::move(coordinates))
      .find(execution, mesh, std::move(request), callback);
}

} // namespace CGAL::Handle_tunnel_loops::internal
