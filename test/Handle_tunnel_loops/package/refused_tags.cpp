// Does not compile: a tag asks for a device, and the program is not linked with the library;
// another asks the reference, which has no field for the graph of a given function.
#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#include <CGAL/reeb_graph_of_function.h>
#endif

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void find_loops(const Mesh& mesh) {
  CGAL::handle_tunnel_loops<CGAL::Cuda_tag>(mesh, CGAL::Emptyset_iterator());
}

#ifdef CGAL_EIGEN3_ENABLED
void find_graph(const Mesh& mesh, Mesh::Property_map<Mesh::Vertex_index, double> function) {
  CGAL::Reeb_graph<Mesh> graph;
  CGAL::reeb_graph_of_function<CGAL::Reference_tag>(mesh, function, graph);
}
#endif
