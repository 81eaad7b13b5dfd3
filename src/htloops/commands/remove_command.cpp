// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/draw/pages.h"
#include "app/failure.h"
#include "app/read/vertex_data.h"
#include "app/solve/backends.h"
#include "app/solve/certification.h"
#include "app/solve/details.h"
#include "app/solve/removal_solver.h"
#include "app/words.h"
#include "app/write/documents.h"
#include "app/write/mesh_writer.h"
#include "app/write/pair_listing.h"
#include "app/write/tables.h"
#include "commands/command.h"
#include "commands/loops_options.h"
#include "commands/options.h"
#include "terminal/terminal.h"

#include <CGAL/number_utils.h>

#include <boost/algorithm/string/join.hpp>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace htloops {
namespace {

struct Remove_options : Common_options // the JSON is the report
{
  std::string result_file;
  std::string loops_file;
  std::optional<std::size_t> genus;
  std::string shorter_than;
  std::vector<std::string> pairs; // numbers, some with a way: "5", "1:fill"
  std::vector<double> box;
  std::string necks;
  std::string noise_below;
  std::string precision = "1%";
  std::string bores; // "MIN:MAX", either of them may be missing
  std::string method = "smallest-change";
  std::string map_file;
  bool is_forced = false;
  bool is_dry_run = false;
  bool is_sure = false; // also of lengths above the diagonal
  bool show_all = false;
};

const std::map<std::string, Removal_method> methods = {
    {"cut", Removal_method::CUT},
    {"fill", Removal_method::FILL},
    {"smallest-change", Removal_method::SMALLEST_CHANGE},
    {"cheapest", Removal_method::SMALLEST_CHANGE}};

// "1:fill" to a number, and a way if there is one.
std::pair<std::size_t, std::optional<Removal_method>> parse_pair(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string digits = text.substr(0, colon);
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const auto way =
      colon == std::string::npos ? methods.end() : methods.find(text.substr(colon + 1));
  if(error != std::errc() || end != digits.data() + digits.size() ||
     (colon != std::string::npos && way == methods.end()))
    throw wrong_usage("--pairs: '" + text +
                      "' is neither the number of a pair nor one with a way, as 1:fill or 2:cut");
  if(way == methods.end())
    return {number, std::nullopt};
  return {number, way->second};
}

std::optional<double> parse_diameter(const std::string& text) {
  if(text.empty())
    return std::nullopt;
  double diameter = 0.;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), diameter);
  if(error != std::errc() || end != text.data() + text.size() || !(diameter >= 0.) ||
     !std::isfinite(diameter))
    throw wrong_usage("--bores: '" + text + "' is not a diameter, such as 0.25");
  return diameter;
}

// Of bores: "3:8" to the limits, or to those that leave all.
std::pair<double, double> parse_range(const std::string& text) {
  const std::size_t colon = text.find(':');
  if(colon == std::string::npos)
    throw wrong_usage("--bores: '" + text + "' is not a range of diameters, such as 3:8, 3: or :8");
  const double least = parse_diameter(text.substr(0, colon)).value_or(0.),
               most = parse_diameter(text.substr(colon + 1))
                          .value_or(std::numeric_limits<double>::infinity());
  if(!(least <= most))
    throw wrong_usage("--bores: the least diameter comes first, then the largest");
  return {least, most};
}

void check_options(const Remove_options& options) {
  if(options.result_file.empty() && !options.is_dry_run)
    throw wrong_usage("-o OUT says where the mesh goes; or --dry-run");
  check_mesh_format(options.result_file);
  parse_length("--shorter-than", options.shorter_than);
  parse_length("--necks", options.necks);
  parse_length("--noise-below", options.noise_below);
  parse_precision(options.precision);
  box_of(options.box);
  for(const std::string& pair : options.pairs)
    parse_pair(pair);
  if(!options.bores.empty()) {
    parse_range(options.bores);
    if(methods.at(options.method) == Removal_method::CUT)
      throw wrong_usage("--bores are filled: not with --by cut");
  }
  if(!options.map_file.empty() && options.is_dry_run)
    throw wrong_usage("--map says what became of the vertices of a mesh that is written: not with "
                      "--dry-run");
  check_common_options(options);
}

