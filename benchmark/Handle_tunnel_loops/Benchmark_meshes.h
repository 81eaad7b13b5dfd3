#ifndef BENCHMARK_MESHES_H
#define BENCHMARK_MESHES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include "Requested_soup.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file Benchmark_meshes.h
/// What the benchmarks are run on: files, and generated meshes, all as OFF files.

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

inline double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// What a benchmark of some meshes is told: -n RUNS, and the meshes.
struct Requested_runs
{
  Requested_runs(int argc,
                 char* argv[],
                 int runs_if_not_said,
                 std::vector<std::string> usual_inputs)
      : number(runs_if_not_said) {
    for(int i = 1; i < argc; ++i)
      if(std::string(argv[i]) == "-n" && i + 1 < argc)
        number = (std::max)(1, std::atoi(argv[++i]));
      else
        inputs.push_back(argv[i]);
    if(inputs.empty())
      inputs = std::move(usual_inputs);
  }

  int number;
  std::vector<std::string> inputs;
};

inline void write_off(const CGAL::Handle_tunnel_loops::generators::Soup& soup,
                      const std::string& file) {
  std::FILE* f = std::fopen(file.c_str(), "w");
  if(f == nullptr)
    throw std::runtime_error("cannot write " + file);
  std::fprintf(f, "OFF\n%zu %zu 0\n", soup.points.size(), soup.triangles.size());
  for(const auto& p : soup.points)
    std::fprintf(f, "%.9g %.9g %.9g\n", p[0], p[1], p[2]);
  for(const auto& t : soup.triangles)
    std::fprintf(f, "3 %u %u %u\n", t[0], t[1], t[2]);
  std::fclose(f);
}

// Writes the mesh as an OFF file, unless it is one; returns the name of the file.
inline std::string as_off(const std::string& input, const std::string& scratch) {
  const std::size_t dot = input.rfind('.');
  if(dot != std::string::npos && input.substr(dot) == ".off")
    return input;
  if(!std::filesystem::exists(input)) {
    write_off(generate(input), scratch);
    return scratch;
  }
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(input, mesh) ||
     !CGAL::IO::write_polygon_mesh(scratch, mesh, CGAL::parameters::stream_precision(9)))
    throw std::runtime_error("cannot read " + input);
  return scratch;
}

/// An OFF file of a mesh that is given as KIND:FACES:GENUS[:HOLES[:FACES OF EACH[:ragged]]] or as a
/// file of any format; made for the
/// lifetime of the object if it is not there.
class Off_file
{
public:
  explicit Off_file(const std::string& input)
      : scratch_((std::filesystem::temp_directory_path() / "benchmark_mesh.off").string())
      , name_(as_off(input, scratch_)) {}

  ~Off_file() { std::filesystem::remove(scratch_); }
  Off_file(const Off_file&) = delete;
  Off_file& operator=(const Off_file&) = delete;

  const std::string& name() const { return name_; }

private:
  std::string scratch_, name_;
};

#endif // BENCHMARK_MESHES_H
