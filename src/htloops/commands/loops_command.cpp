// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/draw/gltf.h"
#include "app/draw/layers.h"
#include "app/draw/lines.h"
#include "app/draw/pages.h"
#include "app/draw/pictures.h"
#include "app/draw/scenes.h"
#include "app/failure.h"
#include "app/interrupt.h"
#include "app/read/mesh_list.h"
#include "app/words.h"
#include "app/write/channel_formats.h"
#include "app/write/documents.h"
#include "app/write/tables.h"
#include "app/write/throat_tables.h"
#include "commands/command.h"
#include "commands/loops_options.h"
#include "terminal/terminal.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace htloops {
namespace {

// How many pairs are not in the listing.
std::string words_of_left_out(const Mesh_line& line) {
  const std::size_t number = line.answer.pairs.size() - line.listing.size();
  return number == 0 ? ""
                     : counted(number, "pair is", "pairs are") + " left out by your selection\n";
}

// Without colours.
std::string summary_of(const Loops_options& options, const Mesh_line& line) {
  return summary(line.answer, line.read_seconds, {options.show_all, false, options.is_verbose});
}

// Whether 'htloops remove', which finds the pairs anew, finds these, with the same numbers.
bool has_usual_numbers(const Loops_options& options) {
  return !options.seed && options.basis == "pure" && options.classifier == "linking" &&
         !options.is_literal && !options.do_not_refine && !options.do_not_tighten &&
         !options.do_not_coarsen && options.search_effort == 1. && !options.time_budget &&
         (options.backend == "auto" || options.backend == "host");
}

// Whether there is a file that 'htloops remove' can be given.
bool keeps_numbers(const Loops_options& options) {
  return !options.json_file.empty() && options.json_file != "-";
}

// What tells 'htloops remove' which pairs are meant, before their numbers.
std::string choice_of_pairs(const Loops_options& options) {
  if(keeps_numbers(options))
    return "--loops " + quoted(options.json_file) + " --pairs";
  return has_usual_numbers(options) ? "--pairs" : "--loops LOOPS.json --pairs";
}

std::string remark_on_numbers(const Loops_options& options) {
  return has_usual_numbers(options) || keeps_numbers(options)
             ? ""
             : "The numbers of the pairs are valid for this call with its options: save them with "
               "-o LOOPS.json for 'htloops remove'.\n";
}

htl_scene::Scene scene_of(const Loops_options& options, const Mesh& mesh, const Mesh_line& line) {
  return scene_of_loops(view_of(options), options.mesh_file, mesh, line.answer, line.listing,
                        words_of_left_out(line) + summary_of(options, line) +
                            remark_on_numbers(options),
                        command_to_remove(options, choice_of_pairs(options)));
}

// The layers at a moment; on a page the loops.
void show_layers(const Loops_options& options, const Mesh& mesh, const Mesh_line& line) {
  const Grown_layers grown = grown_layers(mesh, line.answer, *options.moment);
  if(!options.picture.file.empty())
    export_picture(options.picture, scene_of_layers(view_of(options), options.mesh_file, grown));
  if(!options.gltf_file.empty())
    export_gltf(options.gltf_file, grown.surface, grown.fronts);
  if(!options.page_file.empty())
    write_page(options.page_file, scene_of(options, mesh, line));
}

void show_loops(const Loops_options& options, const Mesh& mesh, const Mesh_line& line) {
  if(!options.gltf_file.empty())
    export_gltf(options.gltf_file, drawn_surface(mesh), lines_of(line.answer, line.listing));
  if(is_looked_at(options))
    show_scene(options, scene_of(options, mesh, line));
}

void write_files(const Loops_options& options, const Mended_mesh& mended, const Mesh_line& line) {
  const Mesh& mesh = mended.mesh;
  const Answer& answer = line.answer;
  if(!options.json_file.empty())
    write_loops_json(options.json_file, mesh, answer,
                     {options.mesh_file, json_of(options), line.read_seconds, mended.cuts});
  if(!options.events_file.empty())
    write_events(options.events_file, answer);
  for(const std::string& file : options.lines_files)
    export_lines(file, lines_of(answer, line.listing));
  if(!options.channels_file.empty())
    write_channels(options.channels_file, find_channels(mesh, answer.measures));
  if(!options.layers_file.empty())
    export_layers(options.layers_file, mesh, answer.vertex_layers);
  (options.moment ? show_layers : show_loops)(options, mesh, line);
}

bool is_output_taken(const Loops_options& options) {
  return options.json_file == "-" || options.csv_file == "-" || options.jsonl_file == "-" ||
         options.page_file == "-" || options.is_mesh_on_standard_output();
}

void show(const Loops_options& options, const Mesh_line& line) {
  const Answer& answer = line.answer;
  if(answer.statistics.has_device_failed)
    std::fprintf(stderr, "htloops: the CUDA device failed, so the host continued: %s\n",
                 answer.statistics.fallback.c_str());
  if(options.is_quiet)
    return;
  std::FILE* stream = is_output_taken(options) ? stderr : stdout;
  const Table_options table{options.show_all, use_colour(options.colour, stream)};
  show_text(table_of_pairs(line.listing, table) + words_of_left_out(line) +
                table_of_boundaries(answer.boundaries, options.show_all) +
                table_of_throats(answer.throats, options.show_all) + summary_of(options, line),
            is_output_taken(options));
}

// Whatever happens to the mesh, there is a line about it where lines are asked for.
void run_on_one_mesh(const Loops_options& options) {
  const Stopwatch stopwatch;
  Line_files lines(options.csv_file, options.jsonl_file, options.kind_of_rows());
  Mesh_line line = line_of(options.mesh_file, [&] {
    auto solved = read_and_solve(options, !options.is_quiet && is_terminal(stderr));
    write_files(options, solved.first, solved.second);
    return std::move(solved.second);
  });
  throw_if_interrupted(); // then there is no answer about the mesh
  lines.add(line);
  if(line.exit_code != 0)
    throw Failure(static_cast<Exit_code>(line.exit_code), line.error);
  line.answer.total_seconds = stopwatch.seconds() - line.read_seconds; // with what was written
  show(options, line);
}

void run(Loops_options& options) {
  options.is_batch = options.do_resume || may_be_many(options.mesh_files);
  options.mesh_files = files_of(options.mesh_files);
  options.mesh_file = options.mesh_files.front();
  check_loops_options(options);
  if(options.is_batch)
    run_on_many_meshes(options);
  else
    run_on_one_mesh(options);
}

constexpr char loops_description[] =
    R"(Finds the handle and tunnel loops of a triangle mesh, closed or with boundary.

A surface of genus g has g pairs of loops: a handle loop, which bounds in the solid inside the
surface, and a tunnel loop, which bounds in the space outside and crosses the handle loop once.
With --basis shortest, loops are as short as possible, but need not bound on either side; the
loops of a pair then cross an odd number of times.
Before loops are written, they are certified to be a basis of H1(S; Z). On a surface with
boundary, the basis includes all boundary curves except one per component.
)";