// A length that no small handle has: perhaps a percentage without its sign.
void check_length(const std::string& option, const std::string& text, double diagonal) {
  const auto length = parse_length(option, text, diagonal);
  if(!length || *length <= diagonal)
    return;
  const bool has_sign = text.back() == '%';
  throw wrong_usage(option + " " + text + " is more than the diagonal of the mesh's box, " +
                    formatted("%.6g", diagonal) +
                    (has_sign ? ": too long for a small handle" : "; was " + text + "% meant?") +
                    " --yes does it nevertheless");
}

void check_lengths(const Remove_options& options, double diagonal) {
  if(options.is_sure)
    return;
  check_length("--shorter-than", options.shorter_than, diagonal);
  check_length("--necks", options.necks, diagonal);
  check_length("--noise-below", options.noise_below, diagonal);
}

// What of the mesh's data will be in the result; says what will not.
Vertex_properties properties_to_keep(const Input_file& file, const Remove_options& options) {
  if(options.is_dry_run)
    return {};
  Vertex_properties kept = kept_by_format(options.result_file, read_vertex_properties(file));
  const std::string list = boost::algorithm::join(unread_data(file, kept), "; ");
  if(!list.empty() && !options.is_quiet)
    std::fprintf(stderr, "htloops: of %s is not kept: %s\n", options.mesh_file.c_str(),
                 list.c_str());
  return kept;
}

// A copy of a vertex has its values.
void extend(Vertex_properties& properties, const std::vector<std::uint32_t>& origins) {
  for(Vertex_property& property : properties)
    for(const std::uint32_t origin : origins)
      property.values.push_back(double(property.values[origin]));
}

std::pair<Mesh, Vertex_properties> read(const Remove_options& options) {
  const Input_file file = input_of(options);
  Mended_mesh mended = read_mended_mesh(options, file);
  Vertex_properties properties = properties_to_keep(file, options);
  extend(properties, mended.origins);
  return {std::move(mended.mesh), std::move(properties)};
}

Pairs read_basis(const Mesh& mesh, const std::string& file) {
  Bound_loops loops = read_loops_on(mesh, file);
  const auto certificate = certify(mesh, loops.pairs, Basis_kind::PURE, false);
  if(!certificate.closed_on_surface || !certificate.basis)
    require_none(file, lines_of(certificate.failure));
  return std::move(loops.pairs);
}

Pairs pairs_of(const Mesh& mesh, const Remove_options& options, bool show_progress) {
  if(!options.loops_file.empty())
    return read_basis(mesh, options.loops_file);
  Solve_options solve_options;
  solve_options.number_of_threads = options.number_of_threads;
  Progress_bar bar(show_progress);
  return host_backend.solve(mesh, solve_options, bar).pairs;
}

// Those with a measure below a length, by number.
std::vector<std::size_t>
pairs_of_noise(const Mesh& mesh, const Pairs& pairs, const Remove_options& options, double below) {
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  const Thread_limit limit(options.number_of_threads);
  const Measures measures = find_measures(mesh, pairs, parse_precision(options.precision), bar);
  std::vector<std::size_t> numbers;
  for(std::size_t i = 0; i < measures.size(); ++i)
    if(const std::optional<double> noise = noise_of(measures[i]); noise && *noise < below)
      numbers.push_back(i);
    else if(!noise)
      std::fprintf(stderr, "htloops: pair %zu stays, as it is not measured: %s\n", i,
                   measures[i].why.c_str());
  return numbers;
}

Removal_options wish(const Mesh& mesh, const Pairs& pairs, const Remove_options& options) {
  Removal_options removal;
  removal.target_genus = options.genus.value_or(0);
  const double whole = diagonal_of(mesh);
  removal.maximal_length = parse_length("--shorter-than", options.shorter_than, whole);
  if(!options.pairs.empty())
    removal.pairs.emplace();
  for(const std::string& text : options.pairs) {
    const auto [number, method] = parse_pair(text);
    removal.pairs->push_back(number);
    if(method)
      removal.methods[number] = *method;
  }
  removal.box = box_of(options.box);
  if(const auto length = parse_length("--necks", options.necks, whole))
    removal.maximal_length = removal.maximal_neck_length = *length;
  if(const auto length = parse_length("--noise-below", options.noise_below, whole))
    removal.pairs = pairs_of_noise(mesh, pairs, options, *length);
  if(!options.bores.empty()) {
    const auto [least, most] = parse_range(options.bores);
    removal.minimal_bore_diameter = least;
    removal.maximal_bore_diameter = most;
  }
  removal.method = methods.at(options.method);
  removal.force = options.is_forced;
  removal.number_of_threads = options.number_of_threads;
  return removal;
}

