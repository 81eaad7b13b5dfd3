// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors
//
// replay FOLDER...: hands all files of these folders, which have the names of targets, to these, as
// a test, without a fuzzer.

#include "fuzz_target.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

int main(int argc, char** argv) {
  std::vector<std::filesystem::path> files;
  for(int i = 1; i < argc; ++i)
    for(const auto& entry : std::filesystem::directory_iterator(argv[i]))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for(const std::filesystem::path& file : files) {
    std::fprintf(stderr, "%s\n", file.string().c_str());
    std::ifstream in(file, std::ios::binary);
    fuzz(file.parent_path().filename().string(),
         std::string(std::istreambuf_iterator<char>(in), {}));
  }
  std::printf("%zu inputs\n", files.size());
  return files.empty() ? 1 : 0;
}
