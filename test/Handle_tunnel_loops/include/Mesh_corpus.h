#ifndef HTL_TEST_MESH_CORPUS_H
#define HTL_TEST_MESH_CORPUS_H

#include "Number_of_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

// The folder of test meshes, which are not part of the package: HTL_MESHES, or else shared/meshes
// beside the checkout. It may be absent.
inline std::filesystem::path mesh_corpus() {
  if(const char* folder = std::getenv("HTL_MESHES"))
    return folder;
  const std::filesystem::path tests = std::filesystem::path(__FILE__).parent_path().parent_path();
  return (tests / "../../../shared/meshes").lexically_normal();
}

// The closed meshes, in the order of their names.
inline std::vector<std::filesystem::path> files_of_corpus() {
  std::vector<std::filesystem::path> files;
  for(const char* folder : {"closed", "sphere_like"})
    if(std::filesystem::is_directory(mesh_corpus() / folder))
      for(const auto& entry : std::filesystem::directory_iterator(mesh_corpus() / folder))
        files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return enough_of(files);
}

// For the names of tests.
inline std::string name_of_file(const testing::TestParamInfo<std::filesystem::path>& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

#endif // HTL_TEST_MESH_CORPUS_H