// Handles that were asked for are to be seen.
View view_of(const Remove_options& options, const Pairs& chosen, const Pairs& all) {
  View view = options.view;
  if(chosen.size() < all.size())
    for(const Pair& pair : chosen)
      choose(view, pair);
  return view;
}

void write_files(const Remove_options& options, const Removal_shown& shown) {
  if(!options.json_file.empty())
    write_removal_json(options.json_file, shown.report);
  const Pairs chosen = pairs_to_remove(shown.pairs, shown.report);
  const View view = view_of(options, chosen, shown.pairs);
  if(!options.picture.file.empty())
    export_picture(options.picture, view, drawn_surface(shown.before), lines_of(chosen));
  if(!options.page_file.empty())
    write_removal_page(options.page_file, view, shown);
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

void show(const Remove_options& options,
          const std::string& words,
          const Removal_answer& answer,
          double loops_seconds,
          double read_seconds) {
  if(options.is_quiet)
    return;
  const std::string text =
      words + table_of_removals(answer.report, options.show_all) + summary(answer.report) +
      formatted("%.2f s after %.2f s for the loops and %.2f s of reading, ", answer.total_seconds,
                loops_seconds, read_seconds) +
      counted(static_cast<std::size_t>(answer.number_of_threads), "thread", "threads") + "\n" +
      (options.is_dry_run ? "this was a dry run: no mesh is written\n" : "");
  const bool is_mesh_shown =
      (options.result_file == "-" && !options.is_dry_run) || options.is_mesh_on_standard_output();
  show_text(text, is_mesh_shown || options.json_file == "-" || options.page_file == "-");
}

void run(const Remove_options& options) {
  check_options(options);
  const Stopwatch stopwatch;
  auto [mesh, properties] = read(options);
  const double read_seconds = stopwatch.seconds();
  write_read_mesh(options, mesh);
  check_lengths(options, diagonal_of(mesh));
  const bool show_progress = !options.is_quiet && is_terminal(stderr);
  const Stopwatch loops_stopwatch;
  const Pairs pairs = pairs_of(mesh, options, show_progress);
  const double loops_seconds = loops_stopwatch.seconds();
  Progress_bar bar(show_progress);
  const Removal_answer answer = remove_handles(mesh, pairs, wish(mesh, pairs, options), bar);
  if(!options.is_dry_run) {
    spread_properties(answer, properties);
    write_mesh(options.result_file, answer.mesh, properties);
    if(!options.map_file.empty())
      write_map_json(options.map_file, mesh, answer);
  }
  write_files(options, {options.mesh_file, mesh, pairs, answer.report, answer.mesh});
  show(options, words_of_length(options, mesh, pairs.size(), answer.report), answer, loops_seconds,
       read_seconds);
}

CLI::Option* add_bores_option(CLI::App& command, std::string& range) {
  return command
      .add_option("--bores", range,
                  "round bores, of a diameter in a range, in the unit of the\n"
                  "coordinates: 3:8, 3: or :8; without one, all round bores")
      ->option_text("[MIN:MAX]");
}

void add_selection_options(CLI::App& command, Remove_options& options) {
  command.option_defaults()->group("What to remove (default: all handles)");
  CLI::Option* selections[] = {
      command.add_option("--genus", options.genus, "the smallest, until genus G is left")
          ->option_text("G"),
      add_length(command, "--shorter-than", options.shorter_than,
                 "handles with a loop that is shorter: a length around, in the\n"
                 "unit of the mesh; %: of the diagonal of the box"),
      command
          .add_option("--pairs", options.pairs,
                      "those of some pairs, as 'htloops loops' counts;\n"
                      "each may have a way of its own: 1:fill,2:cut,5")
          ->option_text("I[:WAY],...")
          ->delimiter(',')
          ->allow_extra_args(false),
      add_box_option(command, options.box, "handles"),
      add_length(command, "--necks", options.necks,
                 "handles with a loop that is shorter, and necks:\n"
                 "shorter loops at which shells come apart"),
      add_noise_option(command, options.noise_below, "handles"),
      add_bores_option(command, options.bores),
  };
  for(CLI::Option* const option : selections) {
    for(CLI::Option* const other : selections)
      if(other != option)
        option->excludes(other);
  }
}

void add_computation_options(CLI::App& command, Remove_options& options) {
  command.option_defaults()->group("How to remove");
  add_choice(command, "--by", "WAY", options.method,
             "cut, fill, or smallest-change, the default: what\n"
             "changes the shape less, or as it can be done",
             methods);
  command.add_flag("--force", options.is_forced,
                   "also where that is no repair: where the bounding box\n"
                   "would grow, a cap be far larger than its hole, ...");
  add_precision_option(command, options.precision);
  command.add_flag("--yes", options.is_sure,
                   "also where --shorter-than, --necks or --noise-below is more than the\n"
                   "diagonal of the box: then it may be a percentage without %");
  command
      .add_option("--loops", options.loops_file,
                  "take the pairs from what 'htloops loops MESH -o' wrote")
      ->option_text("LOOPS.json")
      ->type_name(input_file);
  add_threads_option(command, options);
}

void add_output_options(CLI::App& command, Remove_options& options) {
  command.option_defaults()->group("What to write");
  add_output(command, "-o,--output", "OUT", options.result_file,
             "the mesh: " + words_of_written_meshes() + "; - is standard output, OFF");
  command.add_flag("--dry-run", options.is_dry_run, "all but the mesh");
  add_output(command, "--report", "FILE.json", options.json_file, "what was done, as JSON");
  add_output(command, "--map", "FILE.json", options.map_file,
             "what each vertex and face was before, as JSON");
  add_picture_options(command, options, "the loops of what is removed");
  add_page_option(command, options, "the mesh before and after");
  add_view_options(command, options);
}

constexpr char remove_description[] = R"(Removes handles of a triangle mesh.

A handle is cut, along its handle loop, or its hole is filled, along its tunnel loop; the ends
are closed by discs that meet the surface nowhere else. The rest of the mesh stays as it is,
numbers and colours of its vertices, too, where the file that is written has room for them.
A handle that neither can be done to, or where that would be no repair, is refused, by name and
with the number that says so; that is no failure.
)";

