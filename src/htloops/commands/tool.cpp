// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/tool.h"

#include "commands/command.h"
#include "commands/file_options.h"
#include "commands/help_style.h"
#include "commands/outcome.h"
#include "commands/usage_message.h"
#include "failure.h"
#include "terminal/interrupt.h"
#include "version.h"

#include <iostream>
#include <memory>
#include <string>

namespace htloops {
namespace {

constexpr char tool_description[] = "Finds handle and tunnel loops, and Reeb graphs, on triangle "
                                    "meshes, and cuts them open.\n";

constexpr char tool_footer[] =
    "Exit codes: 0 done, 1 no certified answer (or no memory to find it), 2 wrong usage or\n"
    "  unwritable output, 3 a file cannot be read, 4 the mesh is not an oriented manifold of\n"
    "  triangles, 5 the backend asked for is not there; 128 and the\n"
    "  number of the signal if interrupted: 130 by Ctrl-C.\n"
    "\n"
    "Examples:\n"
    "  htloops generate torus -o torus.off             makes a mesh to try\n"
    "  htloops loops torus.off -o torus.json           finds its loops\n"
    "  htloops check torus.off torus.json              checks them\n"
    "  htloops reeb torus.off --picture reeb.png       draws its Reeb graph\n"
    "  htloops cut torus.off -o open.obj               cuts it open to a disk\n"
    "  htloops remove torus.off -o ball.off            removes its handle\n"
    "  htloops loops --help                            says more of a command\n";

// Names of files may be of any characters; none of them is to move the cursor.
std::string printable(std::string message) {
  for(char& c : message)
    if(static_cast<unsigned char>(c) < ' ' && c != '\n')
      c = '?';
  return message;
}

int report(int code, const std::string& message) {
  std::cerr << "htloops: " << printable(message) << std::endl;
  return code;
}

int run_command(const CLI::App& app, const Command& command) {
  const Interrupt_guard guard;
  const Outcome outcome = outcome_of([&] {
    check_files(app);
    command();
  });
  return outcome.exit_code == 0 ? 0 : report(outcome.exit_code, outcome.message);
}

} // namespace

int run_tool(int argc, char** argv) {
  CLI::App app(tool_description, "htloops");
  app.formatter(std::make_shared<Help_formatter>("COMMAND"));
  app.failure_message(usage_message);
  app.require_subcommand(1);
  Command command;
  add_loops_command(app, command);
  add_reeb_command(app, command);
  add_cut_command(app, command);
  add_remove_command(app, command);
  add_check_command(app, command);
  add_generate_command(app, command);
  add_help_commands(app, command);
  app.set_version_flag("--version", version(), "the versions of what this is")->group("Help");
  complete_help(app, tool_footer);

  if(argc < 2) {
    std::cerr << app.help();
    return static_cast<int>(Exit_code::WRONG_USAGE);
  }
  try {
    app.parse(argc, argv);
  } catch(const CLI::ParseError& error) {
    const bool is_request = app.exit(error) == static_cast<int>(CLI::ExitCodes::Success);
    if(is_request && !std::cout.flush())
      return report(static_cast<int>(Exit_code::WRONG_USAGE), "cannot write the standard output");
    return static_cast<int>(is_request ? Exit_code::DONE : Exit_code::WRONG_USAGE);
  }
  return run_command(app, command);
}

} // namespace htloops
