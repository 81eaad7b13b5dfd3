#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/handle_measures.h>
#include <CGAL/handle_tunnel_loops.h>
#include <CGAL/removal_costs.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Pair = CGAL::Handle_tunnel_pair<Mesh>;
using Measures = CGAL::Handle_tunnel_loops::Handle_measures<Mesh::Point>;

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/triple_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << filename << " is not a triangle mesh." << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<Pair> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
  std::vector<Measures> measures;
  CGAL::handle_measures(mesh, pairs, std::back_inserter(measures));

  std::vector<CGAL::Handle_tunnel_loops::Removal_costs> costs;
  CGAL::removal_costs(mesh, pairs, std::back_inserter(costs));

  for(std::size_t i = 0; i < measures.size(); ++i) {
    std::cout << "handle " << i << ":";
    if(const auto& ball = measures[i].thickness)
      std::cout << " " << ball->diameter << " thick (+- " << ball->error << ")";
    if(const auto& ball = measures[i].clear_width)
      std::cout << ", its hole " << ball->diameter << " wide (+- " << ball->error
                << "), narrowest at " << ball->throat;
    if(const auto& cut = costs[i].cut)
      std::cout << "; a cut takes " << cut->volume << " away";
    std::cout << measures[i].why << std::endl;
  }
  return measures.size() == pairs.size() ? EXIT_SUCCESS : EXIT_FAILURE;
}