constexpr char loops_examples[] = R"(Examples:
  htloops loops cup.off                           a table of the loops
  htloops loops cup.off -o cup.json --lines cup.ply
                                                  loops for a program and for a viewer
  htloops loops cup.off --html cup.html --shorter-than 3%
                                                  view the short loops in a browser
  htloops loops cup.off -qo - | jq '.pairs | length'
                                                  send JSON to a pipe
  htloops loops cup.off --throats --csv -         all throats, a row for each
  htloops loops scans --csv scans.csv --jobs 4    a table of all meshes in a folder, failures
                                                  included
  htloops loops scans --csv scans.csv --resume    the remaining meshes, after Ctrl-C
  cat cup.off | htloops loops - --format off      a mesh from a pipe
  htloops loops soup.obj --triangulate --repair --write-mesh sound.obj
                                                  repair a mesh that is not acceptable as it is
)";

constexpr char measure_description[] =
    R"(Measures the handles of a triangle mesh: thickness of handles, clear width of holes.

The thickness of a handle is the diameter of the largest ball that can move around it within
the material. The clear width of its hole is the diameter of the largest ball outside that can
move through it. Both depend on the shape alone, and both include an error bound.
)";

constexpr char measure_examples[] = R"(Examples:
  htloops measure casting.stl                     a table, the smallest measure first
  htloops measure 'scans/*.stl' --csv all.csv     a row for each handle of many meshes
  htloops measure scan.ply --noise-below 1%       handles that are thinner, or holes that are
                                                  narrower
  htloops measure foam.off --html foam.html       view the balls in a browser
)";

} // namespace

void add_measure_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Loops_options>();
  CLI::App* measure = app.add_subcommand("measure", measure_description)->group("Commands");
  add_measure_options(*measure, *options);
  complete_help(*measure, measure_examples);
  measure->callback([options, &command] { command = [options] { run(*options); }; });
}

void add_loops_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Loops_options>();
  CLI::App* loops = app.add_subcommand("loops", loops_description)->group("Commands");
  add_loops_options(*loops, *options);
  complete_help(*loops, loops_examples);
  loops->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
