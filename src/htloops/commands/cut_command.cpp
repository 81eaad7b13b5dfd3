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
#include "app/solve/cut_solver.h"
#include "app/words.h"
#include "app/write/dual_formats.h"
#include "app/write/files.h"
#include "app/write/mesh_writer.h"
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
  std::vector<std::uint32_t> cones;
  bool do_cut_spheres = false;
};

void check_options(const Cut_command_options& options) {
  check_opened_mesh_format(options.opened_file);
  check_suffix(options.selection_file, ".selection.txt");
  check_dual_format(options.dual_file);
  check_common_options(options);
}

Cut_answer solve(const Mesh& mesh, const Cut_command_options& options) {
  Cut_options cut;
  for(const std::uint32_t v : options.cones)
    cut.cones.push_back(vertex_of_mesh(mesh, v));
  cut.do_cut_spheres = options.do_cut_spheres;
  cut.number_of_threads = options.number_of_threads;
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  return find_cut(mesh, cut, bar);
}

void write_files(const Cut_command_options& options, const Mesh& mesh, const Cut_answer& answer) {
  if(!options.opened_file.empty())
    write_mesh(options.opened_file, opened_mesh(mesh, answer.edges));
  if(!options.selection_file.empty())
    export_selection(options.selection_file, mesh, answer.edges);
  if(!options.lines_files.empty() || !options.picture.file.empty()) {
    const Exported_lines lines = lines_of(mesh, answer.edges);
    for(const std::string& file : options.lines_files)
      export_lines(file, lines);
    if(!options.picture.file.empty())
      export_picture(options.picture, options.view, drawn_surface(mesh), lines);
  }
}

std::string words_of_cut(const Cut_answer& answer, double read_seconds) {
  return "genus " + std::to_string(answer.genus) + ": cut along " +
         counted(answer.edges.size(), "edge", "edges") +
         formatted(" of length %.6g, boundary of %.6g; %.2f s after %.2f s of reading, ",
                   answer.length, answer.boundary_length, answer.total_seconds, read_seconds) +
         counted(static_cast<std::size_t>(answer.number_of_threads), "thread", "threads") + "\n";
}

void run(const Cut_command_options& options) {
  check_options(options);
  const Stopwatch stopwatch;
  const Mended_mesh mended = read_mended_mesh(options);
  const Mesh& mesh = mended.mesh;
  const double read_seconds = stopwatch.seconds();
  write_read_mesh(options, mended);
  const Cut_answer answer = solve(mesh, options);
  write_files(options, mesh, answer);
  if(!options.dual_file.empty()) {
    Progress_bar bar(!options.is_quiet && is_terminal(stderr));
    write_dual_cuts(options.dual_file, mesh, find_dual_cuts(mesh, options.number_of_threads, bar));
  }
  if(!options.is_quiet)
    show_text(words_of_cut(answer, read_seconds) + words_of_unit(mended.facts.unit),
              options.opened_file == "-" || options.selection_file == "-" ||
                  options.is_mesh_on_standard_output());
}

void add_output_options(CLI::App& command, Cut_command_options& options) {
  command.option_defaults()->group("What to write");
  add_output(command, "-o,--output", "FILE", options.opened_file,
             "the opened mesh, with a vertex for each side: .off .obj .ply");
  add_output(command, "--selection", "FILE.selection.txt", options.selection_file,
             "the edges, as a selection of CGAL");
  add_output(command, "--dual", "FILE", options.dual_file,
             "for each handle and tunnel loop, and all boundary curves but one of each\n"
             "component, a cut that crosses it once and no other: as .json, or as lines with\n"
             "the mesh, .msh .msh2 .vtu .vtp");
  add_lines_option(command, options, "the edges");
  add_picture_options(command, options, "the cut", false);
  add_view_options(command, options);
}

void add_computation_options(CLI::App& command, Cut_command_options& options) {
  command.option_defaults()->group("How to compute");
  command
      .add_option("--through", options.cones,
                  "vertices that the cut has to pass: the cones of a parametrization")
      ->option_text("VERTEX,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_flag("--cut-spheres", options.do_cut_spheres, "cut components of genus 0, too");
  add_threads_option(command, options);
}

constexpr char cut_description[] = R"(Cuts a triangle mesh open, along short arcs of its edges.

Each component of positive genus, or with several boundary curves, becomes one disk, as
parametrizations ask for.
)";

constexpr char cut_examples[] = R"(Examples:
  htloops cut part.off -o open.obj                the opened mesh
  htloops cut part.off --selection part.selection.txt
                                                  for CGAL::Seam_mesh, and for CGAL's programs
  htloops cut part.off --through 17,4 --picture cut.png
                                                  through two vertices, and a look at it
  htloops cut plate.off --dual cuts.msh           jumps of potentials on a plate with holes
)";

} // namespace

void add_cut_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Cut_command_options>();
  CLI::App* cut = app.add_subcommand("cut", cut_description)->group("Commands");
  add_mesh_argument(*cut, *options, mesh_kinds());
  add_output_options(*cut, *options);
  add_remedy_options(*cut, *options);
  add_computation_options(*cut, *options);
  cut->add_flag("-q,--quiet", options->is_quiet, "nothing but errors")->group("What to show");
  complete_help(*cut, cut_examples);
  cut->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
