// Cuts open a part with five holes and unfolds it into the plane.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/cut_to_disk.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Edge_marks = Mesh::Property_map<Mesh::Edge_index, bool>;
using Vertex_marks = Mesh::Property_map<Mesh::Vertex_index, bool>;
using Seam_mesh = CGAL::Seam_mesh<Mesh, Edge_marks, Vertex_marks>;

namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/drilled_part.off", mesh)) {
    std::cerr << "the mesh cannot be read\n";
    return EXIT_FAILURE;
  }
  std::vector<Mesh::Edge_index> cut;
  CGAL::cut_to_disk(mesh, std::back_inserter(cut));

  // The same mesh, with one vertex for each side of the cut.
  Seam_mesh disk(mesh, mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first,
                 mesh.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first);
  CGAL::add_seams_of_cut(disk, cut);
  std::cout << num_vertices(mesh) << " vertices, and cut along " << cut.size() << " edges "
            << num_vertices(disk) << '\n';

  using Border = SMP::Two_vertices_parameterizer_3<Seam_mesh>;
  using Parameterizer = SMP::LSCM_parameterizer_3<Seam_mesh, Border>;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(disk).first;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const SMP::Error_code error = SMP::parameterize(disk, Parameterizer(), border, uv);
  if(error != SMP::OK) {
    std::cerr << SMP::get_error_message(error) << '\n';
    return EXIT_FAILURE;
  }
  std::ofstream out("part_in_the_plane.off");
  SMP::IO::output_uvmap_to_off(disk, border, uv, out);
  return EXIT_SUCCESS;
}
