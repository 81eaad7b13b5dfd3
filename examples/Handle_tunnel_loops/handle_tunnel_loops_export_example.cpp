#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/handle_tunnel_loops.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Pair = CGAL::Handle_tunnel_pair<Mesh>;

// One line per loop: the number of points, then the points, the first one again at the end.
void write_polyline(std::ostream& out, const Pair::Loop& loop) {
  out << loop.size() + 1;
  for(const auto& p : loop.points())
    out << "  " << p;
  out << "  " << loop.points().front() << '\n';
}

// A line element of an OBJ file; `first` is the number of the first point, counted from 1.
std::size_t write_obj_line(std::ostream& out, const Pair::Loop& loop, std::size_t first) {
  for(const auto& p : loop.points())
    out << "v " << p << '\n';
  out << 'l';
  for(std::size_t i = 0; i < loop.size(); ++i)
    out << ' ' << first + i;
  out << ' ' << first << '\n';
  return first + loop.size();
}

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/triple_torus.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  std::vector<Pair> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));

  std::ofstream polylines("loops.polylines.txt"), obj("loops.obj");
  polylines.precision(17);
  obj.precision(17);
  std::size_t next = 1;
  for(const Pair& pair : pairs)
    for(const Pair::Loop* loop : {&pair.handle(), &pair.tunnel()}) {
      write_polyline(polylines, *loop);
      next = write_obj_line(obj, *loop, next);
    }
  std::cout << "wrote loops.polylines.txt and loops.obj" << std::endl;
  return polylines && obj ? EXIT_SUCCESS : EXIT_FAILURE;
}
