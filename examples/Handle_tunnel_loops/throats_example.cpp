// Lists all narrow places of a surface, the most prominent first.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/handle_tunnel_loops.h>
#include <CGAL/throats.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/triple_torus.off", mesh)) {
    std::cerr << "the mesh cannot be read\n";
    return EXIT_FAILURE;
  }
  std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
  std::vector<CGAL::Handle_tunnel_loops::Throat<Mesh>> throats;
  CGAL::throats(mesh, pairs, std::back_inserter(throats));
  for(const auto& throat : throats) {
    std::cout << "diameter " << throat.diameter() << ", prominence " << throat.prominence;
    if(throat.pair)
      std::cout << ", as a loop of pair " << *throat.pair;
    else if(throat.is_separating)
      std::cout << ", cuts the surface in two";
    std::cout << '\n';
  }
  return EXIT_SUCCESS;
}
