// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_HELP_H
#define HTLOOPS_HELP_H

#include <CLI/CLI.hpp>

#include <string>

namespace htloops {

/// How the help looks: a list of commands shows the first paragraph of each description.
class Help_formatter : public CLI::Formatter
{
public:
  /// `subcommand` is what the commands below are called, in capitals.
  explicit Help_formatter(const std::string& subcommand);

  std::string
  make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

/// gives a command that has all its options the one for help, last, and the text that ends the
/// help.
void complete_help(CLI::App& command, const std::string& footer = "");

} // namespace htloops

#endif // HTLOOPS_HELP_H
