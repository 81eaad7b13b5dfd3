// Measures the whole computation (all passes, classification and certificate) as a multiple of the
// time that CGAL::IO::read_polygon_mesh takes for the same mesh as an OFF file, in one run, and the
// memory that it takes beyond the mesh.
//
//   benchmark_against_reading [-n RUNS] [KIND:FACES:GENUS | FILE]...
//
// Without arguments: the suite of the README, on generated meshes. Each figure is the median of the
// runs.

#include "Counting_allocation.h"
#include "Stages_of_loops.h"

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

void measure(const std::string& input, int number_of_runs) {
  const Off_file off(input);
  const std::string& file = off.name();
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
    statistics = find_loops<CGAL::Parallel_if_available_tag>(mesh);
    const double t3 = seconds_now();
    if(run == 0)
      bytes = double(counting_allocation::peak_bytes(
          [&] { find_loops<CGAL::Parallel_if_available_tag>(mesh); }));
    reading.push_back(t1 - t0);
    total.push_back(t3 - t2);
    ratio.push_back((t3 - t2) / (t1 - t0));
    for(std::size_t i = 0; i < HTL::number_of_stages; ++i)
      stages[i].push_back(statistics.seconds[i]);
  }
  std::printf("| %s | %zu | %zu | %.2f | %.2f | **%.2f** | %.0f |", input.c_str(),
              statistics.number_of_faces, statistics.genus, median(reading), median(total),
              median(ratio), bytes / double(statistics.number_of_faces));
  for(std::size_t i = 0; i < number_of_stages_of_loops; ++i)
    std::printf(" %.3f |", median(stages[i]));
  std::printf("\n");
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[]) {
  const Requested_runs runs(argc, argv, 3,
                            {"torus:1000000:1", "multi-torus:1000000:50", "multi-torus:1000000:250",
                             "gyroid:1000000:250", "lattice:1000000:250", "gyroid:1700000:1500",
                             "lattice:1700000:1500", "sponge:1000000:250"});
  try {
    std::printf("| mesh | faces | genus | reading s | loops s | ratio | bytes per face |");
    print_stages_of_head(7);
    for(const std::string& input : runs.inputs)
      measure(input, runs.number);
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
