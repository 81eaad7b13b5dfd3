// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/remove_options.h"

#include "app/failure.h"
#include "app/numbers.h"
#include "app/write/mesh_writer.h"
#include "app/write/tables.h"
#include "commands/command.h"
#include "commands/loops_options.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace htloops {
namespace {

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
    throw wrong_usage(
        "--pairs: '" + text +
        "' is neither the number of a pair, such as 5, nor a number with a way, such as 1:fill");
  if(way == methods.end())
    return {number, std::nullopt};
  return {number, way->second};
}

// Each has one way.
void check_pairs(const std::vector<std::string>& texts) {
  std::map<std::size_t, std::optional<Removal_method>> ways;
  for(const std::string& text : texts) {
    const auto [number, way] = parse_pair(text);
    if(ways.try_emplace(number, way).first->second != way)
      throw wrong_usage("--pairs: pair " + std::to_string(number) + " is given two ways");
  }
}

std::optional<double> parse_diameter(const std::string& text) {
  if(text.empty())
    return std::nullopt;
  double diameter = 0.;
  if(!parse_number(text, diameter) || !(diameter >= 0.) || !std::isfinite(diameter))
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
    throw wrong_usage("--bores " + text + ": write the smaller diameter first, such as 3:8");
  return {least, most};
}

CLI::Option* add_bores_option(CLI::App& command, std::string& range) {
  return command
      .add_option("--bores", range,
                  "round bores with a diameter in this range, in the unit of the\n"
                  "coordinates: 3:8, 3: or :8; without a range, all round bores")
      ->option_text("[MIN:MAX]");
}

void add_selection_options(CLI::App& command, Remove_options& options) {
  command.option_defaults()->group("What to remove");
  CLI::Option* selections[] = {
      command.add_flag("--all", options.are_all_meant, "all handles"),
      command.add_option("--genus", options.genus, "the smallest handles, until genus G is left")
          ->option_text("G")
          ->check(why_no_count),
      add_length(command, "--shorter-than", options.shorter_than,
                 "handles with a loop shorter than this: a circumference, in the\n"
                 "unit of the mesh; %: of the diagonal of the bounding box"),
      command
          .add_option("--pairs", options.pairs,
                      "handles of these pairs, as numbered by 'htloops loops';\n"
                      "each may have its own way: 1:fill,2:cut,5")
          ->option_text("I[:WAY],...")
          ->delimiter(',')
          ->allow_extra_args(false),
      add_box_option(command, options.box, "handles"),
      add_length(command, "--necks", options.necks,
                 "handles with a loop shorter than this, and necks: loops\n"
                 "shorter than this at which shells separate"),
      add_length(command, "--channels", options.channels,
                 "channels between an outer and an inner wall, shorter around\n"
                 "than this, whose removal separates the inner wall"),
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
             "cut, fill or smallest-change (the default): the way\n"
             "that changes the shape less, or the only possible one",
             methods);
  command.add_flag("--force", options.is_forced,
                   "remove handles even if that is not a repair: if the bounding\n"
                   "box would grow, a cap would be far larger than its hole, more\n"
                   "faces would intersect, ...");
  add_yes_option(command, options.is_sure, "--shorter-than, --necks, --channels or --noise-below");
  command
      .add_option("--loops", options.loops_file,
                  "take the pairs from a file written by 'htloops loops MESH -o'")
      ->option_text("LOOPS.json")
      ->type_name(input_file);
  add_threads_option(command, options);
}

void add_output_options(CLI::App& command, Remove_options& options) {
  command.option_defaults()->group("What to write");
  add_output(command, "-o,--output", "OUT", options.result_file,
             "the resulting mesh; - writes OFF to standard output; else" +
                 words_of_written_meshes());
  command.add_flag("--dry-run", options.is_dry_run, "do everything except writing the mesh");
  add_output(command, "--report", "FILE.json", options.json_file, "what was done, as JSON");
  add_output(command, "--map", "FILE.json", options.map_file,
             "the original vertex or face of each vertex and face, as JSON");
  add_output(command, "--csv", "FILE.csv", options.csv_file,
             "a table with a row for each handle, and what was done to it");
  add_picture_options(command, options, "the loops of the removed handles");
  add_closeup_option(command, options);
  add_page_option(command, options, "the mesh before and after");
  add_gltf_option(command, options, "the loops of the removed handles");
  add_view_options(command, options);
}

