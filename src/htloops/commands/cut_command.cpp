// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/draw/lines.h"
#include "app/draw/meshes.h"
#include "app/draw/scenes.h"
#include "app/mend/mesh_reader.h"
#include "app/solve/cut_solver.h"
#include "app/words.h"
#include "app/write/dual_formats.h"
#include "app/write/files.h"
#include "app/write/mesh_writer.h"
#include "app/write/seam_script.h"
#include "app/write/tables.h"
#include "commands/command.h"
#include "commands/options.h"
#include "terminal/terminal.h"

#include <cstdio>
#include <memory>

namespace htloops {
namespace {

struct Cut_command_options : Common_options
{
  std::string opened_file;
  std::string selection_file;
  std::string dual_file;
  std::string seams_file;
  std::vector<std::uint32_t> cones;
  bool do_cut_spheres = false;

  /// whether the faces of the file matter as they are.
  bool is_for_seams() const { return !seams_file.empty(); }

  /// whether there is a cut to disks, and not only dual cuts.
  bool is_to_disks() const {
    return dual_file.empty() || !opened_file.empty() || !selection_file.empty() || is_for_seams() ||
           !cones.empty() || do_cut_spheres;
  }
};

void check_options(const Cut_command_options& options) {
  check_opened_mesh_format(options.opened_file);
  check_suffix(options.selection_file, ".selection.txt");
  check_dual_format(options.dual_file);
  check_suffix(options.seams_file, ".py");
  if(options.is_for_seams() && (options.remedies.do_repair || options.remedies.weld))
    throw wrong_usage("--seams refers to the vertices and faces of the file as they are: "
                      "repair it first with 'htloops repair'");
  check_common_options(options);
}

Mended_mesh read(const Cut_command_options& options) {
  Mesh_options reading = options;
  if(options.is_for_seams()) {
    reading.remedies.do_triangulate = true;
    reading.is_quiet = options.is_quiet || !options.remedies.any();
  }
  return read_mended_mesh(reading);
}

Cut_answer solve(const Mended_mesh& mended, const Cut_command_options& options) {
  const Mesh& mesh = mended.mesh;
  Cut_options cut;
  for(const std::uint32_t v : options.cones)
    cut.cones.push_back(vertex_of_mesh(mesh, v));
  cut.do_cut_spheres = options.do_cut_spheres || options.is_for_seams();
  if(options.is_for_seams())
    cut.avoided = mended.cuts;
  cut.number_of_threads = options.number_of_threads;
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  return find_cut(mesh, cut, bar);
}

void write_lines(const Cut_command_options& options, const Exported_lines& lines) {
  for(const std::string& file : options.lines_files)
    export_lines(file, lines);
}

void write_files(const Cut_command_options& options,
                 const Mended_mesh& mended,
                 const Cut_answer& answer,
                 const std::string& words) {
  const Mesh& mesh = mended.mesh;
  if(!options.opened_file.empty()) {
    write_mesh(options.opened_file, opened_mesh(mesh, answer.edges), mended.facts);
    show_note_on_unit(options, options.opened_file, mended.facts);
  }
  if(!options.selection_file.empty())
    export_selection(options.selection_file, mesh, answer.edges);
  if(options.lines_files.empty() && !is_looked_at(options))
    return;
  const Exported_lines lines = lines_of(mesh, answer.edges);
  write_lines(options, lines);
  if(is_looked_at(options))
    show_scene(options, scene_of_cut(view_of(options), options.mesh_file, mesh, lines, words),
               mended.facts.unit);
}

std::string words_of_cut(const Cut_answer& answer) {
  const std::string cut = answer.edges.empty()
                              ? "nothing to cut"
                              : "cut along " + counted(answer.edges.size(), "edge", "edges") +
                                    formatted(" of total length %.6g, boundary of %.6g",
                                              answer.length, answer.boundary_length);
  return "genus " + std::to_string(answer.genus) + ": " + cut + "\n";
}

// To disks; says how.
std::string cut_to_disks(const Cut_command_options& options, const Mended_mesh& mended) {
  const Cut_answer answer = solve(mended, options);
  const std::string words = words_of_cut(answer);
  if(!options.seams_file.empty())
    write_seam_script(options.seams_file, options.mesh_file, mended.mesh, answer.edges);
  write_files(options, mended, answer, words);
  return words;
}

std::string words_of_dual_cuts(const Mesh& mesh, const Dual_cuts& duals) {
  const std::string cuts = duals.cuts.empty()
                               ? "no dual cuts"
                               : counted(duals.cuts.size(), "dual cut", "dual cuts") +
                                     formatted(" of total length %.6g", length_of(mesh, duals));
  return "genus " + std::to_string(duals.statistics.genus) + ": " + cuts + "\n";
}

// Writes the dual cuts; says how many there are.
std::string cut_across_loops(const Cut_command_options& options, const Mended_mesh& mended) {
  const Mesh& mesh = mended.mesh;
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  const Dual_cuts duals = find_dual_cuts(mesh, options.number_of_threads, bar);
  write_dual_cuts(options.dual_file, mesh, duals);
  const std::string words = words_of_dual_cuts(mesh, duals);
  if(options.is_to_disks())
    return words;
  const Exported_lines lines = lines_of(mesh, duals);
  write_lines(options, lines);
  if(is_looked_at(options))
    show_scene(options, scene_of_dual_cuts(view_of(options), options.mesh_file, mesh, lines, words),
               mended.facts.unit);
  return words;
}

// With the time that has passed, at the end of the first line.
std::string with_time(std::string words, double all_seconds, double read_seconds, int threads) {
  const std::string time =
      formatted("; %.2f s after %.2f s of reading, ", all_seconds - read_seconds, read_seconds) +
      counted(static_cast<std::size_t>(threads), "thread", "threads");
  return words.insert(words.find('\n'), time);
}

void run(const Cut_command_options& options) {
  check_options(options);
  const Stopwatch stopwatch;
  const Mended_mesh mended = read(options);
  const double read_seconds = stopwatch.seconds();
  write_read_mesh(options, mended);
  std::string words;
  if(options.is_to_disks())
    words += cut_to_disks(options, mended);
  if(!options.dual_file.empty())
    words += cut_across_loops(options, mended);
  if(!options.is_quiet)
    show_text(with_time(words, stopwatch.seconds(), read_seconds,
                        Thread_limit(options.number_of_threads).number_of_threads()) +
                  words_of_unit(mended.facts.unit),
              options.opened_file == "-" || options.selection_file == "-" ||
                  options.dual_file == "-" || options.page_file == "-" ||
                  options.is_mesh_on_standard_output());
}

void add_output_options(CLI::App& command, Cut_command_options& options) {
  command.option_defaults()->group("What to write");
  add_output(command, "-o,--output", "FILE", options.opened_file,
             "the opened mesh, with separate vertices for the two sides: .off .obj .ply");
  add_output(command, "--selection", "FILE.selection.txt", options.selection_file,
             "the cut edges, as a CGAL selection file");
  add_output(command, "--seams", "FILE.py", options.seams_file,
             "a Python script for Blender that marks the cut edges as seams. With --seams,\n"
             "quadrilaterals and polygons stay whole, and spheres are also cut");
  add_output(command, "--dual", "FILE", options.dual_file,
             "dual cuts: for each handle loop, tunnel loop and boundary curve (except one of\n"
             "each component), a cut that crosses it once and no other: as .json, or as lines\n"
             "with the mesh: .msh .msh2 .vtu .vtp. Alone, it is also what --lines, --picture and\n"
             "--html show");
  add_lines_option(command, options, "the cut edges");
  add_picture_options(command, options, "the cut");
  add_page_option(command, options, "the mesh and the cut");
  add_view_options(command, options);
}

void add_computation_options(CLI::App& command, Cut_command_options& options) {
  command.option_defaults()->group("How to compute");
  command
      .add_option("--through", options.cones,
                  "vertices that the cut must pass through: cones of a parametrization")
      ->option_text("VERTEX,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_flag("--cut-spheres", options.do_cut_spheres, "also cut components of genus 0");
  add_threads_option(command, options);
}

constexpr char cut_description[] = R"(Cuts a triangle mesh open, along short arcs of its edges.

Each component of positive genus, or with several boundary curves, becomes one disk, as needed
for a parametrization.
)";

constexpr char cut_examples[] = R"(Examples:
  htloops cut part.off -o open.obj                the opened mesh
  htloops cut part.off --selection part.selection.txt
                                                  for CGAL::Seam_mesh and CGAL's demos
  htloops cut chair.obj --seams seams.py          a script for Blender (blender -P seams.py)
  htloops cut part.off --through 17,4 --picture cut.png
                                                  cut through two vertices, with a picture
  htloops cut plate.off --dual cuts.msh           dual cuts of a plate with holes
)";

} // namespace

void add_cut_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Cut_command_options>();
  CLI::App* cut = app.add_subcommand("cut", cut_description)->group("Commands");
  add_mesh_argument(*cut, *options, mesh_kinds());
  add_output_options(*cut, *options);
  add_remedy_options(*cut, *options);
  add_computation_options(*cut, *options);
  cut->add_flag("-q,--quiet", options->is_quiet, "print only errors")->group("What to show");
  complete_help(*cut, cut_examples);
  cut->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
