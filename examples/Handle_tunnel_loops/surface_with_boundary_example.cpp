// A ring with holes in its wall: finds its loops, its boundary curves, and, for each loop of a
// basis, a cut that crosses it once. Multivalued potentials need such cuts.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boundary_loops.h>
#include <CGAL/dual_cuts.h>
#include <CGAL/handle_tunnel_loops.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/ring_with_holes.off", mesh)) {
    std::cerr << "the mesh cannot be read\n";
    return EXIT_FAILURE;
  }
  std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
  for(const auto& pair : pairs)
    std::cout << "handle loop of length " << pair.handle().length() << ", tunnel loop of length "
              << pair.tunnel().length() << '\n';

  std::vector<CGAL::Loop_on_surface<Mesh>> curves, waists;
  CGAL::boundary_loops(mesh, std::back_inserter(curves));
  CGAL::boundary_loops(
      mesh, std::back_inserter(waists),
      CGAL::parameters::basis_kind(CGAL::Handle_tunnel_loops::Basis_kind::SHORTEST));
  for(std::size_t i = 0; i < curves.size(); ++i)
    std::cout << "boundary curve of length " << curves[i].length()
              << ", beside it a loop of length " << waists[i].length() << '\n';

  // For the handle and the tunnel loop of each pair, then for all boundary curves except the last.
  std::vector<std::vector<std::pair<Mesh::Halfedge_index, std::int64_t>>> cuts;
  CGAL::dual_cuts(mesh, pairs, std::back_inserter(cuts));
  for(const auto& cut : cuts)
    std::cout << "a cut along " << cut.size() << " edges\n";
  return EXIT_SUCCESS;
}