void add_display_options(CLI::App& command, Remove_options& options) {
  command.option_defaults()->group("What to show");
  add_order_option(command, options.order);
  command.add_flag("--all-rows", options.show_all, "show all rows of a long table");
  command.add_flag("-q,--quiet", options.is_quiet, "print only errors");
}

} // namespace

bool has_choice(const Remove_options& options) {
  return options.are_all_meant || options.genus || !options.shorter_than.empty() ||
         !options.pairs.empty() || !options.box.empty() || !options.necks.empty() ||
         !options.channels.empty() || !options.noise_below.empty() || !options.bores.empty();
}

void check_remove_options(const Remove_options& options) {
  if(options.result_file.empty() && !options.is_dry_run && has_choice(options))
    throw wrong_usage("-o OUT is needed, or --dry-run");
  check_mesh_format(options.result_file);
  parse_length("--shorter-than", options.shorter_than);
  parse_length("--necks", options.necks);
  parse_length("--channels", options.channels);
  parse_length("--noise-below", options.noise_below);
  box_of(options.box);
  check_pairs(options.pairs);
  if(!options.bores.empty()) {
    parse_range(options.bores);
    if(methods.at(options.method) == Removal_method::CUT)
      throw wrong_usage("--bores fills bores: it cannot be combined with --by cut");
  }
  if(!options.channels.empty() && methods.at(options.method) == Removal_method::CUT)
    throw wrong_usage("--channels fills channels: it cannot be combined with --by cut");
  if(!options.map_file.empty() && options.is_dry_run)
    throw wrong_usage(
        "--map describes the vertices of the written mesh: it cannot be combined with "
        "--dry-run");
  if(options.order == "noise" && options.noise_below.empty())
    throw wrong_usage("--sort noise needs --noise-below, which measures the handles");
  check_name(options.csv_file, "a table as CSV", {".csv"});
  check_name(options.map_file, "a map as JSON", {".json"});
  check_common_options(options);
}

void check_lengths(const Remove_options& options, double diagonal) {
  if(options.is_sure)
    return;
  check_length_of_mesh("--shorter-than", options.shorter_than, diagonal);
  check_length_of_mesh("--necks", options.necks, diagonal);
  check_length_of_mesh("--channels", options.channels, diagonal);
  check_length_of_mesh("--noise-below", options.noise_below, diagonal);
}

Removal_options removal_options(const Remove_options& options, double diagonal) {
  Removal_options removal;
  removal.target_genus = options.genus.value_or(0);
  removal.maximal_length = parse_length("--shorter-than", options.shorter_than, diagonal);
  if(!options.pairs.empty())
    removal.pairs.emplace();
  for(const std::string& text : options.pairs) {
    const auto [number, method] = parse_pair(text);
    removal.pairs->push_back(number);
    if(method)
      removal.methods[number] = *method;
  }
  removal.box = box_of(options.box);
  if(const auto length = parse_length("--necks", options.necks, diagonal))
    removal.maximal_length = removal.maximal_neck_length = *length;
  if(const auto length = parse_length("--channels", options.channels, diagonal)) {
    removal.maximal_length = removal.maximal_neck_length = *length;
    removal.only_channels = true;
  }
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

void add_remove_options(CLI::App& command, Remove_options& options) {
  add_mesh_argument(command, options, mesh_kinds());
  add_output_options(command, options);
  add_remedy_options(command, options);
  add_selection_options(command, options);
  add_computation_options(command, options);
  add_display_options(command, options);
}

void write_out_bores(std::vector<std::string>& arguments) {
  for(std::size_t i = 0; i < arguments.size(); ++i)
    if(arguments[i] == "--bores" &&
       (i + 1 == arguments.size() || arguments[i + 1].empty() ||
        arguments[i + 1].find_first_not_of("0123456789.:eE+") != std::string::npos))
      arguments[i] = "--bores=:";
}

} // namespace htloops
