// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/dual_cut_solver.h"

#include "solve/boundaries.h"
#include "solve/thread_limit.h"

#include <CGAL/Handle_tunnel_loops_solver.h>
#include <CGAL/dual_cuts.h>

#include <iterator>

namespace htloops {
namespace {

using Tag = CGAL::Parallel_if_available_tag;

// The loops of the pairs, and of each component all boundary curves but the last: as
// `CGAL::dual_cuts()` has them.
std::vector<Loop> basis_of(const Mesh& mesh, const Pairs& pairs, std::size_t number_of_components) {
  std::vector<Loop> basis;
  for_each_loop(pairs,
                [&](const Loop& loop, CGAL::Loop_type, std::size_t) { basis.push_back(loop); });
  const std::vector<Loop> curves = find_boundaries(mesh, false).curves;
  const std::vector<std::size_t> components = components_of_vertices(mesh, number_of_components);
  const auto component = [&](const Loop& curve) {
    return components[mesh.source(curve.steps().front().halfedge).idx()];
  };
  std::vector<std::size_t> last(mesh.number_of_vertices() + 1);
  for(const Loop& curve : curves)
    last[component(curve)] = curve.pair_index();
  for(const Loop& curve : curves)
    if(last[component(curve)] != curve.pair_index())
      basis.push_back(curve);
  return basis;
}

} // namespace

Dual_cuts find_dual_cuts(const Mesh& mesh, int number_of_threads, Progress& progress) {
  const Thread_limit limit(number_of_threads);
  progress.start("dual cuts");
  Dual_cuts result;
  Pairs pairs;
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(Tag(), mesh, CGAL::parameters::default_values());
  solver.find_loops<Tag>(std::back_inserter(pairs),
                         CGAL::parameters::callback(progress.callback()));
  result.statistics = solver.statistics();
  std::vector<std::vector<std::pair<Mesh::Halfedge_index, std::int64_t>>> cuts;
  CGAL::dual_cuts<Tag>(mesh, pairs, std::back_inserter(cuts));
  const std::vector<Loop> basis = basis_of(mesh, pairs, solver.number_of_components());
  for(std::size_t i = 0; i < cuts.size(); ++i)
    result.cuts.push_back({basis[i], std::move(cuts[i])});
  progress.end();
  return result;
}

} // namespace htloops
