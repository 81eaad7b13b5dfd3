// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/command.h"
#include "commands/common_options.h"
#include "commands/file_options.h"
#include "commands/help_style.h"
#include "commands/listing_choice.h"
#include "failure.h"
#include "solve/backends.h"
#include "solve/stopwatch.h"
#include "terminal/interrupt.h"
#include "terminal/progress_bar.h"
#include "terminal/terminal.h"
#include "words.h"
#include "write/events_writer.h"
#include "write/export_gltf.h"
#include "write/export_lines.h"
#include "write/loops_json_writer.h"
#include "write/loops_page.h"
#include "write/pair_csv.h"
#include "write/pair_table.h"

#include <cstdio>
#include <memory>
#include <string>

namespace htloops {
namespace {

struct Loops_options : Common_options
{
  std::string events_file;
  std::string csv_file;
  Listing_choice listing;
  std::string backend = "auto";
  std::optional<std::uint32_t> seed;
  bool do_not_refine = false;
  bool do_not_tighten = false;
  bool do_find_waists = false;
  std::string basis = "pure";
  std::string classifier = "linking";
  bool show_all = false;
  std::string colour = "auto";
};

Answer solve(const Backend& backend, const Mesh& mesh, const Loops_options& options) {
  Solve_options solve_options;
  if(options.seed)
    solve_options.seed = vertex_of_mesh(mesh, *options.seed);
  solve_options.do_refine_handles = !options.do_not_refine;
  solve_options.do_tighten = !options.do_not_tighten;
  solve_options.do_compute_linking = options.classifier == "linking";
  using CGAL::Handle_tunnel_loops::Basis_kind;
  solve_options.basis_kind = options.basis == "pure" ? Basis_kind::PURE : Basis_kind::SHORTEST;
  solve_options.do_log_fronts = !options.events_file.empty();
  solve_options.number_of_threads = options.number_of_threads;
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  return backend.solve(mesh, solve_options, bar);
}

// What is told of an answer besides the whole basis.
struct Told
{
  Pair_listing listing;
  std::string summary; // without colours
};

Told told_of(const Loops_options& options,
             const Mesh& mesh,
             const Answer& answer,
             double read_seconds) {
  return {list_pairs(mesh, answer.pairs, listing_options(options.listing, mesh)),
          summary(answer, read_seconds, {options.show_all, false})};
}

void write_files(const Loops_options& options,
                 const Mesh& mesh,
                 const Answer& answer,
                 const Told& told,
                 double read_seconds) {
  if(!options.json_file.empty())
    write_loops_json(options.json_file, mesh, answer, read_seconds);
  if(!options.events_file.empty())
    write_events(options.events_file, answer);
  if(!options.csv_file.empty())
    write_pair_csv(options.csv_file, answer, told.listing);
  for(const std::string& file : options.lines_files)
    export_lines(file, lines_of(answer, told.listing));
  if(!options.picture_file.empty())
    export_picture(options.picture_file, options.view, drawn_surface(mesh),
                   lines_of(answer, told.listing));
  if(!options.gltf_file.empty())
    export_gltf(options.gltf_file, drawn_surface(mesh), lines_of(answer, told.listing));
  if(!options.page_file.empty())
    write_loops_page(options.page_file, options.view, options.mesh_file, mesh, answer, told.listing,
                     told.summary);
}

bool is_output_taken(const Loops_options& options) {
  return options.json_file == "-" || options.csv_file == "-" || options.page_file == "-" ||
         options.is_mesh_on_standard_output();
}

void show(const Loops_options& options, const Answer& answer, const Told& told) {
  if(options.is_quiet)
    return;
  std::FILE* stream = is_output_taken(options) ? stderr : stdout;
  const Table_options table{options.show_all, use_colour(options.colour, stream)};
  std::string text = table_of_pairs(told.listing, table);
  if(const std::size_t left_out = answer.pairs.size() - told.listing.size(); left_out > 0)
    text += counted(left_out, "pair is", "pairs are") + " left out as asked for\n";
  show_text(text + told.summary, is_output_taken(options));
}

void run(const Loops_options& options) {
  const Backend& backend = choose_backend(options.backend);
  check_common_options(options);
  check_listing_choice(options.listing);
  const Stopwatch stopwatch;
  const Mesh mesh = read_mesh(options);
  const double read_seconds = stopwatch.seconds();
  const Interrupt_guard guard;
  write_read_mesh(options, mesh);
  Answer answer = solve(backend, mesh, options);
  if(answer.statistics.number_of_boundaries > 0)
    answer.boundaries = find_boundaries(mesh, options.do_find_waists);
  const Told told = told_of(options, mesh, answer, read_seconds);
  write_files(options, mesh, answer, told, read_seconds);
  show(options, answer, told);
}

void add_output_options(CLI::App& command, Loops_options& options) {
  const char group[] = "What to write";
  add_json_option(command, options, "the loops", group);
  command.add_option("--csv", options.csv_file, "a row of numbers for each pair")
      ->option_text("FILE.csv")
      ->type_name(output_file)
      ->group(group);
  add_lines_option(command, options, "the loops", group);
  command
      .add_option("--events", options.events_file,
                  "what happens to the fronts of the first pass, as JSON")
      ->option_text("FILE.json")
      ->type_name(output_file)
      ->group(group);
  add_picture_options(command, options, "the loops", group);
  add_page_option(command, options, "the mesh and the loops", group);
  add_gltf_option(command, options, "the loops", group);
  add_view_options(command, options, group);
}

void add_computation_options(CLI::App& command, Loops_options& options) {
  const char group[] = "How to compute";
  command
      .add_option("--backend", options.backend,
                  "auto, host, cuda or reference; default: auto, a CUDA device if there is one")
      ->option_text("NAME")
      ->check(CLI::IsMember(names_of_backends()))
      ->group(group);
  add_threads_option(command, options, group);
  command
      .add_option("--seed", options.seed,
                  "vertex to grow from, from 0 as in the file; default: the first")
      ->option_text("VERTEX")
      ->group(group);
  command
      .add_option("--basis", options.basis,
                  "pure (handles bound inside and tunnels outside; the default) or\n"
                  "shortest (whatever side they bound on: for cutting and parametrization)")
      ->option_text("KIND")
      ->check(CLI::IsMember({"pure", "shortest"}))
      ->group(group);
  command
      .add_flag("--waists", options.do_find_waists,
                "for each boundary curve a short loop of its class, too: the waist of a sleeve")
      ->group(group);
  command
      .add_flag("--no-refine", options.do_not_refine, "keep the handles of the first pass: faster")
      ->group(group);
  command
      .add_flag("--no-tighten", options.do_not_tighten,
                "do not shorten the loops, nor look for shorter ones: faster")
      ->group(group);
  command
      .add_option("--classify", options.classifier,
                  "what tells handles from tunnels: linking (numbers, exact; the default)\n"
                  "or offset (change of length: faster, but no loop is made to bound)")
      ->option_text("HOW")
      ->check(CLI::IsMember({"linking", "offset"}))
      ->group(group);
}

void add_display_options(CLI::App& command, Loops_options& options) {
  const char group[] = "What to show";
  add_listing_options(command, options.listing, group);
  command.add_flag("--all", options.show_all, "all rows of a long table")->group(group);
  command.add_flag("-q,--quiet", options.is_quiet, "nothing but errors")->group(group);
  command.add_option("--color", options.colour, "auto, always or never; default: auto")
      ->option_text("WHEN")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->group(group);
}

constexpr char description[] =
    "Finds the handle and tunnel loops of a triangle mesh, closed or with boundary.\n"
    "\n"
    "A surface of genus g has g pairs of them: a handle loop, which bounds in the solid inside "
    "the\n"
    "surface, and a tunnel loop, which bounds in the space outside and crosses the handle loop "
    "once.\n"
    "With --basis shortest loops are short instead, whatever side they bound on, and those of a\n"
    "pair cross an odd number of times.\n"
    "They are checked to be a basis of H1(S; Z) before they are written; on a surface with "
    "boundary,\n"
    "together with all boundary curves but one of each component.\n";

constexpr char examples[] =
    "Examples:\n"
    "  htloops loops cup.off                           a table of the loops\n"
    "  htloops loops cup.off -o cup.json --lines cup.ply\n"
    "                                                  the loops for a program and for a viewer\n"
    "  htloops loops cup.off --html cup.html --shorter-than 3%\n"
    "                                                  a look at the small ones in a browser\n"
    "  htloops loops cup.off -qo - | jq '.pairs | length'\n"
    "                                                  JSON into a pipe\n"
    "  htloops loops soup.obj --triangulate --repair --write-mesh sound.obj\n"
    "                                                  a mesh that is not fit as it is\n";

} // namespace

void add_loops_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Loops_options>();
  CLI::App* loops = app.add_subcommand("loops", description)->group("Commands");
  add_mesh_argument(*loops, *options, mesh_kinds);
  add_output_options(*loops, *options);
  add_remedy_options(*loops, *options);
  add_computation_options(*loops, *options);
  add_display_options(*loops, *options);
  complete_help(*loops, examples);
  loops->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
