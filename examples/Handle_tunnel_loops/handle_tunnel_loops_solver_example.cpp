#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Handle_tunnel_loops_solver.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Pairs = std::vector<CGAL::Handle_tunnel_pair<Mesh>>;

double total_length(const Pairs& pairs) {
  double sum = 0.;
  for(const auto& pair : pairs)
    sum += pair.handle().length() + pair.tunnel().length();
  return sum;
}

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/triple_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Checks and prepares the mesh once, then finds loops from several seeds.
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  std::cout << "genus " << solver.genus() << std::endl;

  Pairs best;
  const std::size_t number_of_seeds = 5;
  for(std::size_t i = 0; i < number_of_seeds; ++i) {
    const Mesh::Vertex_index seed(
        static_cast<Mesh::size_type>(i * num_vertices(mesh) / number_of_seeds));
    Pairs pairs;
    solver.find_loops(std::back_inserter(pairs), CGAL::parameters::seed_vertex(seed));
    std::cout << "seed " << seed << ": total length " << total_length(pairs) << " in "
              << solver.statistics().total_seconds() << " s" << std::endl;
    if(best.empty() || total_length(pairs) < total_length(best))
      best = std::move(pairs);
  }
  std::cout << "the shortest loops have a total length of " << total_length(best) << std::endl;
  return EXIT_SUCCESS;
}
