#ifndef HTL_TEST_MESH_CORPUS_H
#define HTL_TEST_MESH_CORPUS_H

#include <cstdlib>
#include <filesystem>

// The folder of test meshes, which are not part of the package: HTL_MESHES, or else shared/meshes
// beside the checkout. It may be absent.
inline std::filesystem::path mesh_corpus() {
  if(const char* folder = std::getenv("HTL_MESHES"))
    return folder;
  const std::filesystem::path tests = std::filesystem::path(__FILE__).parent_path().parent_path();
  return (tests / "../../../shared/meshes").lexically_normal();
}

#endif // HTL_TEST_MESH_CORPUS_H
