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
#include <CGAL/number_utils.h>
#include <CGAL/removal_costs.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
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

Measures find_measures(const Mesh& mesh, const Pairs& pairs, Progress& progress) {
  Measures measures;
  progress.start("measures");
  CGAL::handle_measures<All_threads_tag>(mesh, pairs, std::back_inserter(measures),
                                         CGAL::parameters::callback(progress.callback()));
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

Range_of_diameters range_of(const std::optional<Ball>& ball, const Loop& around) {
  const double most = around.length() / CGAL_PI;
  if(!ball)
    return {0., most};
  return {(std::max)(0., ball->diameter - ball->error),
          (std::min)(most, ball->diameter + ball->error)};
}

Range_of_diameters noise_of(const Measure& measure, const Pair& pair) {
  const Range_of_diameters in = range_of(measure.thickness, pair.handle()),
                           out = range_of(measure.clear_width, pair.tunnel());
  return {(std::min)(in.least, out.least), (std::min)(in.most, out.most)};
}

Noisy_pairs noisy_pairs(const Pairs& pairs, const Measures& measures, double below) {
  Noisy_pairs noisy;
  for(std::size_t i = 0; i < measures.size(); ++i)
    if(const auto [least, most] = noise_of(measures[i], pairs[i]); most < below)
      noisy.below.push_back(i);
    else if(least < below)
      noisy.undecided.push_back(i);
  return noisy;
}

std::string words_of_doubt(const Measure& measure, const Pair& pair) {
  const auto [least, most] = noise_of(measure, pair);
  return formatted("the smaller of its thickness and clear width is between %.4g and %.4g", least,
                   most) +
         (measure.why.empty() ? "" : ": " + measure.why);
}

std::vector<double> noise_sizes(const Pairs& pairs, const Measures& measures) {
  std::vector<double> sizes;
  for(std::size_t i = 0; i < measures.size(); ++i)
    sizes.push_back(noise_of(measures[i], pairs[i]).most);
  return sizes;
}

namespace {

// How many of these, in descending order, are on the upper side of the widest gap between them; 0
// if none is as wide as between the noise and the handles of an object.
std::size_t number_above_gap(const std::vector<double>& sizes) {
  constexpr double wide = 4.; // neighbours among the noise of a scan differ by a factor of 2
  std::size_t number = 0;
  double widest = wide;
  for(std::size_t i = 1; i < sizes.size(); ++i)
    if(sizes[i - 1] > widest * sizes[i]) {
      number = i;
      widest = sizes[i - 1] / sizes[i];
    }
  return number;
}

std::string words_of_sizes(const std::vector<double>& sizes) {
  constexpr std::size_t most_sizes = 10;
  if(sizes.empty())
    return "no handle";
  std::string list;
  for(std::size_t i = 0; i < sizes.size() && i < most_sizes; ++i)
    list += (i == 0 ? " " : ", ") + formatted("%.4g", sizes[i]);
  if(sizes.size() > most_sizes)
    list += " and " + std::to_string(sizes.size() - most_sizes) + " smaller ones";
  return counted(sizes.size(), "handle", "handles") + ", with a thickness or clear width of" + list;
}

// A length that takes those below the gap only, and is no nearer to either side.
std::string words_of_gap(const std::vector<double>& sizes, std::size_t above, double percent_of) {
  const double least = sizes[above - 1], most = sizes[above],
               middle = most > 0. ? std::sqrt(least * most) : least / 2.;
  return formatted(" Between %.4g and %.4g there is a wide gap", most, least) +
         ", as between noise and object: --noise-below " +
         (percent_of > 0. ? formatted("%.2g%%", 100. * middle / percent_of)
                          : formatted("%.2g", middle)) +
         " would remove only the " + std::to_string(sizes.size() - above) + " below it.";
}

} // namespace

void check_noise(std::vector<double> sizes,
                 const std::string& text,
                 double below,
                 double diagonal) {
  constexpr double largest_noise = 0.05; // noise is far smaller, and few handles of a scan are
  sizes.erase(
      std::remove_if(sizes.begin(), sizes.end(), [&](double size) { return !(size < below); }),
      sizes.end());
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  const bool is_long = below > largest_noise * diagonal, // false where it is not a number
      is_share = text.back() == '%';
  const std::size_t above = number_above_gap(sizes);
  if(!is_long && above == 0)
    return;
  throw wrong_usage("--noise-below " + text +
                    (is_long ? formatted(" is %.3g%% of the diagonal of the bounding box: it",
                                         100. * (below / diagonal))
                             : "") +
                    " would remove " + words_of_sizes(sizes) + "." +
                    (above > 0 ? words_of_gap(sizes, above, is_share ? diagonal : 0.) : "") + " " +
                    (is_share || below > 100. || !is_long ? "" : "Did you mean " + text + "%? ") +
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
