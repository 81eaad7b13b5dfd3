// Turns a polygon soup into a valid mesh. In the soup each polygon has its own points, one polygon
// is reversed, and one is a duplicate.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/handle_tunnel_loops.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[]) {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if(!CGAL::IO::read_polygon_soup(argc > 1 ? argv[1] : "data/ring_soup.off", points, polygons)) {
    std::cerr << "the soup cannot be read\n";
    return EXIT_FAILURE;
  }
  std::cout << points.size() << " points and " << polygons.size() << " polygons\n";

  // Merges equal points, and removes degenerate and duplicate polygons.
  PMP::repair_polygon_soup(points, polygons);
  // Reverses polygons until neighbors agree. Where more than two polygons meet in an edge, or the
  // surface is not orientable, it is cut open, and the function returns false.
  if(!PMP::orient_polygon_soup(points, polygons))
    std::cout << "the surface had to be cut open\n";

  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  PMP::triangulate_faces(mesh);
  std::cout << num_vertices(mesh) << " vertices and " << num_faces(mesh) << " triangles\n";

  std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
  try {
    CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
  } catch(const CGAL::Handle_tunnel_loops::Invalid_mesh_exception& e) {
    std::cerr << "the mesh is still unfit: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
  for(const auto& pair : pairs)
    std::cout << "handle loop of length " << pair.handle().length() << ", tunnel loop of length "
              << pair.tunnel().length() << '\n';
  return EXIT_SUCCESS;
}
