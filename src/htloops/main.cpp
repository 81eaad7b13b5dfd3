// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/command.h"
#include "commands/file_options.h"
#include "commands/help_style.h"
#include "failure.h"
#include "terminal/interrupt.h"
#include "version.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>

#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace {

using htloops::Exit_code;

constexpr char description[] = "Finds handle and tunnel loops, and Reeb graphs, on triangle "
                               "meshes, and cuts them open.\n";

constexpr char footer[] =
    "Exit codes: 0 done, 1 no certified answer, 2 wrong usage or unwritable output,\n"
    "  3 a file cannot be read, 4 the mesh is not an oriented manifold of triangles,\n"
    "  5 the backend asked for is not there, 130 interrupted.\n"
    "\n"
    "Examples:\n"
    "  htloops generate torus -o torus.off             makes a mesh to try\n"
    "  htloops loops torus.off -o torus.json           finds its loops\n"
    "  htloops check torus.off torus.json              checks them\n"
    "  htloops reeb torus.off --picture reeb.png       draws its Reeb graph\n"
    "  htloops cut torus.off -o open.obj               cuts it open to a disk\n"
    "  htloops remove torus.off -o ball.off            removes its handle\n"
    "  htloops loops --help                            says more of a command\n";

std::string usage_message(const CLI::App* app, const CLI::Error& error) {
  const std::vector<std::string> unknown = app->remaining(true);
  const std::string problem =
      unknown.empty() ? error.what() : "'" + unknown.front() + "' is not understood";
  return "htloops: " + problem +
         "\n'htloops --help' and 'htloops COMMAND --help' tell what there is\n";
}

int report(Exit_code code, const char* message) {
  std::cerr << "htloops: " << message << std::endl;
  return static_cast<int>(code);
}

int report_interrupt() {
  std::cerr << "htloops: interrupted, nothing more is written" << std::endl;
  return 128 + htloops::interrupting_signal();
}

int run(const CLI::App& app, const htloops::Command& command) {
  try {
    htloops::check_files(app);
    command();
    return static_cast<int>(Exit_code::DONE);
  } catch(const htloops::Failure& failure) {
    return report(failure.code(), failure.what());
  } catch(const htloops::Interrupted&) {
    return report_interrupt();
  } catch(const CGAL::Handle_tunnel_loops::Interrupted_exception&) {
    return report_interrupt();
  } catch(const CGAL::Handle_tunnel_loops::Invalid_mesh_exception& exception) {
    return report(Exit_code::UNACCEPTABLE_MESH, exception.what());
  } catch(const CGAL::Handle_tunnel_loops::Invalid_function_exception& exception) {
    return report(Exit_code::WRONG_USAGE, exception.what());
  } catch(const std::bad_alloc&) {
    return report(Exit_code::NOT_CERTIFIED, "out of memory");
  } catch(const std::exception& exception) {
    return report(Exit_code::NOT_CERTIFIED, exception.what());
  }
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app(description, "htloops");
  app.formatter(std::make_shared<htloops::Help_formatter>("COMMAND"));
  app.failure_message(usage_message);
  app.require_subcommand(1);
  htloops::Command command;
  htloops::add_loops_command(app, command);
  htloops::add_reeb_command(app, command);
  htloops::add_cut_command(app, command);
  htloops::add_remove_command(app, command);
  htloops::add_check_command(app, command);
  htloops::add_generate_command(app, command);
  app.set_version_flag("--version", htloops::version(), "the versions of what this is")
      ->group("Help");
  htloops::complete_help(app, footer);

  if(argc < 2) {
    std::cerr << app.help();
    return static_cast<int>(Exit_code::WRONG_USAGE);
  }
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    const bool is_request = app.exit(error) == static_cast<int>(CLI::ExitCodes::Success);
    if(is_request && !std::cout.flush())
      return report(Exit_code::WRONG_USAGE, "cannot write the standard output");
    return static_cast<int>(is_request ? Exit_code::DONE : Exit_code::WRONG_USAGE);
  }
  return run(app, command);
}
