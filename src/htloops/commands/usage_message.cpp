// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/usage_message.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace htloops {
namespace {

// The command that was begun, as far as its words were understood.
const CLI::App& begun_command(const CLI::App& app) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  return commands.empty() ? app : begun_command(*commands.back());
}

std::string name_of(const CLI::App& command) {
  return command.get_parent() == nullptr
             ? command.get_name()
             : name_of(*command.get_parent()) + " " + command.get_name();
}

// How many letters have to be put in, taken out or replaced (Levenshtein).
std::size_t distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for(std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for(std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = (std::min)({replaced, row[j] + 1, row[j + 1] + 1});
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
  std::string best;
  std::size_t least = unknown.size() / 3 + 1;
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

} // namespace

std::string usage_message(const CLI::App* app, const CLI::Error& error) {
  const CLI::App& command = begun_command(*app);
  const std::string help = "\n'" + name_of(command) + " --help' tells what there is\n";
  const std::vector<std::string> unknown = app->remaining(true);
  if(unknown.empty())
    return "htloops: " + std::string(error.what()) + help;
  std::string word = unknown.front();
  word.resize((std::min)(word.find('='), word.size()));
  const std::string meant = nearest(word, words_of(command));
  return "htloops: '" + word + "' is not understood" +
         (meant.empty() ? "" : "; did you mean '" + meant + "'?") + help;
}

} // namespace htloops
