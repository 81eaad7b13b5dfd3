// Removes the small handles of a mesh if that creates no new intersection, and prints what happened
// to each of them. New faces have their own color in the result.
//
//   remove_handles_example [mesh [maximal length [result.ply]]]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/remove_handles.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
namespace HTL = CGAL::Handle_tunnel_loops;

int main(int argc, char* argv[]) {
  const std::string file = argc > 1 ? argv[1] : "data/triple_torus.off";
  HTL::Removal_options options;
  if(argc > 2)
    options.maximal_length = std::atof(argv[2]);
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "Cannot read " << file << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<Mesh::Face_index> new_faces;
  const HTL::Removal_report report = CGAL::remove_handles(
      mesh, CGAL::parameters::removal_options(
                options, CGAL::parameters::face_output_iterator(std::back_inserter(new_faces))));

  for(const HTL::Removed_handle& handle : report.removed)
    std::cout << "pair " << handle.pair << ": "
              << (handle.by == HTL::Removal_way::CUT
                      ? "cut"
                      : (handle.by == HTL::Removal_way::FILL ? "filled" : "taken out whole"))
              << " along a loop of length " << handle.length << std::endl;
  for(const HTL::Refused_handle& handle : report.refused)
    std::cout << "pair " << handle.pair << " stays: " << handle.reason << std::endl;
  std::cout << "genus " << report.genus_before << " -> " << report.genus_after << ", "
            << new_faces.size() << " new faces" << std::endl;

  auto colour =
      mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color", CGAL::IO::gray()).first;
  for(const Mesh::Face_index f : new_faces)
    colour[f] = CGAL::IO::orange();
  mesh.collect_garbage();
  std::ofstream out(argc > 3 ? argv[3] : "without_handles.ply");
  return CGAL::IO::write_PLY(out, mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
