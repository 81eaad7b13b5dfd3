// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_COMMAND_LINE_H
#define BENCHMARK_COMMAND_LINE_H

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

/// \file Command_line.h
/// What a benchmark of many meshes is told.

namespace corpus {

/// The words of a command line: flags, options with a value, and files; a folder stands for the
/// files in it.
class Command_line
{
public:
  /// throws `std::invalid_argument` if an option is not one of those that are named.
  Command_line(int argc,
               char* argv[],
               const std::set<std::string>& flags,
               const std::set<std::string>& options) {
    for(int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if(flags.count(word) != 0)
        values_[word];
      else if(options.count(word) != 0 && i + 1 < argc)
        values_[word] = argv[++i];
      else if(word.rfind("--", 0) == 0)
        throw std::invalid_argument("no such option, or no value for it: " + word);
      else
        add(word);
    }
    std::sort(files_.begin(), files_.end());
  }

  bool has(const std::string& name) const { return values_.count(name) != 0; }

  std::string text(const std::string& name) const { return has(name) ? values_.at(name) : ""; }

  std::size_t number(const std::string& name, std::size_t otherwise) const {
    return has(name) ? std::stoul(values_.at(name)) : otherwise;
  }

  /// in the order of their names.
  const std::vector<std::filesystem::path>& files() const { return files_; }

private:
  void add(const std::filesystem::path& file) {
    if(!std::filesystem::is_directory(file))
      files_.push_back(file);
    else
      for(const auto& entry : std::filesystem::directory_iterator(file))
        files_.push_back(entry.path());
  }

  std::map<std::string, std::string> values_;
  std::vector<std::filesystem::path> files_;
};

} // namespace corpus

#endif // BENCHMARK_COMMAND_LINE_H
