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
#include "app/read/meshes/mesh_formats.h"
#include "app/version.h"
#include "commands/command.h"
#include "commands/options.h"
#include "commands/usage_messages.h"
#include "terminal/terminal.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace htloops {
namespace {

Outcome ended_by(Exit_code code, const char* message) { return {static_cast<int>(code), message}; }

Outcome interrupted() {
#ifdef SIGPIPE
  if(interrupting_signal() == SIGPIPE) // who read has enough
    return {128 + SIGPIPE, ""};
#endif
  return {128 + interrupting_signal(), "interrupted: no further files are written"};
}

constexpr char tool_description[] =
    "Finds handle and tunnel loops, Reeb graphs and curve skeletons of triangle\n"
    "meshes. Measures, removes, cuts and repairs.\n";

constexpr char tool_footer[] =
    R"(Exit codes: 0 success, 1 no certified answer (or out of memory), 2 wrong usage or output
  that cannot be written, 3 a file cannot be read, 4 the mesh is not an oriented triangle
  manifold, 5 the chosen backend is not available; 128 plus the number of the signal if
  interrupted (130 after Ctrl-C).

Examples:
  htloops generate torus -o torus.off             make a mesh to try
  htloops loops torus.off -o torus.json           find its loops
  htloops measure torus.off                       measure its thickness and clear width
  htloops check torus.off torus.json              check them
  htloops reeb torus.off --picture reeb.png       draw its Reeb graph
  htloops skeleton torus.off --lines torus.vtp    find its curve skeleton
  htloops cut torus.off -o open.obj               cut it open to a disk
  htloops remove torus.off -o ball.off --all      remove its handle
  htloops repair soup.stl -o sound.off            turn any mesh into a manifold
  htloops loops --help                            show the help of a command
)";

int report(int code, const std::string& message) {
  if(!message.empty())
    std::cerr << "htloops: " << printable_lines(message) << std::endl;
  return code;
}

int run_command(const CLI::App& app, const Command& command) {
  const Interrupt_guard guard;
  const Outcome outcome = outcome_of([&] {
    check_files(app);
    show_note_on_threads(begun_command(app));
    command();
  });
  return outcome.exit_code == 0 ? 0 : report(outcome.exit_code, outcome.message);
}

} // namespace

Outcome outcome_of(const std::function<void()>& action) {
  using namespace CGAL::Handle_tunnel_loops;
  try {
    action();
    return {};
  } catch(const Failure& failure) {
    return ended_by(failure.code(), failure.what());
  } catch(const Interrupted&) {
    return interrupted();
  } catch(const Interrupted_exception&) {
    return interrupted();
  } catch(const Invalid_mesh_exception& exception) {
    return ended_by(Exit_code::UNACCEPTABLE_MESH, exception.what());
  } catch(const Invalid_function_exception& exception) {
    return ended_by(Exit_code::WRONG_USAGE, exception.what());
  } catch(const No_device_exception& exception) {
    return ended_by(Exit_code::NO_BACKEND, exception.what());
  } catch(const Out_of_device_memory_exception& exception) {
    return ended_by(Exit_code::NO_BACKEND, exception.what());
  } catch(const std::bad_alloc&) {
    return ended_by(Exit_code::NOT_CERTIFIED, "out of memory");
  } catch(const std::length_error&) { // more than there can be
    return ended_by(Exit_code::NOT_CERTIFIED, "out of memory");
  } catch(const std::exception& exception) {
    return ended_by(Exit_code::NOT_CERTIFIED, exception.what());
  }
}

int run_tool(int argc, char** argv) {
  prepare_standard_streams();
  CLI::App app(tool_description, "htloops");
  app.formatter(std::make_shared<Help_formatter>("COMMAND"));
  app.failure_message(usage_message);
  app.require_subcommand(1);
  Command command;
  add_loops_command(app, command);
  add_measure_command(app, command);
  add_reeb_command(app, command);
  add_skeleton_command(app, command);
  add_cut_command(app, command);
  add_remove_command(app, command);
  add_clean_command(app, command);
  add_repair_command(app, command);
  add_check_command(app, command);
  add_generate_command(app, command);
  add_help_commands(app, command);
  app.set_version_flag("--version", version(), "the versions of htloops and its libraries")
      ->group("Help");
  complete_help(app, tool_footer);

  std::vector<std::string> arguments = words_of_command_line(argc, argv);
  if(arguments.empty()) {
    std::cerr << app.help();
    return static_cast<int>(Exit_code::WRONG_USAGE);
  }
  try {
    write_out_size(arguments);
    check_lists(app, arguments);
    write_out_bores(arguments);
    std::reverse(arguments.begin(), arguments.end()); // as CLI11 wants them
    app.parse(std::move(arguments));
  } catch(const Failure& failure) {
    return report(static_cast<int>(failure.code()), failure.what());
  } catch(const CLI::ParseError& error) {
    const bool is_request = app.exit(error) == static_cast<int>(CLI::ExitCodes::Success);
    if(is_request && !std::cout.flush())
      return report(static_cast<int>(Exit_code::WRONG_USAGE), "cannot write the standard output");
    return static_cast<int>(is_request ? Exit_code::DONE : Exit_code::WRONG_USAGE);
  }
  return run_command(app, command);
}

} // namespace htloops
