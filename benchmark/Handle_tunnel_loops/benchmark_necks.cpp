// Measures the search for necks, with the preparation of the mesh, as a multiple of the time that
// CGAL::IO::read_polygon_mesh takes for the same mesh as an OFF file, in one run, and the memory
// that it takes beyond the mesh.
//
//   benchmark_necks [-n RUNS] [-l LENGTH] [KIND:FACES:GENUS | FILE]...
//
// The length is in hundredths of the diagonal of the bounding box. Without arguments: generated
// meshes. Each figure is the median of the runs.

#include "Benchmark_meshes.h"
#include "Counting_allocation.h"

#include <CGAL/Handle_tunnel_loops/internal/reeb/find_necks.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace HTL = CGAL::Handle_tunnel_loops;

namespace {

double diagonal(const Mesh& mesh) {
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

std::size_t find_necks(const Mesh& mesh, double length) {
  constexpr double share = 0.05;
  return HTL::internal::find_necks(HTL::internal::execution_of<CGAL::Parallel_if_available_tag>(),
                                   mesh, mesh.points(), get(boost::vertex_index, mesh),
                                   CGAL::Simple_cartesian<double>(), length / 100. * diagonal(mesh),
                                   share)
      .size();
}

void measure(const std::string& input, int number_of_runs, double length) {
  const Off_file off(input);
  std::vector<double> reading, finding, ratio;
  std::size_t necks = 0, faces = 0;
  double bytes = 0.;
  for(int run = 0; run < number_of_runs; ++run) {
    Mesh mesh;
    const double t0 = seconds_now();
    if(!CGAL::IO::read_polygon_mesh(off.name(), mesh))
      throw std::runtime_error("cannot read " + off.name());
    const double t1 = seconds_now();
    necks = find_necks(mesh, length);
    const double t2 = seconds_now();
    faces = mesh.number_of_faces();
    if(run == 0)
      bytes = double(counting_allocation::peak_bytes([&] { find_necks(mesh, length); }));
    reading.push_back(t1 - t0);
    finding.push_back(t2 - t1);
    ratio.push_back((t2 - t1) / (t1 - t0));
  }
  std::printf("| %s | %zu | %zu | %.2f | %.2f | **%.2f** | %.0f |\n", input.c_str(), faces, necks,
              median(reading), median(finding), median(ratio), bytes / double(faces));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[]) {
  int number_of_runs = 3;
  double length = 2.;
  std::vector<std::string> inputs;
  for(int i = 1; i < argc; ++i)
    if(std::string(argv[i]) == "-n" && i + 1 < argc)
      number_of_runs = (std::max)(1, std::atoi(argv[++i]));
    else if(std::string(argv[i]) == "-l" && i + 1 < argc)
      length = std::atof(argv[++i]);
    else
      inputs.push_back(argv[i]);
  if(inputs.empty())
    inputs = {"twins:1000000:0", "twins:1000000:3",  "hollow:1000000:0",   "hollow:1000000:3",
              "scan:1000000:3",  "sphere:1000000:0", "gyroid:1000000:250", "sponge:1000000:250"};
  try {
    std::printf("| mesh | faces | necks | reading s | finding s | ratio | bytes per face |\n"
                "|---|---|---|---|---|---|---|\n");
    for(const std::string& input : inputs)
      measure(input, number_of_runs, length);
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
