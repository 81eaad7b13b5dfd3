// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/draw/gltf.h"
#include "app/draw/scenes.h"
#include "app/failure.h"
#include "app/file_names.h"
#include "app/solve/backends.h"
#include "app/solve/certification.h"
#include "app/solve/details.h"
#include "app/solve/removal_solver.h"
#include "app/words.h"
#include "app/write/documents.h"
#include "app/write/line_files.h"
#include "app/write/mesh_writer.h"
#include "app/write/pair_listing.h"
#include "app/write/tables.h"
#include "commands/command.h"
#include "commands/loops_options.h"
#include "commands/remove_options.h"
#include "commands/vertex_values.h"
#include "terminal/terminal.h"

#include <CGAL/number_utils.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace htloops {
namespace {

std::pair<Mended_mesh, Vertex_properties> read(const Remove_options& options) {
  const Input_file file = input_of(options);
  Mended_mesh mended = read_mended_mesh(options, file);
  Vertex_properties properties = values_to_keep(
      file, mended.facts, options.is_dry_run ? "" : options.result_file, options.is_quiet);
  extend(properties, mended.origins);
  return {std::move(mended), std::move(properties)};
}

Answer read_basis(const Mesh& mesh, const std::string& file) {
  Bound_loops loops = read_loops_on(mesh, file);
  Answer answer;
  answer.pairs = std::move(loops.pairs);
  answer.statistics.genus = answer.pairs.size();
  answer.certificate = certify(mesh, answer.pairs, loops.basis_kind, true);
  // To cut along a tunnel loop would fill the hole, and the other way around.
  const Certificate& c = answer.certificate;
  if(!c.closed_on_surface || !c.basis || !c.types)
    require_none(file, lines_of(c.failure));
  return answer;
}

// What passes before the removal.
struct Seconds
{
  double reading = 0., loops = 0., measures = 0.;