constexpr char remove_examples[] = R"(Examples:
  htloops remove scan.ply -o clean.ply            all handles
  htloops remove scan.ply -o clean.ply --shorter-than 3%
                                                  the small ones
  htloops remove part.stl -o part.off --pairs 0:fill,3:fill
                                                  two bores
  htloops remove part.stl -o part.off --bores 3:8
                                                  those from 3 to 8 wide
  htloops remove scan.ply --genus 2 --dry-run --html look.html
                                                  what would go, if two are to stay
)";

} // namespace

void write_out_bores(std::vector<std::string>& arguments) {
  for(std::size_t i = 0; i < arguments.size(); ++i)
    if(arguments[i] == "--bores" &&
       (i + 1 == arguments.size() || arguments[i + 1].empty() ||
        arguments[i + 1].find_first_not_of("0123456789.:eE+") != std::string::npos))
      arguments[i] = "--bores=:";
}

void add_remove_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Remove_options>();
  CLI::App* remove = app.add_subcommand("remove", remove_description)->group("Commands");
  add_mesh_argument(*remove, *options, mesh_kinds());
  add_output_options(*remove, *options);
  add_remedy_options(*remove, *options);
  add_selection_options(*remove, *options);
  add_computation_options(*remove, *options);
  remove->option_defaults()->group("What to show");
  remove->add_flag("--all", options->show_all, "all rows of a long table");
  remove->add_flag("-q,--quiet", options->is_quiet, "nothing but errors");
  complete_help(*remove, remove_examples);
  remove->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
