#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/handle_tunnel_loops.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/triple_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));

  // Loops from any other source can be certified in the same way.
  const auto certificate = CGAL::certify_handle_tunnel_loops(mesh, pairs);
  if(!certificate) {
    std::cerr << certificate.failure << std::endl;
    return EXIT_FAILURE;
  }
  for(std::size_t i = 0; i < certificate.linking.size(); ++i) {
    const CGAL::Handle_tunnel_loops::Loop_linking& loop = certificate.linking[i];
    std::cout << (i % 2 == 0 ? "handle " : "tunnel ") << i / 2
              << (loop.bounds_inside()    ? " bounds inside;"
                  : loop.bounds_outside() ? " bounds outside;"
                                          : " bounds on neither side;");
    for(const auto& [other, number] : loop.row)
      std::cout << " linking number " << number << " with "
                << (other % 2 == 0 ? "handle " : "tunnel ") << other / 2 << " pushed outwards;";
    std::cout << std::endl;
  }
  return EXIT_SUCCESS;
}
