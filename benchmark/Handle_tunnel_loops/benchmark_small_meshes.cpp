// Measures many calls on small meshes in one process: seconds of one thread for a call, the stages,
// and how often a call allocates memory.
//
//   benchmark_small_meshes [-n CALLS] [KIND:FACES:GENUS | FILE]...

#include "Benchmark_meshes.h"
#include "Counting_allocation.h"

#include <CGAL/handle_tunnel_loops.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace HTL = CGAL::Handle_tunnel_loops;

namespace {

HTL::Statistics find_loops(const Mesh& mesh) {
  std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  solver.find_loops(std::back_inserter(pairs));
  return solver.statistics();
}

void measure(const std::string& input, int number_of_calls) {
  const Off_file off(input);
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(off.name(), mesh))
    throw std::runtime_error("cannot read " + off.name());
  const std::size_t allocations =
      counting_allocation::number_of_allocations([&] { find_loops(mesh); });
  HTL::Statistics statistics;
  std::vector<double> seconds, classes;
  for(int call = 0; call < number_of_calls; ++call) {
    const double begin = seconds_now();
    statistics = find_loops(mesh);
    seconds.push_back(seconds_now() - begin);
    classes.push_back(statistics.seconds_of(HTL::Stage::CLASSES));
  }
  std::printf("| %s | %zu | %zu | %.2f | %.2f | %zu |\n", input.c_str(), statistics.number_of_faces,
              statistics.genus, 1e3 * median(seconds), 1e3 * median(classes), allocations);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[]) {
  int number_of_calls = 2000;
  std::vector<std::string> inputs;
  for(int i = 1; i < argc; ++i)
    if(std::string(argv[i]) == "-n" && i + 1 < argc)
      number_of_calls = (std::max)(1, std::atoi(argv[++i]));
    else
      inputs.push_back(argv[i]);
  if(inputs.empty())
    inputs = {"torus:1000:1", "torus:3100:1", "multi-torus:4000:5", "gyroid:4000:5",
              "lattice:4000:5"};
  try {
    std::printf("| mesh | faces | genus | ms a call | of these classes | allocations |\n");
    std::printf("|---|---|---|---|---|---|\n");
    for(const std::string& input : inputs)
      measure(input, number_of_calls);
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
