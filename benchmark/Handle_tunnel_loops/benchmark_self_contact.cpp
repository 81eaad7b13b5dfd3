// The package's test whether a surface touches itself, beside
// CGAL::Polygon_mesh_processing::does_self_intersect(), in one thread.
//
//   benchmark_self_contact [-n RUNS] [KIND:FACES:GENUS | FILE]...
//
// Seconds are of the processor, medians of the runs; bytes are the peak of allocated memory beyond
// the mesh. Ends with an error if the two do not agree. Faces without area are touching for both.

#include "Counting_allocation.h"
#include "Stages_of_loops.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/self_contact.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/property_map.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Measured
{
  bool answer = false;
  double seconds = 0., bytes = 0.;
};

template <typename Test> Measured measured(const Test& test, int number_of_runs) {
  Measured m;
  std::vector<double> seconds;
  for(int run = 0; run < number_of_runs; ++run) {
    const std::clock_t began = std::clock();
    m.answer = test();
    seconds.push_back(double(std::clock() - began) / CLOCKS_PER_SEC);
  }
  m.seconds = median(seconds);
  m.bytes = double(counting_allocation::peak_bytes([&] { test(); }));
  return m;
}

void compare(const std::string& input, int number_of_runs) {
  const Off_file off(input);
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(off.name(), mesh))
    throw std::runtime_error("cannot read " + off.name());
  const auto ours = [&] {
    return HTL::internal::touches_itself(HTL::internal::Execution(), mesh,
                                         get(CGAL::vertex_point, mesh),
                                         get(boost::vertex_index, mesh));
  };
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point =
      CGAL::make_cartesian_converter_property_map<Kernel::Point_3>(get(CGAL::vertex_point, mesh));
  const auto theirs = [&] {
    return CGAL::Polygon_mesh_processing::does_self_intersect(
        mesh, CGAL::parameters::vertex_point_map(point).geom_traits(Kernel()));
  };
  const Measured a = measured(ours, number_of_runs), b = measured(theirs, number_of_runs);
  const double faces = double(mesh.number_of_faces());
  std::printf("| %s | %.0f | %s | %.4f | %.4f | **%.2f** | %.0f | %.0f |\n", input.c_str(), faces,
              a.answer ? "yes" : "no", a.seconds, b.seconds, a.seconds / b.seconds, a.bytes / faces,
              b.bytes / faces);
  std::fflush(stdout);
  if(a.answer != b.answer)
    throw std::runtime_error("they do not agree");
}

} // namespace

int main(int argc, char* argv[]) {
  const Requested_runs runs(argc, argv, 3,
                            {"torus:10000:1", "torus:200000:1", "multi-torus:200000:50",
                             "gyroid:200000:50", "lattice:200000:50", "sponge:200000:50"});
  try {
    std::printf("| mesh | faces | touches itself | s | PMP s | ratio | bytes per face | PMP bytes "
                "per face |\n|---|---|---|---|---|---|---|---|\n");
    for(const std::string& input : runs.inputs)
      compare(input, runs.number);
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
