// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/help_style.h"

#include <sstream>

namespace htloops {
namespace {

constexpr std::size_t left_column_width = 26;
constexpr std::size_t right_column_width = 72;

std::string wrapped(const std::string& text) {
  std::istringstream words(text);
  std::string lines, word;
  std::size_t width = 0;
  while(words >> word) {
    const bool fits = width + 1 + word.size() <= right_column_width;
    lines += (width == 0 ? "" : fits ? " " : "\n") + word;
    width = word.size() + (fits ? width + 1 : 0);
  }
  return lines;
}

} // namespace

Help_formatter::Help_formatter(const std::string& subcommand) {
  column_width(left_column_width);
  label("SUBCOMMAND", subcommand);
  label("Positionals", "Arguments");
}

std::string
Help_formatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
  for(std::size_t at; (at = help.find("\n\n\n")) != std::string::npos;)
    help.erase(at, 1);
  help.erase(help.find_last_not_of('\n') + 1);
  return help + '\n';
}

std::string Help_formatter::make_subcommand(const CLI::App* command) const {
  const std::string description = command->get_description();
  std::ostringstream out;
  CLI::detail::format_help(out, command->get_name(),
                           wrapped(description.substr(0, description.find("\n\n"))),
                           left_column_width);
  return out.str();
}

void complete_help(CLI::App& command, const std::string& footer) {
  command.set_help_flag("-h,--help", "this help")->group("Help");
  command.footer(footer);
}

} // namespace htloops