  double all() const { return reading + loops + measures; }
};

// The loops, and what is told of them. Measures are for `--noise-below`.
Answer answer_of(const Mesh& mesh, const Remove_options& options, Seconds& seconds) {
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  const Stopwatch stopwatch;
  Solve_options solve_options;
  solve_options.number_of_threads = options.number_of_threads;
  Answer answer = options.loops_file.empty() ? host_backend.solve(mesh, solve_options, bar)
                                             : read_basis(mesh, options.loops_file);
  const Thread_limit limit(options.number_of_threads);
  add_details(mesh, false, answer);
  seconds.loops = stopwatch.seconds();
  if(!options.noise_below.empty())
    answer.measures = find_measures(mesh, answer.pairs, bar);
  seconds.measures = stopwatch.seconds() - seconds.loops;
  return answer;
}

// For `--noise-below`; what is undecided is told.
std::optional<Noisy_pairs>
pairs_of_noise(const Mesh& mesh, const Answer& answer, const Remove_options& options) {
  const auto length = parse_length("--noise-below", options.noise_below, diagonal_of(mesh));
  if(!length)
    return std::nullopt;
  if(!options.is_sure && !options.is_dry_run)
    check_noise(noise_sizes(answer.pairs, answer.measures), options.noise_below, *length,
                diagonal_of(mesh));
  Noisy_pairs noisy = noisy_pairs(answer.pairs, answer.measures, *length);
  for(std::size_t i : noisy.undecided)
    std::fprintf(stderr, "htloops: pair %zu is kept: %s\n", i,
                 words_of_doubt(answer.measures[i], answer.pairs[i]).c_str());
  return noisy;
}

Removal_options
wish(const Mesh& mesh, const Remove_options& options, const std::optional<Noisy_pairs>& noisy) {
  Removal_options removal = removal_options(options, diagonal_of(mesh));
  if(noisy)
    removal.pairs = noisy->below;
  return removal;
}

// What becomes of handles, in the order that is asked for.
struct Told_removal
{
  Pair_listing listing; // of those that were to be removed
  Removal_report report;
};

Told_removal told(const Mesh& mesh,
                  const Answer& answer,
                  const Removal_report& report,
                  const Remove_options& options) {
  Listing_options listing_options;
  listing_options.order = order_of(options.order);
  Told_removal told = {list_removals(list_pairs(mesh, answer, listing_options), report), report};
  told.report.removed.clear();
  told.report.refused.clear();
  for(const Listed_pair& pair : told.listing)
    if(pair.removal->done)
      told.report.removed.push_back(*pair.removal->done);
    else
      told.report.refused.push_back(*pair.removal->refused);
  return told;
}

Mesh_line line_of(const std::string& mesh_file, const Answer& answer, const Pair_listing& listing) {
  Mesh_line line = {mesh_file};
  line.answer = answer;
  line.listing = listing;
  return line;
}

void write_files(const Remove_options& options,
                 const Mesh& mesh,
                 const Answer& answer,
                 const Removal_answer& removal,
                 const Told_removal& told) {
  const std::string summed_up = summary(told.report, options.is_dry_run);
  if(!options.json_file.empty())
    write_removal_json(options.json_file, removal.report);
  if(!options.csv_file.empty())
    Line_files(options.csv_file, "", Row_kind::REMOVALS)
        .add(line_of(options.mesh_file, answer, told.listing));
  if(!options.gltf_file.empty())
    export_gltf(options.gltf_file, drawn_surface(mesh), lines_of(answer, told.listing));
  if(is_looked_at(options))
    show_scene(options,
               scene_of_removal(view_of(options), {options.mesh_file, command_to_remove(options),
                                                   mesh, answer.pairs, told.listing, removal,
                                                   summed_up, options.is_dry_run, answer.unit}));
}

// What was asked for, in other words: lengths are often taken for diameters, and the unit for
// another.
std::string words_of_length(const Remove_options& options,
                            const Mesh& mesh,
                            std::size_t number_of_pairs,
                            const Removal_report& report) {
  const double diagonal = diagonal_of(mesh);
  const auto length = parse_length("--shorter-than", options.shorter_than, diagonal);
  if(!length)
    return "";
  const std::string unit = options.shorter_than.back() == '%'
                               ? formatted("is %.4g in the unit of the mesh", *length)
                               : formatted("is in the unit of the mesh, %.3g%% of its diagonal",
                                           100. * (*length / diagonal));
  const std::size_t number = report.removed.size() + report.refused.size();
  return "--shorter-than " + options.shorter_than + " " + unit +
         formatted(", and a circumference (diameter %.4g): ", *length / CGAL_PI) +
         std::to_string(number) + " of " + counted(number_of_pairs, "handle is", "handles are") +
         " shorter\n";
}

bool has_chosen_none(const Removal_report& report) {
  return report.removed.empty() && report.refused.empty();
}

// Where no handle was below it: how far that is from what there is.
std::string words_of_noise(const Remove_options& options,
                           const Mesh& mesh,
                           const Answer& answer,
                           const Removal_report& report) {
  const auto length = parse_length("--noise-below", options.noise_below, diagonal_of(mesh));
  if(!length || !has_chosen_none(report))
    return "";
  std::string text = "--noise-below " + options.noise_below +
                     formatted(" is %.4g in the unit of the mesh", *length);
  if(!answer.pairs.empty()) {
    Range_of_diameters all = noise_of(answer.measures[0], answer.pairs[0]);
    for(std::size_t i = 1; i < answer.pairs.size(); ++i) {
      const auto [least, most] = noise_of(answer.measures[i], answer.pairs[i]);
      all = {(std::min)(all.least, least), (std::min)(all.most, most)};
    }
    text += "; the smallest thickness or clear width is " +
            words_of(all, [](double diameter) { return formatted("%.4g", diameter); });
  }
  return text + "\n";
}

// Where no bore was in the range: which there are.
std::string words_of_bores(const Remove_options& options,
                           const Mesh& mesh,
                           const Answer& answer,
                           const Removal_report& report) {
  if(options.bores.empty() || !has_chosen_none(report))
    return "";
  std::vector<double> diameters;
  for(const Listed_pair& pair : list_pairs(mesh, answer))
    if(pair.hole.bore)
      diameters.push_back(pair.hole.diameter);
  if(diameters.empty())
    return answer.pairs.empty() ? "there are no holes\n"
           : answer.pairs.size() == 1
               ? "the only hole is not a round bore\n"
               : "none of the " + std::to_string(answer.pairs.size()) + " holes is a round bore\n";
  const auto [least, largest] = std::minmax_element(diameters.begin(), diameters.end());
  return "no bore has a diameter in this range; " +
         counted(diameters.size(), "round bore has", "round bores have") +
         (*least == *largest ? formatted(" diameter %.6g", *least)
                             : formatted(" diameters from %.6g to %.6g", *least, *largest)) +
         "\n";
}

// Holes as wide as that which are left, as they are not round.
std::string
words_of_other_holes(const Remove_options& options, const Mesh& mesh, const Answer& answer) {
  constexpr std::size_t most_named = 5;
  if(options.bores.empty() || options.bores == ":")
    return "";
  const Removal_options wanted = removal_options(options, diagonal_of(mesh));
  std::vector<std::string> holes;
  for(const Listed_pair& pair : list_pairs(mesh, answer))
    if(!pair.hole.bore && *wanted.minimal_bore_diameter <= pair.hole.diameter &&
       pair.hole.diameter <= *wanted.maximal_bore_diameter)
      holes.push_back(formatted("pair %zu, %.4g wide and %.2g%% off round", pair.pair,
                                pair.hole.diameter, 100. * pair.hole.out_of_roundness));
  if(holes.empty())
    return "";
  const std::size_t number = holes.size();
  holes.resize((std::min)(number, most_named));
  return "left, as no cylinder fits: " + boost::algorithm::join(holes, "; ") +
         (number > most_named ? "; and " + std::to_string(number - most_named) + " more" : "") +
         "\n";
}

// Where there are no more handles than are to be kept.
std::string words_of_genus(const Remove_options& options, const Removal_report& report) {
  return options.genus.value_or(0) > report.genus_before
             ? "nothing to do: --genus " + std::to_string(*options.genus) + " is more than the " +
                   counted(report.genus_before, "handle", "handles") + " of the mesh\n"
             : "";
}

bool is_output_taken(const Remove_options& options) {
  return (options.result_file == "-" && !options.is_dry_run) ||
         options.is_mesh_on_standard_output() || options.json_file == "-" ||
         options.page_file == "-" || options.csv_file == "-" || options.map_file == "-";
}

// The sum is the time that passed.
std::string words_of_time(const Remove_options& options,
                          const Seconds& before,
                          double all_seconds,
                          int number_of_threads) {
  return formatted("%.2f s after %.2f s for the loops", all_seconds - before.all(), before.loops) +
         (options.noise_below.empty() ? "" : formatted(", %.2f s for measures", before.measures)) +
         formatted(" and %.2f s of reading, ", before.reading) +
         counted(static_cast<std::size_t>(number_of_threads), "thread", "threads") + "\n";
}

std::string table_and_summary(const Remove_options& options,
                              const Removal_report& report,
                              double diagonal,
                              bool is_dry_run) {
  const bool has_refused = !report.refused.empty() || !report.refused_necks.empty();
  return table_of_removals(report, diagonal, options.show_all) + summary(report, is_dry_run) +
         (has_refused && !options.is_forced
              ? "--force also removes where that is not a repair, or more faces would intersect\n"
              : "");
}

// What was asked for by number or length is either reached, or said not to be.
void check_all_done(const Remove_options& options,
                    const Removal_report& report,
                    const std::optional<Noisy_pairs>& noisy) {
  std::string missed = words_of_missed_genus(options.genus, report.genus_after);
  if(noisy && !noisy->undecided.empty())
    missed += (missed.empty() ? "" : ", and ") + words_of_undecided(noisy->undecided.size());
  if(!missed.empty())
    throw Failure(Exit_code::UNACCEPTABLE_MESH,
                  missed + (options.is_dry_run ? "" : "; the mesh was written all the same"));
}

// Who has not said what is to go sees what there is, and nothing is written.
[[noreturn]] void
ask_for_choice(const Remove_options& options, const Removal_report& report, double diagonal) {
  if(!options.is_quiet)
    show_text(table_and_summary(options, report, diagonal, true), false);
  throw wrong_usage(
      "this is what --all would do, but nothing was written: use --all, or choose handles, "
      "for example with --shorter-than 3% or --pairs 0,2");
}

void run(const Remove_options& options) {
  check_remove_options(options);
  const Stopwatch stopwatch;
  auto [mended, properties] = read(options);
  const Mesh& mesh = mended.mesh;
  Seconds seconds = {stopwatch.seconds()};
  check_lengths(options, diagonal_of(mesh));
  Answer answer = answer_of(mesh, options, seconds);
  answer.unit = mended.facts.unit;
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  const std::optional<Noisy_pairs> noisy = pairs_of_noise(mesh, answer, options);
  const Removal_answer removal =
      remove_handles(mesh, answer.pairs, wish(mesh, options, noisy), bar);
  const Told_removal told = htloops::told(mesh, answer, removal.report, options);
  if(!has_choice(options) && !options.is_dry_run)
    ask_for_choice(options, told.report, diagonal_of(mesh));
  write_read_mesh(options, mended);
  if(!options.is_dry_run) {
    spread_properties(removal, properties);
    write_mesh(options.result_file, removal.mesh, properties, "", mended.facts);
    show_note_on_unit(options, options.result_file, mended.facts);
    if(!options.map_file.empty())
      write_map_json(options.map_file, mesh.number_of_vertices(), mesh.number_of_faces(), removal);
  }
  write_files(options, mesh, answer, removal, told);
  if(!options.is_quiet)
    show_text(words_of_length(options, mesh, answer.pairs.size(), removal.report) +
                  words_of_noise(options, mesh, answer, removal.report) +
                  words_of_bores(options, mesh, answer, removal.report) +
                  words_of_other_holes(options, mesh, answer) +
                  words_of_genus(options, removal.report) +
                  table_and_summary(options, told.report, diagonal_of(mesh), options.is_dry_run) +
                  words_of_unit(mended.facts.unit) +
                  words_of_time(options, seconds, stopwatch.seconds(), removal.number_of_threads) +
                  (options.is_dry_run ? "this was a dry run: no mesh was written\n" : ""),
              is_output_taken(options));
  check_all_done(options, removal.report, noisy);
}

constexpr char remove_description[] = R"(Removes handles of a triangle mesh.

A handle is cut along its handle loop, or its hole is filled along its tunnel loop. The ends are
closed by caps that meet the surface only at their rims. The rest of the mesh is unchanged; the
numbers and colors of its vertices are kept if the output format can store them.
A handle is refused if neither way is possible, or if the result would not be a repair. The table
names it with the reason; this is not an error, but exit code 4 if --genus is not reached. Without a
selection, it lists what --all would do, and exits with code 2.
)";

constexpr char remove_examples[] = R"(Examples:
  htloops remove scan.ply                         list the handles
  htloops remove scan.ply -o clean.ply --all      all handles
  htloops remove scan.ply -o clean.ply --shorter-than 3%
                                                  those with a short loop
  htloops remove part.stl -o part.off --pairs 0:fill,3:fill
                                                  fill two holes
  htloops remove part.stl -o part.off --bores 3:8
                                                  bores with a diameter from 3 to 8
  htloops remove scan.ply --genus 2 --dry-run --html look.html
                                                  preview: keep the two largest handles
)";

} // namespace

void add_remove_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Remove_options>();
  CLI::App* remove = app.add_subcommand("remove", remove_description)->group("Commands");
  add_remove_options(*remove, *options);
  complete_help(*remove, remove_examples);
  remove->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
