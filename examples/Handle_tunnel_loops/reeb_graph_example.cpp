#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/reeb_graph.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Graph = CGAL::Reeb_graph<Mesh>;
namespace params = CGAL::parameters;

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/triple_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << filename << " is not a triangle mesh." << std::endl;
    return EXIT_FAILURE;
  }

  // The arc of each vertex gives a segmentation of the mesh.
  auto arc_of_vertex = mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:arc", 0).first;
  Graph graph;
  CGAL::reeb_graph(mesh, graph, params::vertex_arc_map(arc_of_vertex));

  std::cout << num_vertices(graph) << " nodes, " << num_edges(graph) << " arcs" << std::endl;
  std::ofstream polylines("reeb.polylines.txt");
  for(const Graph::edge_descriptor e : CGAL::make_range(edges(graph))) {
    std::cout << "arc " << graph[e].index << " from node " << source(e, graph) << " to node "
              << target(e, graph) << " with " << graph[e].vertices.size() << " vertices"
              << std::endl;
    polylines << graph[e].polyline.size();
    for(const Kernel::Point_3& p : graph[e].polyline)
      polylines << ' ' << p;
    polylines << '\n';
  }
  return EXIT_SUCCESS;
}
