// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_DETAILS_H
#define HTLOOPS_DETAILS_H

#include "solve/answer.h"
#include "solve/progress.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

/// by pair, the bore that its tunnel loop goes around, if that is one.
Bores find_bores(const Mesh& mesh, const Pairs& pairs);

/// thickness and clear width by pair.
Measures find_measures(const Mesh& mesh, const Pairs& pairs, Progress& progress);

/// what either way to remove each handle would change, of each by itself.
Costs find_costs(const Mesh& mesh, const Pairs& pairs, Progress& progress);

/// What is known of the diameter of a ball.
struct Range_of_diameters
{
  double least, most;
};

/// of a ball that was measured. One that was not is no wider than a circle as long as a loop that
/// goes around its way, as any ball is.
Range_of_diameters range_of(const std::optional<Ball>& ball, const Loop& around);

/// the smaller of thickness and clear width.
Range_of_diameters noise_of(const Measure& measure, const Pair& pair);

/// Pairs of which the smaller of thickness and clear width is below a length, and those of which it
/// may be, as far as is known.
struct Noisy_pairs
{
  std::vector<std::size_t> below, undecided;
};

Noisy_pairs noisy_pairs(const Pairs& pairs, const Measures& measures, double below);

/// between what the smaller of thickness and clear width is, and why no more is known.
std::string words_of_doubt(const Measure& measure, const Pair& pair);

/// the smaller of thickness and clear width of each, at most.
std::vector<double> noise_sizes(const Pairs& pairs, const Measures& measures);

/// throws `Failure` if handles of a size below a length, `text` as an option, are to go and real
/// ones are likely among them: if it is above 5% of the diagonal, which is often a percentage
/// without its sign, or there is a wide gap between the sizes. They are told, and a length in the
/// gap.
void check_noise(std::vector<double> sizes, const std::string& text, double below, double diagonal);

/// looks for what is told of a mesh with its loops: boundary curves, if it has some, and bores.
void add_details(const Mesh& mesh, bool do_find_waists, Answer& answer);

} // namespace htloops

#endif // HTLOOPS_DETAILS_H
