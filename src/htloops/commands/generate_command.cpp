// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/failure.h"
#include "app/file_names.h"
#include "app/interrupt.h"
#include "app/read/input_file.h"
#include "app/words.h"
#include "app/write/mesh_writer.h"
#include "commands/command.h"
#include "commands/options.h"
#include "generators/Shape.h"
#include "generators/generators.h"
#include "terminal/terminal.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace htloops {
namespace {

namespace generators = CGAL::Handle_tunnel_loops::generators;

struct Generate_options
{
  std::string text_file;        // that describes the shape, instead of a kind
  bool is_size_of_text = false; // as many faces as the text asks for
  generators::Request request;
  generators::Hole_request holes;
  std::string mesh_file;
  bool is_quiet = false;
};

generators::Soup make_from_text(const Generate_options& options, std::size_t& expected_faces) {
  const generators::Shape shape(Input_file(options.text_file).content());
  generators::Request request = options.request;
  if(options.is_size_of_text)
    request.faces = expected_faces = shape.faces();
  const auto mesh_of = [&shape](const generators::Request& r) {
    return generators::mesh_of_shape(shape, r, "shape");
  };
  return generators::make({"shape", "", mesh_of}, request);
}

generators::Soup generate(const generators::Kind& kind,
                          const Generate_options& options,
                          std::size_t& expected_faces) {
  expected_faces = options.request.faces;
  try {
    const generators::Soup mesh = options.text_file.empty()
                                      ? generators::make(kind, options.request)
                                      : make_from_text(options, expected_faces);
    return options.holes.number > 0 ? generators::with_holes(mesh, options.holes) : mesh;
  } catch(const std::invalid_argument& reason) {
    throw wrong_usage(reason.what());
  }
}

/// of what a mesh is: "genus 3", "genus 3 in 2 components, 5 boundary curves".
std::string shape_of(const generators::Soup& mesh) {
  const std::size_t components = generators::number_of_components(mesh);
  const std::string genus = "genus " + std::to_string(generators::genus(mesh));
  const std::size_t boundaries = generators::number_of_boundaries(mesh);
  return genus + (components == 1 ? "" : " in " + counted(components, "component", "components")) +
         (boundaries == 0 ? "" : ", " + counted(boundaries, "boundary curve", "boundary curves"));
}

void run(const generators::Kind& kind, const Generate_options& options) {
  check_mesh_format(options.mesh_file);
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  std::size_t expected_faces = 0; // none while the mesh does not grow
  const generators::Watch_guard watch([&](std::size_t faces) {
    if(!bar.update(expected_faces == 0 ? 0. : double(faces) / double(expected_faces)))
      throw Interrupted();
  });
  bar.start("generate");
  const generators::Soup mesh = generate(kind, options, expected_faces);
  bar.end();
  expected_faces = 0;
  bar.start("write");
  const std::function<bool()> look = [&bar] { return !bar.update(0.); };
  const Interrupt_question question(look);
  write_mesh(options.mesh_file, mesh);
  if(options.is_quiet)
    return;
  const std::string text =
      printable(options.mesh_file) + ": " + std::to_string(mesh.points.size()) + " vertices, " +
      std::to_string(mesh.triangles.size()) + " faces, " + shape_of(mesh) + "\n";
  bar.end();
  show_text(text, options.mesh_file == "-");
}

template <typename Count>
void add_count(CLI::App& sub, const char* name, Count& value, const std::string& what) {
  sub.add_option(name, value, what + "; default: " + std::to_string(value))
      ->option_text("N")
      ->check(why_no_count);
}

/// the options that only some kinds have.
void add_options_of_kind(CLI::App& sub, unsigned options, generators::Request& request) {
  const auto add = [&](unsigned option, const char* name, std::size_t& value, const char* what) {
    if((options & option) != 0)
      add_count(sub, name, value, what);
  };
  add(generators::GENUS, "--genus", request.genus, "number of handles");
  add(generators::PARTS, "--parts", request.parts, "number of components");
  add(generators::TORUS_KNOT, "--long-way", request.p,
      "p: number of turns the long way around the torus");
  add(generators::TORUS_KNOT, "--short-way", request.q, "q: number of turns the short way");
  add(generators::WAVE_FREQUENCY, "--frequency", request.frequency, "waves per side of the box");
  add(generators::SMALL_BRIDGES, "--bridges", request.bridges, "number of small bridges");
  add(generators::SMALL_BRIDGES, "--tunnels", request.tunnels, "number of small tunnels");
  add(generators::NECKS, "--necks", request.necks, "number of necks");
}

// What stands for all shapes that somebody describes.
const generators::Kind& text_kind() {
  static const generators::Kind kind = {
      "shape",
      "a shape described by a text: balls, rods, pipes, rings and blocks, joined and cut out",
      nullptr,
      0,
      40000,
      0};
  return kind;
}

constexpr char faces_text[] = "about how many triangles";

void add_text_options(CLI::App& sub, Generate_options& options) {
  sub.add_option("--text", options.text_file,
                 "description of the shape, one part on each line; see the manual (required)")
      ->option_text("FILE")
      ->type_name(input_file)
      ->required();
  options.is_size_of_text = true;
  sub.add_option_function<std::size_t>(
         "--faces",
         [&options](std::size_t faces) {
           options.request.faces = faces;
           options.is_size_of_text = false;
         },
         std::string(faces_text) + "; default: the number in the text")
      ->option_text("N")
      ->check(why_no_count);
}

void add_kind(CLI::App& generate, const generators::Kind& kind, Command& command) {
  const auto options = std::make_shared<Generate_options>();
  options->request.faces = kind.default_faces;
  options->request.genus = kind.default_genus;
  CLI::App* sub =
      generate.add_subcommand(kind.name, std::string(kind.description) + "\n")->group("Kinds");
  sub->add_option("-o,--output", options->mesh_file,
                  "the mesh (required):" + words_of_written_meshes())
      ->option_text("MESH")
      ->type_name(output_file)
      ->required();
  if(&kind == &text_kind())
    add_text_options(*sub, *options);
  else
    add_count(*sub, "--faces", options->request.faces, faces_text);
  add_options_of_kind(*sub, kind.options, options->request);
  add_count(*sub, "--seed", options->request.seed,
            "seed of the random numbers, if the kind uses any");
  add_count(*sub, "--holes", options->holes.number,
            "number of holes, which give the mesh a boundary");
  add_count(*sub, "--hole-faces", options->holes.faces,
            "about how many triangles each of them takes");
  sub->add_flag("--ragged-holes", options->holes.is_ragged,
                "make the boundary of each hole as long as possible");
  sub->add_flag("-q,--quiet", options->is_quiet, "print only errors");
  complete_help(*sub);
  sub->callback(
      [&kind, options, &command] { command = [&kind, options] { run(kind, *options); }; });
}

constexpr char generate_description[] = R"(Generates a test mesh, usually of known genus.

All kinds take -o MESH (required), --faces N, --seed N and --holes N; most have more options.
)";

constexpr char generate_examples[] = R"(Examples:
  htloops generate torus -o torus.off
  htloops generate gyroid --faces 1000000 --genus 250 -o gyroid.off
  htloops generate plates --faces 1000 --genus 20 --parts 3 -o plates.off
  htloops generate torus-link --genus 2 --long-way 3 --short-way 4 -o link.off
  htloops generate torus --help                   the options of a kind
)";

} // namespace

void add_generate_command(CLI::App& app, Command& command) {
  CLI::App* generate = app.add_subcommand("generate", generate_description)->group("Commands");
  generate->formatter(std::make_shared<Help_formatter>("KIND"));
  generate->require_subcommand(1);
  for(const generators::Kind& kind : generators::kinds())
    add_kind(*generate, kind, command);
  add_kind(*generate, text_kind(), command);
  complete_help(*generate, generate_examples);
}

} // namespace htloops
