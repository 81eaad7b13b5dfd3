// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/details.h"

#include <CGAL/Handle_tunnel_loops/round_bores.h>
#include <CGAL/handle_measures.h>
#include <CGAL/removal_costs.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <iterator>

namespace htloops {

Bores find_bores(const Mesh& mesh, const Pairs& pairs) {
  Bores bores;
  CGAL::round_bores<All_threads_tag>(mesh, pairs, std::back_inserter(bores));
  return bores;
}

Measures find_measures(const Mesh& mesh, const Pairs& pairs, double precision, Progress& progress) {
  Measures measures;
  progress.start("measures");
  CGAL::handle_measures<All_threads_tag>(
      mesh, pairs, std::back_inserter(measures),
      CGAL::parameters::relative_precision(precision,
                                           CGAL::parameters::callback(progress.callback())));
  progress.end();
  return measures;
}

Costs find_costs(const Mesh& mesh, const Pairs& pairs, Progress& progress) {
  Costs costs;
  progress.start("costs");
  CGAL::removal_costs<All_threads_tag>(mesh, pairs, std::back_inserter(costs),
                                       CGAL::parameters::callback(progress.callback()));
  progress.end();
  return costs;
}

std::optional<double> noise_of(const Measure& measure) {
  const auto &in = measure.thickness, &out = measure.clear_width;
  if(in && out)
    return (std::min)(in->diameter, out->diameter);
  return in ? std::optional(in->diameter) : out ? std::optional(out->diameter) : std::nullopt;
}

void add_details(const Mesh& mesh, bool do_find_waists, Answer& answer) {
  const Stopwatch stopwatch;
  if(answer.statistics.number_of_boundaries > 0)
    answer.boundaries = find_boundaries(mesh, do_find_waists);
  if(answer.statistics.number_of_components > 1)
    answer.components = components_of_pairs(mesh, answer.pairs);
  answer.bores = find_bores(mesh, answer.pairs);
  answer.total_seconds += stopwatch.seconds();
}

} // namespace htloops
