// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LOOPS_OPTIONS_H
#define HTLOOPS_LOOPS_OPTIONS_H

#include "app/write/documents.h"
#include "app/write/line_files.h"
#include "app/write/pair_listing.h"
#include "app/write/rows.h"
#include "commands/options.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace htloops {

/// The options that say which pairs are shown, drawn and listed, and in which order.
struct Listing_choice
{
  std::string order = "size";
  std::string shorter_than;
  std::string longer_than;
  std::string noise_below;
  std::vector<double> box;
};

/// The options of `htloops loops`. `mesh_file` is one of the meshes.
struct Loops_options : Common_options
{
  std::vector<std::string> mesh_files;
  bool is_batch = false;  ///< of meshes, each of which is told of on lines
  bool do_resume = false; ///< a batch that was interrupted
  std::string events_file;
  std::string layers_file;
  std::string channels_file;
  std::optional<double> moment; ///< of the first pass, to be seen in pictures
  std::string csv_file;
  std::string jsonl_file; ///< an object of JSON for each mesh
  Listing_choice listing;
  std::string backend = "auto";
  std::optional<std::uint32_t> seed;
  bool is_literal = false;
  bool do_not_refine = false;
  bool do_not_tighten = false;
  bool do_not_coarsen = false;
  double search_effort = 1.;
  std::optional<double> time_budget; ///< seconds
  bool do_find_waists = false;
  bool do_find_throats = false;
  std::vector<std::uint32_t> through; ///< vertices
  std::string basis = "pure";
  std::string classifier = "linking";
  int number_of_jobs = 1; ///< meshes at once
  bool is_to_measure = false;
  bool has_costs = false; ///< of removal
  bool show_all = false;
  bool is_verbose = false;
  std::string colour = "auto";

  bool has_measures() const { return is_to_measure || !listing.noise_below.empty(); }
  Row_kind kind_of_rows() const {
    return do_find_throats  ? Row_kind::THROATS
           : has_costs      ? Row_kind::PAIRS_WITH_COSTS
           : has_measures() ? Row_kind::MEASURED_PAIRS
                            : Row_kind::PAIRS;
  }
};

void add_loops_options(CLI::App& command, Loops_options& options);

/// those of `htloops measure`, which has the most usual of them.
void add_measure_options(CLI::App& command, Loops_options& options);

/// declares `--sort`, and what its words stand for.
void add_order_option(CLI::App& command, std::string& order);
Pair_order order_of(const std::string& word);

/// declares `--noise-below`.
CLI::Option* add_noise_option(CLI::App& command, std::string& length, const std::string& what);

/// throws `Failure` if an option makes no sense, or not with several meshes.
void check_loops_options(const Loops_options& options);

/// the options that an answer depends on.
Json json_of(const Loops_options& options);

/// reads a mesh and finds its loops, with boundary curves, if it has some.
std::pair<Mended_mesh, Mesh_line> read_and_solve(const Loops_options& options, bool show_progress);

/// what is told of a mesh: what `solve()` returns, or why it threw.
Mesh_line line_of(const std::string& mesh_file, const std::function<Mesh_line()>& solve);

/// finds the loops of meshes, several at once if that is asked for, and tells of each on a line of
/// its own, in the order in which they were given. Goes on after one that fails; throws `Failure`
/// with the exit code of the first such in the end.
void run_on_many_meshes(Loops_options options);

} // namespace htloops

#endif // HTLOOPS_LOOPS_OPTIONS_H
