// Measures the whole computation with 1, 2, 4, ... threads, stage by stage, and how many times as
// fast it is as with one.
//
//   benchmark_threads [-n RUNS] [KIND:FACES:GENUS | FILE]...
//
// Without arguments: generated meshes. Each figure is the median of the runs. More threads than
// there are processors are not asked for.

#include "Stages_of_loops.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// A line of the table; returns the seconds of the whole.
double measure(const std::string& name,
               const Mesh& mesh,
               int number_of_threads,
               int number_of_runs,
               double seconds_of_one_thread) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(number_of_threads));
  std::vector<double> total;
  std::array<std::vector<double>, number_of_stages_of_loops> stages;
  HTL::Statistics statistics;
  for(int run = 0; run < number_of_runs; ++run) {
    statistics = find_loops<CGAL::Parallel_tag>(mesh);
    total.push_back(statistics.total_seconds());
    for(std::size_t i = 0; i < stages.size(); ++i)
      stages[i].push_back(statistics.seconds[i]);
  }
  const double seconds = median(total);
  std::printf("| %s | %zu | %zu | %d | %.3f | **%.2f** |", name.c_str(), statistics.number_of_faces,
              statistics.genus, number_of_threads, seconds,
              number_of_threads == 1 ? 1. : seconds_of_one_thread / seconds);
  for(const std::vector<double>& seconds_of_stage : stages)
    std::printf(" %.3f |", median(seconds_of_stage));
  std::printf("\n");
  std::fflush(stdout);
  return seconds;
}

void measure(const std::string& input, int number_of_runs) {
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(Off_file(input).name(), mesh))
    throw std::runtime_error("cannot read " + input);
  const int most_threads = tbb::this_task_arena::max_concurrency();
  double seconds_of_one_thread = 0.;
  for(int threads = 1;; threads = (std::min)(2 * threads, most_threads)) {
    const double seconds = measure(input, mesh, threads, number_of_runs, seconds_of_one_thread);
    if(threads == 1)
      seconds_of_one_thread = seconds;
    if(threads >= most_threads)
      break;
  }
}

} // namespace

int main(int argc, char* argv[]) {
  const Requested_runs runs(argc, argv, 3,
                            {"torus:10000000:1", "lattice:10000000:3", "gyroid:1000000:250"});
  try {
    std::printf("| mesh | faces | genus | threads | loops s | over one thread |");
    print_stages_of_head(6);
    for(const std::string& input : runs.inputs)
      measure(input, runs.number);
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
