#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/handle_tunnel_loops.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Polyhedron_3<Kernel>;
using Pair = CGAL::Handle_tunnel_pair<Mesh>;

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/triple_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || !mesh.is_pure_triangle() || !mesh.is_closed())
  {
    std::cerr << filename << " is not a closed triangle mesh." << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<Pair> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));

  // Each step of a loop is a halfedge and a ratio along it.
  for(const Pair& pair : pairs) {
    std::cout << "tunnel loop with " << pair.tunnel().size() << " steps, first on the edges";
    for(std::size_t i = 0; i < 3 && i < pair.tunnel().size(); ++i) {
      const Pair::Loop::Step& step = pair.tunnel().steps()[i];
      std::cout << "  (" << step.halfedge->opposite()->vertex()->point() << ") -> ("
                << step.halfedge->vertex()->point() << ") at " << step.ratio;
    }
    std::cout << std::endl;
  }
  return EXIT_SUCCESS;
}
