// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/common_options.h"

#include "commands/file_options.h"
#include "draw/export_gltf.h"
#include "draw/export_lines.h"
#include "failure.h"
#include "write/atomic_file.h"

#include <CLI/CLI.hpp>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace htloops {
namespace {

void check_picture(const Picture_options& picture) {
  check_name(picture.file, "a picture in PNG", ".png");
  if((picture.has_labels || picture.has_legend) && !can_write_on_pictures())
    throw Failure(Exit_code::WRONG_USAGE,
                  "--labels and --legend want a build with stb and the DejaVu fonts");
}

void add_word_options(CLI::App& command, Picture_options& picture, const std::string& group) {
  command
      .add_flag("--labels", picture.has_labels,
                "numbers beside the lines of the picture, where there is room")
      ->needs("--picture")
      ->group(group);
  command
      .add_flag("--legend", picture.has_legend, "what the colours of these lines mean, in a corner")
      ->needs("--picture")
      ->group(group);
}

} // namespace

void add_json_option(CLI::App& command,
                     Common_options& options,
                     const std::string& what,
                     const std::string& group) {
  command.add_option("-o,--output", options.json_file, what + " as JSON; - is standard output")
      ->option_text("FILE.json")
      ->type_name(output_file)
      ->group(group);
}

void add_lines_option(CLI::App& command,
                      Common_options& options,
                      const std::string& what,
                      const std::string& group) {
  command
      .add_option("--lines", options.lines_files,
                  what + " as lines: .ply .obj .vtp .polylines.txt; repeatable")
      ->option_text("FILE")
      ->type_name(output_file)
      ->allow_extra_args(false)
      ->group(group);
}

void add_picture_options(CLI::App& command,
                         Common_options& options,
                         const std::string& what,
                         const std::string& group,
                         bool has_words) {
  if(!has_pictures)
    return;
  command.add_option("--picture", options.picture.file, "a picture of the mesh and " + what)
      ->option_text("FILE.png")
      ->type_name(output_file)
      ->group(group);
  command
      .add_option("--size", options.picture.size, "of the picture, in pixels; default: 1600,1200")
      ->option_text("W,H")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(16, 16384))
      ->check(why_not_finite)
      ->needs("--picture")
      ->group(group);
  command
      .add_option("--opacity", options.picture.opacity,
                  "of the surface over lines behind it, 0 to 1: 1 hides them;\n"
                  "default: 0.5, and more the more lines there are")
      ->option_text("PART")
      ->check(CLI::Range(0., 1.))
      ->check(why_not_finite)
      ->needs("--picture")
      ->group(group);
  if(has_words)
    add_word_options(command, options.picture, group);
}

void add_page_option(CLI::App& command,
                     Common_options& options,
                     const std::string& what,
                     const std::string& group) {
  command.add_option("--html", options.page_file, "a page for a browser, to turn " + what + " in")
      ->option_text("FILE.html")
      ->type_name(output_file)
      ->group(group);
}

void add_gltf_option(CLI::App& command,
                     Common_options& options,
                     const std::string& what,
                     const std::string& group) {
  command.add_option("--gltf", options.gltf_file, what + " as tubes, with the mesh, as glTF")
      ->option_text("FILE.glb")
      ->type_name(output_file)
      ->group(group);
}

void add_view_options(CLI::App& command, Common_options& options, const std::string& group) {
  const auto add_direction = [&](const char* name, std::vector<double>& direction,
                                 const char* meaning) {
    command.add_option(name, direction, meaning)
        ->option_text("X,Y,Z")
        ->delimiter(',')
        ->expected(3)
        ->check(why_not_finite)
        ->group(group);
  };
  add_direction("--view", options.view.from,
                "direction that is looked from; default: where most is visible, of pairs that\n"
                "were asked for above all");
  add_direction("--up", options.view.up, "direction that is upright; default: 0,0,1");
}

void add_threads_option(CLI::App& command, Common_options& options, const std::string& group) {
  constexpr int largest_number_of_threads = 1024;
  command
      .add_option("--threads", options.number_of_threads,
                  "threads to use, 1 to " + std::to_string(largest_number_of_threads) +
                      "; default: one per core")
      ->option_text("N")
      ->check(CLI::Range(1, largest_number_of_threads))
      ->group(group);
}

void check_common_options(const Common_options& options) {
  check_mesh_options(options);
  for(const auto& [name, direction] :
      {std::pair("--view", options.view.from), std::pair("--up", options.view.up)})
  {
    if(direction.empty())
      continue;
    if(is_zero(direction))
      throw Failure(Exit_code::WRONG_USAGE, std::string(name) + " 0,0,0 is no direction");
    if(options.picture.file.empty() && options.page_file.empty())
      throw Failure(Exit_code::WRONG_USAGE, std::string(name) +
                                                " says how to look at something: it needs " +
                                                (has_pictures ? "--picture or --html" : "--html"));
  }
  check_name(options.json_file, "JSON", ".json");
  check_name(options.page_file, "a page in HTML", ".html");
  check_picture(options.picture);
  check_picture_size(options.picture);
  for(const std::string& file : options.lines_files)
    check_lines_format(file);
  if(!options.gltf_file.empty())
    check_gltf_format(options.gltf_file);
}

void check_name(const std::string& file, const char* what, const char* end) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if(!extension.empty() && !boost::algorithm::iequals(extension, end))
    throw Failure(Exit_code::WRONG_USAGE, "cannot write " + file + ": what is written there is " +
                                              what + ", and the name must end in " + end +
                                              ", or have no such end");
}

std::string why_no_count(const std::string& text) {
  const bool is_count = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isdigit(c) != 0;
  });
  return is_count && text.size() < 19 ? "" : text + " is no count";
}

std::string why_not_finite(const std::string& text) {
  double number;
  const bool is_finite = CLI::detail::lexical_cast(text, number) && std::isfinite(number);
  return is_finite ? "" : text + " is not a finite number";
}

Mesh::Vertex_index vertex_of_mesh(const Mesh& mesh, std::uint32_t number) {
  const std::string name = "the seed vertex " + std::to_string(number);
  if(number >= mesh.number_of_vertices())
    throw Failure(Exit_code::WRONG_USAGE, name + " is not one of the " +
                                              std::to_string(mesh.number_of_vertices()) +
                                              " vertices (they count from 0)");
  const Mesh::Vertex_index v(number);
  if(mesh.is_isolated(v))
    throw Failure(Exit_code::WRONG_USAGE, name + " belongs to no face");
  return v;
}

void show_text(const std::string& text, bool is_output_taken) {
  if(is_output_taken) {
    std::fputs(text.c_str(), stderr);
    return;
  }
  Atomic_file output("-");
  output.write(text.data(), text.size());
  output.commit();
}

bool is_zero(const std::vector<double>& direction) {
  return std::all_of(direction.begin(), direction.end(), [](double x) { return x == 0.; });
}

} // namespace htloops
