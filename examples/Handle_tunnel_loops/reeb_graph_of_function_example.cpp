#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/reeb_graph_of_function.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Polyhedron_3<Kernel>;
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;
using Graph = CGAL::Reeb_graph<Mesh>;

// Counts the polylines into which the graph splits at its nodes with one or three arcs.
struct Polyline_counter
{
  std::size_t count = 0;

  void start_new_polyline() { ++count; }
  void add_node(Graph::vertex_descriptor) {}
  void end_polyline() {}
};

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/triple_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || !mesh.is_pure_triangle()) {
    std::cerr << filename << " is not a triangle mesh." << std::endl;
    return EXIT_FAILURE;
  }

  // The height in a direction; keeps all of its critical points.
  const auto height = boost::make_function_property_map<Vertex, double>(
      [](Vertex v) { return v->point().x() + 0.5 * v->point().y(); });
  Graph graph;
  CGAL::Handle_tunnel_loops::Reeb_options options;
  options.threshold = 0.;
  const auto statistics =
      CGAL::reeb_graph_of_function(mesh, height, graph, CGAL::parameters::reeb_options(options));

  Polyline_counter counter;
  CGAL::split_graph_into_polylines(graph, counter);
  std::cout << "genus " << statistics.genus << ", " << counter.count << " arcs" << std::endl;
  for(const Graph::vertex_descriptor v : CGAL::make_range(vertices(graph)))
    if(graph[v].type == CGAL::Reeb_node_type::SADDLE)
      std::cout << "saddle at height " << graph[v].value << std::endl;
  return EXIT_SUCCESS;
}
