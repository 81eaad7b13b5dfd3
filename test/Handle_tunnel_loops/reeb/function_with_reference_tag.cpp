// Does not compile: the graph of a given function has no field that the reference could compute.
#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/reeb_graph_of_function.h>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void find_graph(const Mesh& mesh, Mesh::Property_map<Mesh::Vertex_index, double> function) {
  CGAL::Reeb_graph<Mesh> graph;
  CGAL::reeb_graph_of_function<CGAL::Reference_tag>(mesh, function, graph);
}
