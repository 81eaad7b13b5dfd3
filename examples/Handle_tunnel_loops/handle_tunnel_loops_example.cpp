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
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh) ||
     !CGAL::is_closed(mesh))
  {
    std::cerr << filename << " is not a closed triangle mesh." << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));

  std::cout << pairs.size() << " pairs of loops" << std::endl;
  for(const auto& pair : pairs)
    std::cout << "  handle loop of length " << pair.handle().length() << ", tunnel loop of length "
              << pair.tunnel().length() << std::endl;

  return EXIT_SUCCESS;
}
