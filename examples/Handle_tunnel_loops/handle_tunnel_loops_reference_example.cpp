#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/handle_tunnel_loops.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;
using CGAL::Reference_tag;
using CGAL::Handle_tunnel_loops::Front_event;

// Watches the fronts of the initial pass.
int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/triple_torus.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << '\n';
    return EXIT_FAILURE;
  }
  Solver solver(mesh);
  std::vector<Solver::Pair> pairs;
  solver.find_loops<Reference_tag>(std::back_inserter(pairs));
  for(const Front_event& event : solver.statistics().front_events) {
    std::cout << "step " << event.step << ": " << front_event_name(event.type) << " at vertex "
              << event.vertex;
    for(const Front_event::Front& front : event.before)
      std::cout << ", layer " << front.layer << " of length " << front.length;
    std::cout << '\n';
  }
  std::cout << pairs.size() << " merges, hence pairs\n";
  return EXIT_SUCCESS;
}
