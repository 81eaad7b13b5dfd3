// Does not compile: the tag asks for a device, and the program is not linked with the library.
#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/reeb_graph.h>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void find_graph(const Mesh& mesh, CGAL::Reeb_graph<Mesh>& graph) {
  CGAL::reeb_graph<CGAL::Cuda_tag>(mesh, graph);
}
