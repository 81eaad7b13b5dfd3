// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/details.h"

#include "failure.h"
#include "words.h"

#include <CGAL/Handle_tunnel_loops/round_bores.h>
#include <CGAL/handle_measures.h>
#include <CGAL/removal_costs.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

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

void check_noise(const Measures& measures, const std::string& text, double below, double diagonal) {
  constexpr double largest_noise = 0.05; // noise is far smaller, and few handles of a scan are
  constexpr std::size_t most_sizes = 10;
  if(!(below > largest_noise * diagonal)) // as also where it is not a number
    return;
  std::vector<double> sizes;
  for(const Measure& measure : measures)
    if(const std::optional<double> noise = noise_of(measure); noise && *noise < below)
      sizes.push_back(*noise);
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  std::string list;
  for(std::size_t i = 0; i < sizes.size() && i < most_sizes; ++i)
    list += (i == 0 ? " " : ", ") + formatted("%.4g", sizes[i]);
  if(sizes.size() > most_sizes)
    list += " and " + std::to_string(sizes.size() - most_sizes) + " smaller ones";
  throw wrong_usage(
      "--noise-below " + text +
      formatted(" is %.3g%% of the diagonal of the bounding box", 100. * (below / diagonal)) +
      ": it would remove " +
      (sizes.empty() ? "no handle"
                     : counted(sizes.size(), "handle", "handles") +
                           ", with a thickness or clear width of" + list) +
      ". " + (text.back() == '%' || below > 100. ? "" : "Did you mean " + text + "%? ") +
      "Use --yes to do it anyway");
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
