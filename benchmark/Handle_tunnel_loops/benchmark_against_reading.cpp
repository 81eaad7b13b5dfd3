// Measures the whole computation (all passes, classification and certificate) as a multiple of the
// time that CGAL::IO::read_polygon_mesh takes for the same mesh as an OFF file, in one run, and the
// memory that it takes beyond the mesh.
//
//   benchmark_against_reading [-n RUNS] [KIND:FACES:GENUS | FILE]...
//
// Without arguments: the suite of the README, on generated meshes. Each figure is the median of the
// runs.

#include "Counting_allocation.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/handle_tunnel_loops.h>

#include "generators/generators.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Pair = CGAL::Handle_tunnel_pair<Mesh>;
namespace HTL = CGAL::Handle_tunnel_loops;

namespace {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void write_off(const HTL::generators::Soup& soup, const std::string& file) {
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

HTL::generators::Soup generate(const std::string& request) {
  std::istringstream in(request);
  std::string name, faces, genus;
  std::getline(in, name, ':');
  std::getline(in, faces, ':');
  std::getline(in, genus, ':');
  for(const auto& kind : HTL::generators::kinds())
    if(kind.name == name) {
      HTL::generators::Request r;
      r.faces = std::stoul(faces);
      r.genus = std::stoul(genus);
      return kind.make(r);
    }
  throw std::runtime_error("no such kind of mesh: " + name);
}

// The mesh as an OFF file, whatever it was.
std::string as_off(const std::string& input, const std::string& scratch) {
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

HTL::Statistics find_loops(const Mesh& mesh) {
  std::vector<Pair> pairs;
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(CGAL::Parallel_if_available_tag(), mesh,
                                                CGAL::parameters::default_values());
  solver.find_loops<CGAL::Parallel_if_available_tag>(std::back_inserter(pairs));
  return solver.statistics();
}

void measure(const std::string& input, int number_of_runs) {
  const std::string scratch =
      (std::filesystem::temp_directory_path() / "benchmark_against_reading.off").string();
  const std::string file = as_off(input, scratch);
  std::vector<double> reading, total, ratio;
  std::array<std::vector<double>, HTL::number_of_stages> stages;
  HTL::Statistics statistics;
  double bytes = 0.;
  for(int run = 0; run < number_of_runs; ++run) {
    Mesh mesh;
    const double t0 = seconds_now();
    if(!CGAL::IO::read_polygon_mesh(file, mesh))
      throw std::runtime_error("cannot read " + file);
    const double t1 = seconds_now();
    const double t2 = seconds_now();
    statistics = find_loops(mesh);
    const double t3 = seconds_now();
    if(run == 0)
      bytes = double(counting_allocation::peak_bytes([&] { find_loops(mesh); }));
    reading.push_back(t1 - t0);
    total.push_back(t3 - t2);
    ratio.push_back((t3 - t2) / (t1 - t0));
    for(std::size_t i = 0; i < HTL::number_of_stages; ++i)
      stages[i].push_back(statistics.seconds[i]);
  }
  std::printf("| %s | %zu | %zu | %.2f | %.2f | **%.2f** | %.0f |", input.c_str(),
              statistics.number_of_faces, statistics.genus, median(reading), median(total),
              median(ratio), bytes / double(statistics.number_of_faces));
  for(const auto& stage : stages)
    std::printf(" %.3f |", median(stage));
  std::printf("\n");
  std::fflush(stdout);
  std::filesystem::remove(scratch);
}

} // namespace

int main(int argc, char* argv[]) {
  int number_of_runs = 3;
  std::vector<std::string> inputs;
  for(int i = 1; i < argc; ++i)
    if(std::string(argv[i]) == "-n" && i + 1 < argc)
      number_of_runs = (std::max)(1, std::atoi(argv[++i]));
    else
      inputs.push_back(argv[i]);
  if(inputs.empty())
    inputs = {"torus:1000000:1",      "multi-torus:1000000:50", "multi-torus:1000000:250",
              "gyroid:1000000:250",   "lattice:1000000:250",    "gyroid:1700000:1500",
              "lattice:1700000:1500", "sponge:1000000:250"};
  try {
    std::printf("| mesh | faces | genus | reading s | loops s | ratio | bytes per face |");
    for(std::size_t i = 0; i < HTL::number_of_stages; ++i)
      std::printf(" %s |", HTL::stage_name(static_cast<HTL::Stage>(i)));
    std::printf("\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for(const std::string& input : inputs)
      measure(input, number_of_runs);
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
