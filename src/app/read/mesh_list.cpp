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

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#if __has_include(<glob.h>)
#include <glob.h>
#define HTLOOPS_HAS_GLOB
#endif

namespace htloops {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& word) {
  std::error_code error;
  return fs::is_directory(word, error);
}

// Not of folders in it. What cannot be looked into has none.
std::vector<std::string> meshes_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for(fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error))
    if(is_named_as_mesh(file->path().string()) && !file->is_directory(error))
      files.push_back(file->path().string());
  std::sort(files.begin(), files.end());
  return files;
}

bool is_pattern(const std::string& word) {
  std::error_code error;
  return word.find_first_of("*?[") != std::string::npos && !fs::exists(word, error);
}

std::vector<std::string> fitting(const std::string& pattern) {
  std::vector<std::string> files;
#ifdef HTLOOPS_HAS_GLOB
  glob_t found = {};
  if(glob(pattern.c_str(), 0, nullptr, &found) == 0)
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  files.erase(std::remove_if(files.begin(), files.end(), is_folder), files.end());
#else
  (void)pattern;
#endif
  return files;
}

} // namespace

std::vector<std::string> files_of(const std::string& word) {
  std::vector<std::string> files;
  if(is_folder(word))
    files = meshes_in(word);
  else if(is_pattern(word))
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
  return words.size() > 1 || is_folder(words.front()) || is_pattern(words.front());
}

} // namespace htloops
