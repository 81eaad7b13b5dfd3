// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/loops_options.h"

#include "app/failure.h"
#include "app/solve/backends.h"
#include "app/solve/details.h"
#include "app/solve/progress.h"
#include "app/write/channel_formats.h"
#include "app/write/files.h"
#include "commands/command.h"
#include "terminal/terminal.h"

#include <map>
#include <utility>

namespace htloops {
namespace {

const std::map<std::string, Pair_order> orders = {{"size", Pair_order::SIZE},
                                                  {"length", Pair_order::LENGTH},
                                                  {"pair", Pair_order::PAIR},
                                                  {"place", Pair_order::PLACE},
                                                  {"noise", Pair_order::NOISE}};

void add_table_options(CLI::App& command, Loops_options& options) {
  add_output(command, "--csv", "FILE.csv", options.csv_file,
             "a table with a row for each pair; a mesh without pairs has one row without a\n"
             "pair, and a mesh that fails has one with the error");
  add_output(command, "--jsonl", "FILE.jsonl", options.jsonl_file,
             "a JSON object on one line for each mesh: genus, sizes, times, error");
  command.add_flag("--resume", options.do_resume,
                   "continue the files of --csv and --jsonl after an interruption: meshes that "
                   "are\nalready in them are skipped");
}

void add_channels_option(CLI::App& command, Loops_options& options) {
  add_output(command, "--channels", "FILE", options.channels_file,
             "the paths through the holes, with the clear radius along them: .pdb (radius as\n"
             "B factor) and .bild for molecules, .csv" +
                 std::string(options.is_to_measure ? "" : "; needs --measure"));
}

void add_output_options(CLI::App& command, Loops_options& options) {
  command.option_defaults()->group("What to write");
  add_json_option(command, options, "the loops");
  add_table_options(command, options);
  add_lines_option(command, options, "the loops");
  add_output(command, "--events", "FILE.json", options.events_file,
             "the splits and merges of the fronts of the first pass, as JSON");
  add_channels_option(command, options);
  add_output(command, "--layers", "FILE.ply", options.layers_file,
             "the mesh with the layers and arrival times of the first pass");
  add_picture_options(command, options, "the loops");
  add_closeup_option(command, options);
  add_page_option(command, options, "the mesh and the loops");
  add_gltf_option(command, options, "the loops");
  add_part(command, "--moment", options.moment,
           "show the layers and fronts of the first pass instead of the loops, in the\n"
           "picture and the model, at this fraction of its time, 0 to 1");
  add_view_options(command, options);
}

void add_jobs_option(CLI::App& command, Loops_options& options) {
  command
      .add_option("--jobs", options.number_of_jobs,
                  "number of meshes to process at once, each in its own thread; default: 1")
      ->option_text("N")
      ->check(CLI::Range(1, 1024));
}

void add_costs_option(CLI::App& command, Loops_options& options, const std::string& condition) {
  command.add_flag("--removal", options.has_costs,
                   condition + "the cost of removing each handle alone, by cut and by\n" +
                       "fill: the area and the volume that would change");
}

void add_computation_options(CLI::App& command, Loops_options& options) {
  command.option_defaults()->group("How to compute");
  add_choice(command, "--backend", "NAME", options.backend,
             "auto, host, cuda or reference; default: auto, a CUDA device if there is one",
             names_of_backends());
  command.add_flag(
      "--literal", options.is_literal,
      "with --backend reference: follow the literal rules of the paper, and no others;\n"
      "loops are not shortened, and are classified as by --classify offset; exit code\n"
      "1 if the rules find no loops");
  add_threads_option(command, options);
  add_jobs_option(command, options);
  command
      .add_option("--seed", options.seed,
                  "vertex where the front starts, counted from 0; default: the first")
      ->option_text("VERTEX")
      ->check(why_no_count);
  add_choice(
      command, "--basis", "KIND", options.basis,
      "pure (handle loops bound inside, tunnel loops outside; the default) or\n"
      "shortest (loops may bound on either side or on none: for cutting and\nparametrization)",
      {"pure", "shortest"});
  command.add_flag(
      "--waists", options.do_find_waists,
      "also find the waist of each boundary curve, a short loop of its class; the only\n"
      "boundary curve of a component has none");
  command.add_flag(
      "--throats", options.do_find_throats,
      "find all throats, not only a basis: closed geodesics that are shorter than the\n"
      "loops next to them. The CSV, lines, pictures and page show them instead of\n"
      "the pairs");
  command
      .add_option("--through", options.through,
                  "with --throats: add those to which loops through these vertices tighten")
      ->option_text("VERTEX,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(why_no_count);
  command.add_flag("--no-refine", options.do_not_refine,
                   "keep the handle loops of the first pass: faster");
  command.add_flag("--no-tighten", options.do_not_tighten,
                   "neither tighten the loops nor look for shorter ones; implies\n"
                   "--no-coarsen, so it is slower on large meshes");
  command.add_flag("--no-coarsen", options.do_not_coarsen,
                   "always find the loops on the mesh itself, never on a coarse mesh of the same\n"
                   "topology: slower");
  command
      .add_option("--search-effort", options.search_effort,
                  "effort of the search for shorter loops in other classes, as a multiple of the\n"
                  "vertices visited by default: 0 to 1000; default: 1")
      ->option_text("FACTOR")
      ->check(CLI::Range(0., 1000.))
      ->check(why_not_finite);
  command
      .add_option("--time-budget", options.time_budget,
                  "stop the search for shorter loops in other classes after this many seconds;\n"
                  "all other steps are completed, and the loops are certified as usual")
      ->option_text("SECONDS")
      ->check(why_not_finite);
  command.add_flag("--measure", options.is_to_measure,
                   "measure the thickness of each handle and the clear width of its hole: the\n"
                   "diameters of the largest balls that fit around and through it");
  add_costs_option(command, options, "with --measure: ");
  add_choice(command, "--classify", "HOW", options.classifier,
             "how to tell handle loops from tunnel loops: linking (linking numbers, exact;\n"
             "the default) or offset (change of length: faster, but loops need not bound)",
             {"linking", "offset"});
}

void add_listing_options(CLI::App& command, Listing_choice& choice) {
  add_order_option(command, choice.order);
  add_length(command, "--shorter-than", choice.shorter_than,
             "only pairs with a loop shorter than this; %: of the diagonal of the bounding box");
  add_length(command, "--longer-than", choice.longer_than,
             "only pairs with both loops longer than this");
  add_noise_option(command, choice.noise_below, "only pairs");
  add_box_option(command, choice.box, "only pairs");
}

void add_display_options(CLI::App& command, Loops_options& options) {
  command.option_defaults()->group("What to show");
  add_listing_options(command, options.listing);
  command.add_flag("--all-rows", options.show_all, "show all rows of a long table");
  command.add_flag("-q,--quiet", options.is_quiet, "print only errors");
  command.add_flag("-v,--verbose", options.is_verbose, "also print why no CUDA device was used");
  add_choice(command, "--color", "WHEN", options.colour, "auto, always or never; default: auto",
             {"auto", "always", "never"});
}

// What there would be several of.
void refuse_files_of_one_mesh(const Loops_options& options) {
  const std::pair<const char*, bool> given[] = {
      {"--output", !options.json_file.empty()},
      {"--events", !options.events_file.empty()},
      {"--layers", !options.layers_file.empty()},
      {"--channels", !options.channels_file.empty()},
      {"--lines", !options.lines_files.empty()},
      {"--picture", !options.picture.file.empty()},
      {"--html", !options.page_file.empty()},
      {"--gltf", !options.gltf_file.empty()},
      {"--write-mesh", !options.written_mesh_file.empty()},
      {"--through", !options.through.empty()},
      {"--seed", options.seed.has_value()}};
  for(const auto& [name, is_given] : given)
    if(is_given)
      throw wrong_usage(std::string(name) + " is for one mesh; for several, use --jsonl and --csv");
}

/// throws `Failure` if an option makes no sense.
void check_listing_choice(const Listing_choice& choice) {
  parse_length("--shorter-than", choice.shorter_than);
  parse_length("--longer-than", choice.longer_than);
  parse_length("--noise-below", choice.noise_below);
  box_of(choice.box);
}

// What was chosen, with percentages of the diagonal of a mesh.
Listing_options listing_options(const Listing_choice& choice, const Mesh& mesh) {
  Listing_options options;
  const double whole = diagonal_of(mesh);
  options.order = order_of(choice.order);
  if(const auto length = parse_length("--shorter-than", choice.shorter_than, whole))
    options.shorter_than = *length;
  if(const auto length = parse_length("--longer-than", choice.longer_than, whole))
    options.longer_than = *length;
  if(const auto length = parse_length("--noise-below", choice.noise_below, whole))
    options.noise_below = *length;
  options.box = box_of(choice.box);
  return options;
}

Answer solve(const Mesh& mesh, const Loops_options& options, bool show_progress) {
  Solve_options solve_options;
  if(options.seed)
    solve_options.seed = vertex_of_mesh(mesh, *options.seed);
  solve_options.do_refine_handles = !options.do_not_refine;
  if(options.is_literal)
    solve_options.literal_rules = CGAL::Handle_tunnel_loops::Literal_rules::all();
  solve_options.do_tighten = !options.do_not_tighten && !options.is_literal;
  solve_options.do_coarsen = !options.do_not_coarsen;
  solve_options.search_effort = options.search_effort;
  if(options.time_budget)
    solve_options.maximum_running_time = *options.time_budget;
  solve_options.do_compute_linking = options.classifier == "linking" && !options.is_literal;
  solve_options.basis_kind = options.basis == "pure" ? Basis_kind::PURE : Basis_kind::SHORTEST;
  solve_options.do_log_fronts = !options.events_file.empty() || options.moment;
  solve_options.do_find_layers = !options.layers_file.empty() || options.moment;
  solve_options.number_of_threads = options.number_of_threads;
  Progress_bar bar(show_progress);
  Answer answer = choose_backend(options.backend).solve(mesh, solve_options, bar);
  if(options.backend == "auto" && cuda_backend.solve == nullptr)
    answer.statistics.fallback = "this htloops was built without CUDA";
  const Thread_limit limit(options.number_of_threads);
  add_details(mesh, options.do_find_waists, answer);
  if(options.has_measures()) {
    const Stopwatch stopwatch;
    answer.measures = find_measures(mesh, answer.pairs, bar);
    answer.total_seconds += stopwatch.seconds();
  }
  if(options.has_costs) {
    const Stopwatch stopwatch;
    answer.costs = find_costs(mesh, answer.pairs, bar);
    answer.total_seconds += stopwatch.seconds();
  }
  if(options.do_find_throats) {
    std::vector<Mesh::Vertex_index> through;
    for(const std::uint32_t v : options.through)
      through.push_back(vertex_of_mesh(mesh, v));
    answer.throats = find_throats(mesh, answer.pairs, answer.certificate, through);
    answer.total_seconds += answer.throats.seconds;
  }
  return answer;
}

} // namespace

void add_loops_options(CLI::App& command, Loops_options& options) {
  add_input(command, "MESH", options.mesh_files, mesh_kinds("triangle meshes"));
  add_format_option(command, options);
  add_output_options(command, options);
  add_remedy_options(command, options);
  add_computation_options(command, options);
  add_display_options(command, options);
}

void add_order_option(CLI::App& command, std::string& order) {
  add_choice(command, "--sort", "KEY", order,
             "size (of the shorter loop), length (of both), pair (the number), place, or\n"
             "noise (the smaller measure); default: " +
                 order + ", the smallest first",
             orders);
}

Pair_order order_of(const std::string& word) { return orders.at(word); }

CLI::Option* add_noise_option(CLI::App& command, std::string& length, const std::string& what) {
  return add_length(command, "--noise-below", length,
                    what +
                        " that are thinner than this, or whose hole is narrower; measures\nthem");
}

void add_measure_options(CLI::App& command, Loops_options& options) {
  options.is_to_measure = true;
  options.listing.order = "noise";
  add_input(command, "MESH", options.mesh_files, mesh_kinds("triangle meshes"));
  add_format_option(command, options);
  command.option_defaults()->group("What to write");
  add_json_option(command, options, "the loops with their measures");
  add_table_options(command, options);
  add_picture_options(command, options, "the loops");
  add_closeup_option(command, options);
  add_page_option(command, options, "the mesh, the loops and the balls");
  add_channels_option(command, options);
  add_view_options(command, options);
  add_remedy_options(command, options);
  command.option_defaults()->group("How to compute");
  add_costs_option(command, options, "");
  add_threads_option(command, options);
  add_jobs_option(command, options);
  add_display_options(command, options);
}

void check_loops_options(const Loops_options& options) {
  choose_backend(options.backend);
  check_common_options(options);
  if(options.is_literal && options.backend != "reference")
    throw wrong_usage("--literal needs --backend reference");
  if(options.has_measures() && options.basis != "pure")
    throw wrong_usage(
        "measures need handle and tunnel loops: they cannot be combined with --basis shortest");
  if(options.listing.order == "noise" && !options.has_measures())
    throw wrong_usage("--sort noise needs --measure");
  if(options.has_costs && !options.has_measures())
    throw wrong_usage("--removal needs --measure");
  if(options.time_budget && *options.time_budget < 0.)
    throw wrong_usage("--time-budget must be a number of seconds, 0 or more");
  if(!options.through.empty() && !options.do_find_throats)
    throw wrong_usage("--through needs --throats");
  check_suffix(options.layers_file, ".ply");
  check_channel_format(options.channels_file);
  if(!options.channels_file.empty() && !options.has_measures())
    throw wrong_usage("--channels shows clear widths: it needs --measure");
  if(options.moment && options.picture.file.empty() && options.gltf_file.empty())
    throw wrong_usage(
        std::string("--moment chooses a time at which to show the layers: it needs ") +
        (has_pictures ? "--picture or --gltf" : "--gltf"));
  check_name(options.csv_file, "a table as CSV", {".csv"});
  check_name(options.jsonl_file, "lines of JSON", {".jsonl"});
  check_name(options.events_file, "events as JSON", {".json"});
  check_listing_choice(options.listing);
  if(options.is_batch)
    refuse_files_of_one_mesh(options);
  if(options.do_resume && ((options.csv_file.empty() && options.jsonl_file.empty()) ||
                           options.csv_file == "-" || options.jsonl_file == "-"))
    throw wrong_usage("--resume continues files: it needs --csv FILE.csv or --jsonl FILE.jsonl");
}

Json names_of(const Repair_steps& steps) {
  Json names = Json::array();
  for(std::size_t i = 0; i < number_of_repair_steps; ++i)
    if(steps.test(i))
      names.push_back(name_of(static_cast<Repair_step>(i)));
  return names;
}

Json json_of(const Loops_options& options) {
  Json json = {
      {"basis", options.basis},
      {"classify", options.is_literal ? "offset" : options.classifier},
      {"backend", options.backend},
      {"literal", options.is_literal},
      {"seed", options.seed ? Json(*options.seed) : Json()},
      {"refine", !options.do_not_refine},
      {"tighten", !options.do_not_tighten && !options.is_literal},
      {"coarsen", !options.do_not_coarsen && !options.do_not_tighten && !options.is_literal},
      {"search_effort", options.search_effort},
      {"time_budget", options.time_budget ? Json(*options.time_budget) : Json()},
      {"waists", options.do_find_waists},
      {"measure", options.has_measures()},
      {"removal", options.has_costs},
      {"throats", options.do_find_throats},
      {"through", options.through},
      {"triangulate", options.remedies.do_triangulate},
      {"repair", options.remedies.do_repair}};
  if(options.remedies.do_repair && !options.remedies.steps.all())
    json["repair_steps"] = names_of(options.remedies.steps);
  return json;
}

std::pair<Mended_mesh, Mesh_line> read_and_solve(const Loops_options& options, bool show_progress) {
  const Stopwatch stopwatch;
  Mended_mesh mended = read_mended_mesh(options);
  const Mesh& mesh = mended.mesh;
  Mesh_line line = {options.mesh_file};
  line.number_of_vertices = mesh.number_of_vertices();
  line.number_of_faces = mesh.number_of_faces();
  line.read_seconds = stopwatch.seconds();
  line.answer = solve(mesh, options, show_progress);
  line.answer.unit = mended.facts.unit;
  write_read_mesh(options, mended);
  line.listing = list_pairs(mesh, line.answer, listing_options(options.listing, mesh));
  return {std::move(mended), std::move(line)};
}

Mesh_line line_of(const std::string& mesh_file, const std::function<Mesh_line()>& solve) {
  Mesh_line line;
  const Outcome outcome = outcome_of([&] { line = solve(); });
  return outcome.exit_code == 0 ? line : Mesh_line{mesh_file, outcome.exit_code, outcome.message};
}

} // namespace htloops
