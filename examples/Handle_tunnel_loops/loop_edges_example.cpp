// Marks the edges of all handle and tunnel loops, and uses them as barriers: they divide the faces
// into connected pieces.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Handle_tunnel_loops/loops_as_edges.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/handle_tunnel_loops.h>

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

  // One loop as a closed walk: each halfedge begins where the previous one ends.
  for(const auto& pair : pairs) {
    std::vector<Mesh::Halfedge_index> walk;
    CGAL::loop_to_halfedges(pair.handle(), mesh, std::back_inserter(walk));
    std::cout << "a handle loop of length " << pair.handle().length() << " along " << walk.size()
              << " edges\n";
  }

  // All loops as edge marks, which other functions accept.
  const auto is_on_loop = mesh.add_property_map<Mesh::Edge_index, bool>("e:loop", false).first;
  CGAL::mark_loop_edges(pairs, mesh, is_on_loop);
  const auto piece = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:piece", 0).first;
  std::cout << CGAL::Polygon_mesh_processing::connected_components(
                   mesh, piece, CGAL::parameters::edge_is_constrained_map(is_on_loop))
            << " pieces\n";
  return EXIT_SUCCESS;
}
