// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/usage_messages.h"

#include "app/file_names.h"
#include "app/read/meshes/mesh_formats.h"
#include "app/system/files.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <regex>
#include <system_error>
#include <utility>
#include <vector>

namespace htloops {
namespace {

std::string name_of(const CLI::App& command) {
  return command.get_parent() == nullptr
             ? command.get_name()
             : name_of(*command.get_parent()) + " " + command.get_name();
}

// How many letters have to be put in, taken out, replaced, or swapped with the next one (Damerau).
std::size_t distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1), last, before;
  std::iota(row.begin(), row.end(), std::size_t(0));
  for(std::size_t i = 0; i < from.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i + 1;
    for(std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = last[j] + (from[i] == to[j] ? 0 : 1);
      row[j + 1] = (std::min)({replaced, row[j] + 1, last[j + 1] + 1});
      if(i > 0 && j > 0 && from[i] == to[j - 1] && from[i - 1] == to[j])
        row[j + 1] = (std::min)(row[j + 1], before[j - 1] + 1);
    }
  }
  return row.back();
}

std::vector<std::string> words_of(const CLI::App& command) {
  std::vector<std::string> words;
  for(const CLI::App* subcommand : command.get_subcommands([](const CLI::App*) { return true; }))
    words.push_back(subcommand->get_name());
  for(const CLI::Option* option : command.get_options())
    for(const std::string& name : option->get_lnames())
      words.push_back("--" + name);
  return words;
}

// The nearest of the words, if it is near, or goes on as this one begins.
std::string nearest(const std::string& unknown, const std::vector<std::string>& words) {
  const std::size_t letters =
      unknown.size() - (std::min)(unknown.find_first_not_of('-'), unknown.size());
  std::string best;
  std::size_t least = (std::max)(letters / 3, std::size_t(1));
  for(const std::string& word : words) {
    const bool goes_on = unknown.size() > 3 && word.compare(0, unknown.size(), unknown) == 0;
    const std::size_t d = goes_on ? 0 : distance(unknown, word);
    if(d < least || (d == least && best.empty())) {
      least = d;
      best = word;
    }
  }
  return best;
}

// The commands that have an option of this name.
std::vector<std::string> commands_with(const CLI::App& command, const std::string& option) {
  std::vector<std::string> names;
  if(option.compare(0, 2, "--") == 0 && command.get_parent() != nullptr)
    for(const CLI::App* other : command.get_parent()->get_subcommands(
            [](const CLI::App* sub) { return !sub->get_name().empty(); }))
      if(other != &command && other->get_option_no_throw(option) != nullptr)
        names.push_back("'" + name_of(*other) + "'");
  return names;
}

// Whether a word that is taken for options is the name of a file.
bool is_file_with_dash(const std::string& word) {
  std::error_code error;
  return word.front() == '-' &&
         (is_named_as_mesh(word) || std::filesystem::exists(path_of(word), error));
}

std::string words_of_unknown(const CLI::App& command, const std::string& word) {
  const bool is_of_tool = command.get_parent() == nullptr;
  if(!word.empty() && is_file_with_dash(word))
    return words_of_dash(word);
  if(!is_of_tool && is_named_as_mesh(word))
    return "'" + printable(word) + "' is one file too many" +
           (command.get_option_no_throw("--output") != nullptr &&
                    command.get_option_no_throw("OUT") == nullptr
                ? "; -o names the file for the result"
                : "");
  const std::string unknown = "'" + printable(word) + "' is not a known command or option";
  const std::string meant = is_of_tool && is_named_as_mesh(word)
                                ? name_of(command) + " loops " + printable(word)
                                : nearest(word, words_of(command));
  const std::vector<std::string> others = commands_with(command, word);
  if(!others.empty() && meant.compare(0, word.size(), word) != 0)
    return unknown + " of '" + name_of(command) + "'; it is an option of " +
           boost::algorithm::join(others, ", ");
  return unknown + (meant.empty() ? "" : "; did you mean '" + meant + "'?");
}

// What an option takes, as its help says.
std::string taken_by(const CLI::App& command, const std::string& name) {
  const CLI::Option* option = command.get_option_no_throw(name);
  return option == nullptr ? "" : option->get_option_text();
}

// Messages of CLI11 in the words of this tool.
std::string words_of_error(const CLI::App& command, const std::string& message) {
  constexpr std::size_t longest = 1000; // for expressions that go as deep as a text is long
  if(message.size() > longest)
    return message;
  std::smatch found;
  if(std::regex_match(message, found, std::regex("(--?[a-z-]+): At [Mm]ost 1 required.*")))
    return found.str(1) + " can be given only once";
  if(std::regex_match(
         message, found,
         std::regex("(--?[a-z-]+): (?:At [Ll]east|At [Mm]ost|Exactly) ([0-9]+) required.*")))
    return found.str(1) + " takes " + found.str(2) + " values: " + taken_by(command, found.str(1));
  if(std::regex_match(message, found, std::regex("(--?[a-z-]+): 1 required .*missing")))
    return found.str(1) + " needs a value: " + taken_by(command, found.str(1));
  if(std::regex_match(message, found,
                      std::regex("(--?[a-z-]+): Value (.*) not in range (.*) to (.*)")))
    return found.str(1) + ": " + found.str(2) + " is not a number from " +
           std::regex_replace(found.str(3), std::regex("[.]0+$"), "") + " to " +
           std::regex_replace(found.str(4), std::regex("[.]0+$"), "");
  if(std::regex_match(message, found, std::regex("(--?[a-z-]+): (.*) not in \\{(.*)\\}")))
    return found.str(1) + ": '" + found.str(2) + "' is not one of " +
           std::regex_replace(found.str(3), std::regex(","), ", ");
  if(std::regex_match(message, found, std::regex("Could not convert: (--?[a-z-]+) = (.*)")))
    return found.str(1) + ": '" + found.str(2) + "' is not valid: it takes " +
           taken_by(command, found.str(1));
  if(std::regex_match(message, found, std::regex("(.*) excludes (.*)")))
    return found.str(1) + " cannot be combined with " + found.str(2);
  if(std::regex_match(message, found, std::regex("(--?[a-z-]+) requires (.*)")))
    return found.str(1) + " needs " + found.str(2);
  return message == "A subcommand is required" ? "a kind of mesh is required, such as torus"
                                               : message;
}

} // namespace

std::string words_of_dash(const std::string& file) {
  return printable(file) + " looks like an option; for a file of that name, write ./" +
         printable(file);
}

const CLI::App& begun_command(const CLI::App& app) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  return commands.empty() ? app : begun_command(*commands.back());
}

std::string usage_message(const CLI::App* app, const CLI::Error& error) {
  const CLI::App& command = begun_command(*app);
  const std::vector<std::string> unknown = app->remaining(true);
  std::string words;
  if(unknown.empty())
    words = words_of_error(command, printable_lines(error.what()));
  else {
    std::string word = unknown.front();
    word.resize((std::min)(word.find('='), word.size()));
    words = words_of_unknown(command, word);
  }
  return "htloops: " + words + "\nsee '" + name_of(command) + " --help'\n";
}

} // namespace htloops
