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
#include "app/system/files.h"
#include "commands/command.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <system_error>

namespace htloops {
namespace {

using Lists = std::map<std::string, const CLI::Option*>;

// The options that take a list, by their names.
void collect(const CLI::App& command, Lists& lists) {
  for(const CLI::Option* option : command.get_options())
    if(option->get_delimiter() == ',')
      for(const std::string& name : option->get_lnames())
        lists.emplace("--" + name, option);
  for(const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; }))
    collect(*sub, lists);
}

// Appends what stands between commas; returns whether nothing is empty.
bool append_items(const std::string& text, std::vector<std::string>& items) {
  bool is_whole = true;
  for(const std::string& item : CLI::detail::split(text, ',')) {
    is_whole = is_whole && !item.empty();
    if(!item.empty())
      items.push_back(item);
  }
  return is_whole && !boost::algorithm::ends_with(text, ",");
}

bool is_number(const std::string& word) {
  double number;
  return CLI::detail::lexical_cast(word.substr(0, word.find(':')), number);
}

// As in "TEXT:{weld,split}".
bool is_one_of(const std::string& word, const CLI::Option& option) {
  std::string words = option.get_type_name();
  for(char& c : words)
    if(c == '{' || c == '}')
      c = ',';
  return words.find(',' + word + ',') != std::string::npos;
}

// Whether a word looks as if it were meant to go on with a list, and is no mesh.
bool goes_on(const std::string& word, const CLI::Option& option) {
  std::vector<std::string> items;
  append_items(word, items);
  std::error_code error;
  return !items.empty() && !std::filesystem::exists(path_of(word), error) &&
         (is_number(items.front()) || is_one_of(items.front(), option));
}

} // namespace

void write_out_size(std::vector<std::string>& arguments) {
  const std::string with_value = "--size=";
  for(std::size_t i = 0; i < arguments.size(); ++i) {
    std::string& word = arguments[i];
    const bool has_name = boost::algorithm::starts_with(word, with_value);
    if((has_name || (i > 0 && arguments[i - 1] == "--size")) &&
       word.find_first_not_of("0123456789x", has_name ? with_value.size() : 0) == std::string::npos)
      std::replace(word.begin(), word.end(), 'x', ',');
  }
}

void check_lists(const CLI::App& tool, const std::vector<std::string>& arguments) {
  Lists lists;
  collect(tool, lists);
  for(std::size_t i = 0; i < arguments.size(); ++i) {
    const std::size_t equals = arguments[i].find('=');
    const auto list = lists.find(arguments[i].substr(0, equals));
    if(list == lists.end() || (equals == std::string::npos && i + 1 == arguments.size()))
      continue;
    const std::string begin =
        equals == std::string::npos ? arguments[++i] : arguments[i].substr(equals + 1);
    std::string written = begin;
    std::vector<std::string> items;
    bool is_list = append_items(begin, items);
    for(; i + 1 < arguments.size() && goes_on(arguments[i + 1], *list->second); ++i) {
      is_list = false;
      append_items(arguments[i + 1], items);
      written += " " + arguments[i + 1];
    }
    if(!is_list)
      throw wrong_usage(list->first + " " + printable(written) +
                        ": the items of a list are separated by commas, without blanks: " +
                        list->first + " " + printable(boost::algorithm::join(items, ",")));
  }
}

} // namespace htloops
