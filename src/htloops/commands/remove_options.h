// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REMOVE_OPTIONS_H
#define HTLOOPS_REMOVE_OPTIONS_H

#include "app/solve/removal_solver.h"
#include "commands/options.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

/// The options of `htloops remove`. The JSON is the report.
struct Remove_options : Common_options
{
  std::string result_file;
  std::string csv_file;
  std::string order = "size";
  bool are_all_meant = false; ///< all handles
  std::string loops_file;
  std::optional<std::size_t> genus;
  std::string shorter_than;
  std::vector<std::string> pairs; ///< numbers, some with a way: "5", "1:fill"
  std::vector<double> box;
  std::string necks;
  std::string channels;
  std::string noise_below;
  std::string bores; ///< "MIN:MAX", either of them may be missing
  std::string method = "smallest-change";
  std::string map_file;
  bool is_forced = false;
  bool is_dry_run = false;
  bool is_sure = false;  ///< also of lengths above the diagonal
  bool show_all = false; ///< rows
};

void add_remove_options(CLI::App& command, Remove_options& options);

/// whether it is said which handles are to be removed.
bool has_choice(const Remove_options& options);

/// throws `Failure` if an option makes no sense.
void check_remove_options(const Remove_options& options);

/// throws `Failure` if a length is more than any small handle has, unless the user is sure: perhaps
/// it is a percentage without its sign.
void check_lengths(const Remove_options& options, double diagonal);

/// what is asked for, with percentages of the diagonal; without the pairs of `--noise-below`.
Removal_options removal_options(const Remove_options& options, double diagonal);

} // namespace htloops

#endif // HTLOOPS_REMOVE_OPTIONS_H
