// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/command.h"
#include "commands/common_options.h"
#include "commands/help_style.h"
#include "commands/man_page.h"
#include "commands/shell_completion.h"

#include <memory>
#include <string>

namespace htloops {
namespace {

constexpr char completion_examples[] =
    "Examples:\n"
    "  source <(htloops completion bash)               for this shell; an installed htloops is\n"
    "                                                  completed in each\n";

} // namespace

void add_help_commands(CLI::App& app, Command& command) {
  const char group[] = "More help";
  const auto shell = std::make_shared<std::string>();
  CLI::App* completion = app.add_subcommand(
      "completion", "Prints a script that makes a shell complete the words of htloops.\n");
  completion->group(group);
  completion->add_option("SHELL", *shell, "bash, fish or zsh")
      ->option_text(" ")
      ->required()
      ->check(CLI::IsMember(known_shells()));
  complete_help(*completion, completion_examples);
  completion->callback([&app, shell, &command] {
    command = [&app, shell] { show_text(shell_completion(*shell, told_command(app)), false); };
  });
  CLI::App* man = app.add_subcommand("man", "Prints the manual page, for man(1).\n");
  man->group(group);
  complete_help(*man);
  man->callback(
      [&app, &command] { command = [&app] { show_text(man_page(told_command(app)), false); }; });
}

} // namespace htloops
