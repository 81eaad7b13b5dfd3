// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_COMMAND_H
#define HTLOOPS_COMMAND_H

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace htloops {

/// What the command line asks for; throws `Failure` if it cannot be done.
using Command = std::function<void()>;

// Each declares a command with its options; if the command line asks for it, parsing assigns it to
// `command`. A new command is one more function here and its call in main().
void add_loops_command(CLI::App& app, Command& command);
void add_measure_command(CLI::App& app, Command& command);
void add_reeb_command(CLI::App& app, Command& command);
void add_skeleton_command(CLI::App& app, Command& command);
void add_cut_command(CLI::App& app, Command& command);
void add_remove_command(CLI::App& app, Command& command);
void add_clean_command(CLI::App& app, Command& command);
void add_repair_command(CLI::App& app, Command& command);
void add_check_command(CLI::App& app, Command& command);
void add_generate_command(CLI::App& app, Command& command);

/// writes the range of `--bores` out where none is given: what follows may be the name of a mesh.
void write_out_bores(std::vector<std::string>& arguments);

/// writes a size that is given as 900x600 as the list that it is.
void write_out_size(std::vector<std::string>& arguments);

/// throws `Failure`, saying how it is written, where the words of a command line have a list that
/// is not written as all lists are: 1,2,3.
void check_lists(const CLI::App& tool, const std::vector<std::string>& arguments);

/// completions for shells, the manual page, and help by name.
void add_help_commands(CLI::App& app, Command& command);

/// How the help looks: a list of commands shows the first paragraph of each description.
class Help_formatter : public CLI::Formatter
{
public:
  /// `subcommand` is what the commands below are called, in capitals.
  explicit Help_formatter(const std::string& subcommand);

  std::string
  make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

/// gives a command that has all its options the one for help, last, and the text that ends the
/// help.
void complete_help(CLI::App& command, const std::string& footer = "");

/// How something ended: an exit code, 0 if all is done, and what is said to the user if it is not.
struct Outcome
{
  int exit_code = 0;
  std::string message;
};

/// does something and turns what is thrown into an exit code and a message.
Outcome outcome_of(const std::function<void()>& action);

/// does what the words of a command line say; returns the exit code.
int run_tool(int argc, char** argv);

} // namespace htloops

#endif // HTLOOPS_COMMAND_H
