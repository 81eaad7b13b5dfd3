// Does not compile: the tag asks for a device, and the program is not linked with the library.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/handle_tunnel_loops.h>

void find_loops(const CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>& mesh) {
  CGAL::handle_tunnel_loops<CGAL::Cuda_tag>(mesh, CGAL::Emptyset_iterator());
}
