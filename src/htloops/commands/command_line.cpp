// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/command_line.h"

#include "commands/file_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace htloops {
namespace {

// Of "TEXT:{pure,shortest}": these two.
std::vector<std::string> listed_values(const std::string& type) {
  const std::size_t begin = type.find('{'), end = type.rfind('}');
  std::vector<std::string> values;
  if(begin == std::string::npos || end == std::string::npos)
    return values;
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for(std::string value; std::getline(list, value, ',');)
    values.push_back(value);
  return values;
}

Told_option told_option(const CLI::Option& option) {
  Told_option told;
  if(!option.get_lnames().empty())
    told.long_name = option.get_lnames().front();
  if(!option.get_snames().empty())
    told.short_name = option.get_snames().front();
  const std::string type = option.get_type_name();
  if(option.get_items_expected_max() > 0)
    told.value = option.get_option_text().empty() ? "VALUE" : option.get_option_text();
  told.values = listed_values(type);
  told.is_file = type == input_file || type == output_file;
  told.description = option.get_description();
  return told;
}

} // namespace

std::string Told_command::summary() const {
  std::string text = description.substr(0, description.find("\n\n"));
  text.erase(text.find_last_not_of("\n ") + 1);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

Told_command told_command(const CLI::App& app) {
  Told_command told{app.get_name(), app.get_description(), app.get_footer(), {}, {}, {}, {}};
  for(const CLI::Option* option : app.get_options())
    if(option->get_positional()) {
      told.arguments.push_back(option->get_name(true));
      told.argument_values = listed_values(option->get_type_name());
    } else
      told.options.push_back(told_option(*option));
  for(const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    told.commands.push_back(told_command(*command));
  return told;
}

} // namespace htloops
