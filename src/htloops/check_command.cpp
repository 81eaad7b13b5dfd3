// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "command.h"
#include "failure.h"
#include "help_style.h"
#include "loops_binding.h"
#include "loops_json_reader.h"
#include "mesh_reader.h"

#include <CGAL/Handle_tunnel_loops/certificate.h>

#include <iostream>
#include <memory>

namespace htloops {
namespace {

struct Check_options
{
  std::string mesh_file;
  std::string loops_file;
  bool is_quiet = false;
};

constexpr std::size_t largest_number_of_problems_shown = 10;

[[noreturn]] void fail(const std::string& loops_file, const std::string& problems) {
  throw Failure(Exit_code::NOT_CERTIFIED, loops_file + " fails its certificate:" + problems);
}

void check_binding(const std::string& loops_file, const std::vector<std::string>& problems) {
  if(problems.empty())
    return;
  std::string text;
  for(std::size_t i = 0; i < problems.size() && i < largest_number_of_problems_shown; ++i)
    text += "\n  " + problems[i];
  if(problems.size() > largest_number_of_problems_shown)
    text += "\n  and " + std::to_string(problems.size() - largest_number_of_problems_shown) +
            " more such problems";
  fail(loops_file, text);
}

void run(const Check_options& options) {
  const Mesh mesh = read_mesh(options.mesh_file);
  const Bound_loops loops = bind_loops(read_loops_json(options.loops_file), mesh);
  check_binding(options.loops_file, loops.problems);
  const auto certificate = CGAL::certify_handle_tunnel_loops(mesh, loops.pairs);
  if(!certificate)
    fail(options.loops_file, " " + certificate.failure);
  if(!options.is_quiet)
    std::cout << options.loops_file << ": the " << 2 * loops.pairs.size()
              << " loops are closed, lie on the surface and are a basis of H1(S; Z)" << std::endl;
}

constexpr char description[] =
    "Checks that the loops of a file are a basis of H1(S; Z) of their mesh.\n"
    "\n"
    "The certificate is computed from the two files alone; what the JSON says of itself is "
    "ignored.\n";

constexpr char examples[] =
    "Exit codes: 0 all is well, 1 the loops fail, 3 a file cannot be read, 4 the mesh is unfit.\n"
    "\n"
    "Example:\n"
    "  htloops check cup.off cup.json && echo 'a basis'\n";

} // namespace

void add_check_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Check_options>();
  CLI::App* check = app.add_subcommand("check", description)->group("Commands");
  check->add_option("MESH", options->mesh_file, "the mesh that the loops were computed on")
      ->option_text(" ")
      ->required();
  check->add_option("LOOPS.json", options->loops_file, "what 'htloops loops MESH -o' wrote")
      ->option_text(" ")
      ->required();
  check->add_flag("-q,--quiet", options->is_quiet, "nothing but errors")->group("What to show");
  complete_help(*check, examples);
  check->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
