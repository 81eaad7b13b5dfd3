#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/handle_tunnel_loops.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace HTL = CGAL::Handle_tunnel_loops;
namespace params = CGAL::parameters;

// Receives the begin and the end of each stage.
struct Stage_printer : HTL::Default_visitor
{
  void start_stage(HTL::Stage stage) const { std::cout << HTL::stage_name(stage) << std::endl; }
};

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/triple_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Starts the front at the lowest vertex instead of the first one.
  const auto lowest =
      std::min_element(mesh.vertices_begin(), mesh.vertices_end(),
                       [&mesh](auto v, auto w) { return mesh.point(v).z() < mesh.point(w).z(); });

  double reached = 0.;
  const auto progress = [&reached](double fraction) {
    reached = fraction;
    return true; // false would stop the computation
  };

  std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
  try {
    CGAL::handle_tunnel_loops<CGAL::Parallel_if_available_tag>(
        mesh, std::back_inserter(pairs),
        params::seed_vertex(*lowest).callback(progress).visitor(Stage_printer()));
  } catch(const HTL::Invalid_mesh_exception& error) {
    std::cerr << filename << ": " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << pairs.size() << " pairs of loops, progress " << reached << std::endl;
  return EXIT_SUCCESS;
}
