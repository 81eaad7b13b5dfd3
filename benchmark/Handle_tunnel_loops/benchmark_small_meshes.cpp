// Measures many calls on small meshes in one process: seconds of one thread for a call, the stages,
// and how often a call allocates memory.
//
//   benchmark_small_meshes [-n CALLS] [KIND:FACES:GENUS | FILE]...

#include "Counting_allocation.h"
#include "Stages_of_loops.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

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
  const Requested_runs runs(
      argc, argv, 2000,
      {"torus:1000:1", "torus:3100:1", "multi-torus:4000:5", "gyroid:4000:5", "lattice:4000:5"});
  try {
    std::printf("| mesh | faces | genus | ms a call | of these classes | allocations |\n");
    std::printf("|---|---|---|---|---|---|\n");
    for(const std::string& input : runs.inputs)
      measure(input, runs.number);
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
