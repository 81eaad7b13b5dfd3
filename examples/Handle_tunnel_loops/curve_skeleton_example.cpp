#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/curve_skeleton.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Skeleton = CGAL::Curve_skeleton<Mesh>;

// Receives the points along each arc, one after the other.
struct Print_arcs
{
  const Skeleton& skeleton;
  std::vector<Skeleton::vertex_descriptor> arc;

  void start_new_polyline() { arc.clear(); }
  void add_node(Skeleton::vertex_descriptor v) { arc.push_back(v); }
  void end_polyline() {
    double length = 0.;
    double smallest_radius = skeleton[arc.front()].radius;
    for(std::size_t i = 1; i < arc.size(); ++i) {
      length +=
          std::sqrt(CGAL::squared_distance(skeleton[arc[i - 1]].point, skeleton[arc[i]].point));
      smallest_radius = (std::min)(smallest_radius, skeleton[arc[i]].radius);
    }
    std::cout << "arc from " << arc.front() << " to " << arc.back() << ": length " << length
              << ", smallest radius " << smallest_radius << std::endl;
  }
};

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/triple_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << filename << " is not a triangle mesh." << std::endl;
    return EXIT_FAILURE;
  }

  Skeleton skeleton;
  const auto statistics = CGAL::curve_skeleton(mesh, skeleton);

  Print_arcs print{skeleton, {}};
  CGAL::split_graph_into_polylines(skeleton, print);

  const auto& certificate = statistics.certificate;
  if(!certificate) {
    std::cout << "not certified: " << certificate.failure << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "certified: connected, inside, embedded, and its cycles are a basis, "
            << statistics.genus << " in all" << std::endl;
  return EXIT_SUCCESS;
}
