// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/mesh_list.h"

#include "read/meshes/mesh_formats.h"
#include "read/patterns.h"
#include "system/files.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

namespace htloops {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& word) {
  std::error_code error;
  return fs::is_directory(path_of(word), error);
}

// Not of folders in it. What cannot be looked into has none.
std::vector<std::string> meshes_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for(fs::directory_iterator file(path_of(folder), error), end; !error && file != end;
      file.increment(error))
    if(is_named_as_mesh(name_of_path(file->path())) && !file->is_directory(error))
      files.push_back(name_of_path(file->path()));
  std::sort(files.begin(), files.end());
  return files;
}

bool is_pattern_of_files(const std::string& word) {
  std::error_code error;
  return is_pattern(word) && !fs::exists(path_of(word), error);
}

std::vector<std::string> fitting(const std::string& pattern) {
  std::vector<std::string> files = names_fitting(pattern);
  files.erase(std::remove_if(files.begin(), files.end(), is_folder), files.end());
  return files;
}

} // namespace

std::vector<std::string> files_of(const std::string& word) {
  std::vector<std::string> files;
  if(is_folder(word))
    files = meshes_in(word);
  else if(is_pattern_of_files(word))
    files = fitting(word);
  return files.empty() ? std::vector<std::string>{word} : files;
}

std::vector<std::string> files_of(const std::vector<std::string>& words) {
  std::vector<std::string> files;
  std::set<std::string> known;
  for(const std::string& word : words)
    for(const std::string& file : files_of(word))
      if(known.insert(file).second)
        files.push_back(file);
  return files;
}

bool may_be_many(const std::vector<std::string>& words) {
  return words.size() > 1 || is_folder(words.front()) || is_pattern_of_files(words.front());
}

} // namespace htloops
