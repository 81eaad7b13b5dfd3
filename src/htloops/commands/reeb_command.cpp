// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/draw/gltf.h"
#include "app/draw/lines.h"
#include "app/draw/meshes.h"
#include "app/draw/scenes.h"
#include "app/draw/skeletons.h"
#include "app/draw/surfaces.h"
#include "app/draw/tints.h"
#include "app/failure.h"
#include "app/read/vertex_data.h"
#include "app/solve/backends.h"
#include "app/solve/reeb_solver.h"
#include "app/words.h"
#include "app/write/documents.h"
#include "app/write/files.h"
#include "app/write/tables.h"
#include "commands/command.h"
#include "commands/options.h"
#include "terminal/terminal.h"

#include <cstdio>
#include <map>
#include <memory>

namespace htloops {
namespace {

struct Reeb_command_options : Common_options
{
  std::vector<std::string> graph_files;
  std::string parts_file;
  std::string csv_file;
  bool show_all = false;
  std::string drawing;
  std::vector<std::uint32_t> seeds;
  std::vector<double> height;
  std::string values_file;
  std::string measure;
  std::optional<double> threshold;
  std::optional<double> shortest_arc;
  bool is_capped = false;
  std::string backend = "auto";
};

// Where lines are looked at they are worth the time.
bool is_drawn_inside(const Reeb_command_options& options) {
  const bool is_drawn =
      is_looked_at(options) || !options.gltf_file.empty() || !options.lines_files.empty();
  return options.drawing.empty() ? is_drawn : options.drawing == "inside";
}

// Parts are to be ones that one would name.
double shortest_arc_of(const Reeb_command_options& options) {
  constexpr double as_long_as_thick = 2.;
  return options.shortest_arc.value_or(options.parts_file.empty() ? 0. : as_long_as_thick);
}

void check_options(const Reeb_command_options& options) {
  if(!options.height.empty() && is_zero(options.height))
    throw wrong_usage("--height 0,0,0 is not a direction");
  for(const std::string& file : options.graph_files)
    check_graph_format(file);
  check_suffix(options.parts_file, ".ply");
  check_common_options(options);
  choose_backend(options.backend);
  if(options.picture.has_tubes && !is_drawn_inside(options))
    throw wrong_usage(
        "--tubes needs a picture or a model of the graph inside the surface: --picture or "
        "--gltf, with --drawing inside");
  check_name(options.csv_file, "a table as CSV", {".csv"});
}

std::vector<Mesh::Vertex_index> sources_of(const Reeb_command_options& options, const Mesh& mesh) {
  std::vector<Mesh::Vertex_index> sources;
  for(const std::uint32_t seed : options.seeds)
    sources.push_back(vertex_of_mesh(mesh, seed));
  return sources;
}

// Those of the file are for the vertices of the file; a copy of one of these has its value.
std::vector<double> read_values_of(const std::string& file, const Mended_mesh& mended) {
  std::vector<double> values =
      read_values(file, mended.mesh.number_of_vertices() - mended.origins.size());
  for(const std::uint32_t origin : mended.origins)
    values.push_back(double(values[origin]));
  return values;
}

std::vector<double> values_of(const Reeb_command_options& options, const Mended_mesh& mended) {
  if(!options.values_file.empty())
    return read_values_of(options.values_file, mended);
  const Mesh& mesh = mended.mesh;
  std::vector<double> values;
  if(!options.height.empty())
    for(const Point& p : mesh.points())
      values.push_back(options.height[0] * p.x() + options.height[1] * p.y() +
                       options.height[2] * p.z());
  return values;
}

Reeb_answer solve(const Mended_mesh& mended, const Reeb_command_options& options) {
  Reeb_options reeb;
  reeb.sources = sources_of(options, mended.mesh);
  reeb.values = values_of(options, mended);
  if(!options.measure.empty())
    reeb.measure = reeb_measures().at(options.measure);
  reeb.threshold = options.threshold.value_or(reeb.threshold);
  reeb.shortest_arc = shortest_arc_of(options);
  reeb.allow_parallel_arcs = reeb.shortest_arc > 0.;
  reeb.capped = options.is_capped;
  reeb.do_draw_inside = is_drawn_inside(options);
  reeb.backend = options.backend;
  reeb.number_of_threads = options.number_of_threads;
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  return find_reeb_graph(mended.mesh, reeb, bar);
}

void write_files(const Reeb_command_options& options,
                 const Mended_mesh& mended,
                 const Reeb_answer& answer,
                 const std::vector<Listed_arc>& arcs,
                 const std::string& text,
                 double read_seconds) {
  const Mesh& mesh = mended.mesh;
  if(!options.csv_file.empty())
    write_arc_csv(options.csv_file, arcs);
  if(!options.json_file.empty())
    write_reeb_json(options.json_file, mesh, answer, read_seconds);
  for(const std::string& file : options.lines_files)
    export_lines(file, lines_of(answer));
  for(const std::string& file : options.graph_files)
    export_graph(file, answer);
  if(!options.parts_file.empty())
    export_coloured_mesh(options.parts_file, mesh, answer);
  if(is_looked_at(options))
    show_scene(options,
               scene_of_reeb_graph(view_of(options), options.mesh_file, mesh, answer, arcs, text),
               mended.facts.unit);
  if(!options.gltf_file.empty()) {
    const std::vector<Colour> tints = tints_of(mesh, answer);
    Drawn_surface surface =
        drawn_surface(arc_surface(mesh, answer), [&tints](std::size_t arc) { return tints[arc]; });
    surface.opacity = opacity_around_bones;
    export_gltf(options.gltf_file, surface, bones_of(mesh, answer, options.picture.has_tubes));
  }
}

bool is_output_taken(const Reeb_command_options& options) {
  return options.json_file == "-" || options.csv_file == "-" || options.page_file == "-" ||
         options.is_mesh_on_standard_output();
}

std::string words_of_drawing(const Reeb_answer& answer) {
  if(!answer.embedding)
    return "";
  const std::size_t all = answer.embedding->number_of_segments;
  const std::size_t inside = answer.embedding->number_of_segments_inside;
  return "drawn inside: " + (inside == all
                                 ? counted(all, "segment", "segments") + ", all strictly inside\n"
                             : all == 1 ? "its only segment is not known to lie strictly inside\n"
                                        : std::to_string(inside) + " of " + std::to_string(all) +
                                              " segments are known to lie strictly inside\n");
}

std::string words_of_graph(const Reeb_answer& answer, double read_seconds) {
  std::map<CGAL::Reeb_node_type, std::size_t> count;
  for(const auto v : CGAL::make_range(vertices(answer.graph)))
    ++count[answer.graph[v].type];
  const auto& statistics = answer.statistics;
  const std::string boundaries =
      statistics.number_of_boundaries == 0
          ? ""
          : ", " + counted(statistics.number_of_boundaries, "boundary curve", "boundary curves") +
                (answer.is_capped ? ", capped" : "");
  return "genus " + std::to_string(statistics.genus) + " in " +
         counted(statistics.number_of_components, "component", "components") + boundaries + ": " +
         counted(num_edges(answer.graph), "arc", "arcs") + ", " +
         counted(number_of_cycles(answer), "cycle", "cycles") + ", " +
         counted(count[CGAL::Reeb_node_type::MINIMUM], "minimum", "minima") + ", " +
         counted(count[CGAL::Reeb_node_type::SADDLE], "saddle", "saddles") + ", " +
         counted(count[CGAL::Reeb_node_type::MAXIMUM], "maximum", "maxima") + " (of " +
         counted(statistics.number_of_critical_nodes, "node", "nodes") +
         " before the simplification)\n" + words_of_drawing(answer) +
         formatted("%.2f s after %.2f s of reading, backend %s, ", answer.total_seconds,
                   read_seconds, answer.backend.c_str()) +
         counted(static_cast<std::size_t>(answer.number_of_threads), "thread", "threads") + "\n";
}

void run(const Reeb_command_options& options) {
  check_options(options);
  const Stopwatch stopwatch;
  const Mended_mesh mended = read_mended_mesh(options);
  const Mesh& mesh = mended.mesh;
  const double read_seconds = stopwatch.seconds();
  Reeb_answer answer = solve(mended, options);
  write_read_mesh(options, mended);
  const std::string unit = words_of_unit(mended.facts.unit);
  std::vector<Listed_arc> arcs; // measuring them takes a look at every face
  if(!options.is_quiet || !options.csv_file.empty() || is_looked_at(options))
    arcs = list_arcs(mesh, answer);
  write_files(options, mended, answer, arcs, words_of_graph(answer, read_seconds) + unit,
              read_seconds);
  answer.total_seconds = stopwatch.seconds() - read_seconds; // with what was written
  if(!options.is_quiet)
    show_text(table_of_arcs(arcs, options.show_all) + words_of_graph(answer, read_seconds) + unit,
              is_output_taken(options));
}

void add_output_options(CLI::App& command, Reeb_command_options& options) {
  command.option_defaults()->group("What to write");
  add_json_option(command, options, "the graph");
  add_lines_option(command, options, "the arcs");
  add_output(command, "--graph", "FILE", options.graph_files,
             "the nodes and arcs as a graph: .graphml .dot; repeatable");
  add_output(command, "--parts", "FILE.ply", options.parts_file,
             "the mesh with vertices colored by arc");
  add_output(command, "--csv", "FILE.csv", options.csv_file, "a table with a row for each arc");
  add_picture_options(command, options, "the graph",
                      formatted("%g", opacity_around_bones_in_pictures));
  add_page_option(command, options, "the mesh and the graph");
  add_gltf_option(command, options, "the arcs");
  command.add_flag("--tubes", options.picture.has_tubes,
                   "draw arcs as thick as the solid, in the picture and the glTF model");
  add_view_options(command, options);
}

void add_computation_options(CLI::App& command, Reeb_command_options& options) {
  command.option_defaults()->group("How to compute");
  CLI::Option* seed =
      command
          .add_option("--seed", options.seeds,
                      "vertices where the diffusion starts; default: handle loops, or an end")
          ->option_text("VERTEX,...")
          ->delimiter(',')
          ->check(why_no_count)
          ->allow_extra_args(false);
  CLI::Option* height = add_numbers(command, "--height", "X,Y,Z", options.height, 3,
                                    "use the height in this direction instead of a diffusion")
                            ->excludes(seed);
  CLI::Option* values = command
                            .add_option("--values", options.values_file,
                                        "use the values of this file, a number for each vertex")
                            ->option_text("FILE")
                            ->type_name(input_file)
                            ->excludes(seed)
                            ->excludes(height);
  add_choice(command, "--backend", "NAME", options.backend,
             "backend of the diffusion: auto, host, cuda or reference; default: auto, a CUDA\n"
             "device if there is one",
             names_of_backends())
      ->excludes(height)
      ->excludes(values);
  add_part(command, "--simplify", options.threshold,
           "remove leaves smaller than this fraction of the whole, 0 to 1; default: 0.03");
  add_choice(command, "--measure", "NAME", options.measure,
             "size of a leaf: limbs, persistence, length, area or vertices; default: limbs\n"
             "for a diffusion, otherwise persistence",
             reeb_measures());
  command
      .add_option("--shortest-arc", options.shortest_arc,
                  "contract arcs between saddles that are shorter than K times their radius, but\n"
                  "never cycles; default: 2 with --parts (as long as thick), otherwise 0")
      ->option_text("K")
      ->check(why_negative);
  command.add_flag("--capped", options.is_capped,
                   "close boundary curves by caps first; otherwise contours end at the boundary");
  add_choice(command, "--drawing", "NAME", options.drawing,
             "inside (in the middle of the solid) or means (through the centers of contours:\n"
             "faster); default: inside if lines, a picture, a page or glTF are written",
             std::vector<std::string>{"inside", "means"});
  add_threads_option(command, options);
}

constexpr char reeb_description[] = R"(Computes the Reeb graph of a triangle mesh.

Its arcs are the parts of the surface that a front sweeps as one piece: the limbs of an animal,
the bars of a frame. A closed connected surface of genus g has a graph with g independent cycles.
On a surface with b boundary curves, contours end at the boundary, and there may be up to
2g + b - 1 cycles; with --capped there are g. The girth of an arc, in the table, is the length of
its contour just below its middle vertex.
)";

constexpr char reeb_examples[] = R"(Examples:
  htloops reeb chair.off --picture chair.png      a look at it
  htloops reeb chair.off -o chair.json --parts parts.ply --lines arcs.obj
                                                  for a program and for a viewer
  htloops reeb chair.off --height 0,0,1 --simplify 0 --graph chair.graphml
                                                  the full Reeb graph of the height
)";

} // namespace

void add_reeb_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Reeb_command_options>();
  CLI::App* reeb = app.add_subcommand("reeb", reeb_description)->group("Commands");
  add_mesh_argument(*reeb, *options, mesh_kinds());
  add_output_options(*reeb, *options);
  add_remedy_options(*reeb, *options);
  add_computation_options(*reeb, *options);
  reeb->option_defaults()->group("What to show");
  reeb->add_flag("--all-rows", options->show_all, "show all rows of a long table");
  reeb->add_flag("-q,--quiet", options->is_quiet, "print only errors");
  complete_help(*reeb, reeb_examples);
  reeb->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
