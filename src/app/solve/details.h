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

#include <optional>
#include <string>

namespace htloops {

/// by pair, the bore that its tunnel loop goes around, if that is one.
Bores find_bores(const Mesh& mesh, const Pairs& pairs);

/// thickness and clear width by pair, each up to a part of it as an error.
Measures find_measures(const Mesh& mesh, const Pairs& pairs, double precision, Progress& progress);

/// what either way to remove each handle would change, of each by itself.
Costs find_costs(const Mesh& mesh, const Pairs& pairs, Progress& progress);

/// the smaller of thickness and clear width, as far as they are known; none if neither is.
std::optional<double> noise_of(const Measure& measure);

/// throws `Failure` if handles that are thinner or narrower than a length, `text` as an option, are
/// to go and it is above 5% of the diagonal: that is often a percentage without its sign, and real
/// handles would go. The sizes of those handles are told.
void check_noise(const Measures& measures, const std::string& text, double below, double diagonal);

/// looks for what is told of a mesh with its loops: boundary curves, if it has some, and bores.
void add_details(const Mesh& mesh, bool do_find_waists, Answer& answer);

} // namespace htloops

#endif // HTLOOPS_DETAILS_H
