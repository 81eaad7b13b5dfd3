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
#include "app/draw/skeletons.h"
#include "app/failure.h"
#include "app/file_names.h"
#include "app/solve/skeleton_solver.h"
#include "app/words.h"
#include "app/write/documents.h"
#include "app/write/skeleton_formats.h"
#include "app/write/tables.h"
#include "commands/command.h"
#include "commands/options.h"
#include "terminal/terminal.h"

#include <boost/algorithm/string/predicate.hpp>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace htloops {
namespace {

struct Skeleton_command_options : Common_options
{
  std::vector<std::string> graph_files;
  std::string parts_file;
  std::string csv_file;
  bool show_all = false;
  Skeleton_options skeleton;
};

void check_options(const Skeleton_command_options& options) {
  for(const std::string& file : options.graph_files)
    check_skeleton_graph_format(file);
  check_suffix(options.parts_file, ".ply");
  check_common_options(options, check_skeleton_lines_format);
  check_name(options.csv_file, "a table as CSV", {".csv"});
}

Skeleton_answer solve(const Mesh& mesh, const Skeleton_command_options& options) {
  Skeleton_options how = options.skeleton;
  how.number_of_threads = options.number_of_threads;
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  return find_skeleton(mesh, how, bar);
}

void export_model(const Skeleton_command_options& options,
                  const Mesh& mesh,
                  const Skeleton_answer& answer) {
  const auto [cut, tints] = skeleton_surface(mesh, answer);
  Drawn_surface surface =
      drawn_surface(cut, [&colours = tints](std::size_t part) { return colours[part]; });
  surface.opacity = opacity_around_bones;
  export_gltf(options.gltf_file, surface, bones_of(answer, options.picture.has_tubes));
}

void write_files(const Skeleton_command_options& options,
                 const Mended_mesh& mended,
                 const Skeleton_answer& answer,
                 double read_seconds) {
  const Mesh& mesh = mended.mesh;
  if(!options.csv_file.empty())
    write_arc_csv(options.csv_file, answer);
  if(!options.json_file.empty())
    write_skeleton_json(options.json_file, answer,
                        {options.mesh_file,
                         {{"shortest_limb", options.skeleton.shortest_limb},
                          {"triangulate", options.remedies.do_triangulate},
                          {"repair", options.remedies.do_repair}},
                         read_seconds});
  for(const std::string& file : options.lines_files)
    export_skeleton_lines(file, answer);
  for(const std::string& file : options.graph_files)
    write_skeleton_graph(file, answer);
  if(!options.parts_file.empty())
    export_coloured_mesh(options.parts_file, mesh, answer);
  if(!options.gltf_file.empty())
    export_model(options, mesh, answer);
  if(is_looked_at(options))
    show_scene(options,
               scene_of_skeleton(view_of(options), options.mesh_file, mesh, answer,
                                 summary(answer, read_seconds)),
               mended.facts.unit);
}

bool is_output_taken(const Skeleton_command_options& options) {
  return options.json_file == "-" || options.csv_file == "-" || options.page_file == "-" ||
         options.is_mesh_on_standard_output();
}

void run(const Skeleton_command_options& options) {
  check_options(options);
  const Stopwatch stopwatch;
  const Mended_mesh mended = read_mended_mesh(options);
  const double read_seconds = stopwatch.seconds();
  Skeleton_answer answer = solve(mended.mesh, options);
  write_read_mesh(options, mended);
  write_files(options, mended, answer, read_seconds);
  answer.total_seconds = stopwatch.seconds() - read_seconds; // with what was written
  if(!options.is_quiet)
    show_text(table_of_arcs(answer, options.show_all) + summary(answer, read_seconds) +
                  words_of_unit(mended.facts.unit),
              is_output_taken(options));
  if(!answer.certificate() && answer.does_mesh_touch_itself && options.is_quiet)
    std::fprintf(stderr, "htloops: note: the skeleton of %s is not certified:%s\n",
                 printable(options.mesh_file).c_str(),
                 indented(lines_of(answer.certificate().failure)).c_str());
  if(!answer.certificate() && !answer.does_mesh_touch_itself)
    throw Failure(
        Exit_code::NOT_CERTIFIED,
        "the skeleton of " + printable(options.mesh_file) + " fails its certificate" +
            (options.is_quiet ? ":" + indented(lines_of(answer.certificate().failure)) : ""));
}

// One format by its name, besides the option that takes all of them and is declared before.
void add_named_format(CLI::App& command,
                      const std::string& format,
                      std::vector<std::string>& files,
                      const std::string& what) {
  const std::string ending = "." + format;
  const auto add = [&files](const std::string& file) { files.push_back(file); };
  const auto why_not = [ending](const std::string& file) {
    return boost::algorithm::iends_with(file, ending) ? "" : "the name must end in " + ending;
  };
  command.add_option_function<std::string>("--" + format, add, what)
      ->option_text("FILE" + ending)
      ->type_name(output_file)
      ->check(why_not);
}

void add_output_options(CLI::App& command, Skeleton_command_options& options) {
  command.option_defaults()->group("What to write");
  add_json_option(command, options, "the skeleton");
  add_lines_option(command, options, "the arcs", ".swc .vtp .binary.vtp .obj .ply .polylines.txt");
  for(const char* format : {"swc", "vtp"})
    add_named_format(command, format, options.lines_files, "same as --lines with this ending");
  add_output(command, "--graph", "FILE", options.graph_files,
             "the points and edges as a graph: .graphml .dot; repeatable");
  add_named_format(command, "graphml", options.graph_files, "same as --graph with this ending");
  add_output(command, "--parts", "FILE.ply", options.parts_file,
             "the mesh with vertices colored by arc");
  add_output(command, "--csv", "FILE.csv", options.csv_file, "a table with a row for each arc");
  add_picture_options(command, options, "the skeleton",
                      formatted("%g", opacity_around_bones_in_pictures));
  add_page_option(command, options, "the mesh and the skeleton");
  add_gltf_option(command, options, "the arcs");
  command.add_flag("--tubes", options.picture.has_tubes,
                   "draw arcs as thick as the solid, in the picture and the glTF model");
  add_view_options(command, options);
}

void add_computation_options(CLI::App& command, Skeleton_command_options& options) {
  command.option_defaults()->group("How to compute");
  command
      .add_option("--shortest-limb", options.skeleton.shortest_limb,
                  "leave out limbs that are shorter than K times the radius at their base;\n"
                  "cycles are always kept; default: 1.2")
      ->option_text("K")
      ->check(why_negative);
  add_threads_option(command, options);
}

constexpr char skeleton_description[] = R"(Computes a curve skeleton of a triangle mesh.

Its arcs run in the middle of the solid inside the surface. Each point has the radius of the
largest ball inside. A connected surface of genus g has a connected skeleton with g independent
cycles; cavities add theirs. Boundary curves are inlets, each with an end of the skeleton at
its middle.
Exact arithmetic certifies that all edges lie strictly inside, that no two of them cross, and
that the cycles are a basis of H1 of the solid. If the mesh crosses itself, the skeleton is
written uncertified, with the reason.
)";

constexpr char skeleton_examples[] = R"(Examples:
  htloops skeleton chair.off --picture chair.png --legend
                                                  a picture with a key
  htloops skeleton vessel.stl --lines vessel.vtp  centerlines with radii for ParaView
  htloops skeleton neuron.ply --lines neuron.swc  the same as trees, with each cycle cut
  htloops skeleton chair.off -o chair.json && htloops check chair.off chair.json
                                                  check again from the two files alone
)";

} // namespace

void add_skeleton_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Skeleton_command_options>();
  CLI::App* skeleton = app.add_subcommand("skeleton", skeleton_description)->group("Commands");
  add_mesh_argument(*skeleton, *options, mesh_kinds());
  add_output_options(*skeleton, *options);
  add_remedy_options(*skeleton, *options);
  add_computation_options(*skeleton, *options);
  skeleton->option_defaults()->group("What to show");
  skeleton->add_flag("--all-rows", options->show_all, "show all rows of a long table");
  skeleton->add_flag("-q,--quiet", options->is_quiet,
                     "print only errors, and that a skeleton is not certified");
  complete_help(*skeleton, skeleton_examples);
  skeleton->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
