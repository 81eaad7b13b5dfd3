// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/file_options.h"

#include "failure.h"
#include "write/atomic_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace htloops {
namespace {

namespace fs = std::filesystem;

struct Named_file
{
  std::string option;
  std::string name;
};

using Named_files = std::vector<Named_file>;

void collect(const CLI::App& command, const char* type, Named_files& files) {
  for(const CLI::Option* option : command.get_options())
    if(option->get_type_name() == type)
      for(const std::string& name : option->results())
        files.push_back({option->get_name(), name});
  for(const CLI::App* subcommand : command.get_subcommands())
    collect(*subcommand, type, files);
}

std::string path_of_input(const std::string& name) { return name == "-" ? "/dev/stdin" : name; }
std::string path_of_output(const std::string& name) { return name == "-" ? "/dev/stdout" : name; }

// Of two files that do not exist yet, where they would be tells. A device is not overwritten: a
// terminal may be read from and written to.
bool is_same_file(const std::string& name, const std::string& other) {
  std::error_code error;
  if(name == other)
    return true;
  if(fs::is_character_file(name, error))
    return false;
  return fs::equivalent(name, other, error) || destination_of(name) == destination_of(other);
}

void check_differ(const Named_file& file, const std::string& path, const Named_file& output) {
  if(is_same_file(path, path_of_output(output.name)))
    throw Failure(Exit_code::WRONG_USAGE, file.option + " " + file.name + " and " + output.option +
                                              " " + output.name +
                                              " name the same file, which would be overwritten");
}

// As of a variable of the shell that is not set.
void check_has_name(const Named_file& file) {
  if(file.name.empty())
    throw Failure(Exit_code::WRONG_USAGE, file.option + ": the name of the file is empty");
}

// As what follows -o in "-o -q".
void check_is_no_option(const Named_file& output) {
  if(output.name.size() > 1 && output.name.front() == '-')
    throw Failure(Exit_code::WRONG_USAGE, output.option + " " + output.name +
                                              " looks like two options; a file of that name is ./" +
                                              output.name);
}

} // namespace

void check_files(const CLI::App& app) {
  Named_files inputs, outputs;
  collect(app, input_file, inputs);
  collect(app, output_file, outputs);
  for(const Named_files* files : {&inputs, &outputs})
    std::for_each(files->begin(), files->end(), check_has_name);
  for(auto output = outputs.begin(); output != outputs.end(); ++output) {
    for(const Named_file& input : inputs)
      check_differ(input, path_of_input(input.name), *output);
    for(auto other = outputs.begin(); other != output; ++other)
      check_differ(*other, path_of_output(other->name), *output);
    check_is_no_option(*output);
    check_writable(output->name);
  }
}

} // namespace htloops
