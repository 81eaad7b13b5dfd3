// Finds the loops of a torus given as an array of points and an array of triangles.

#include <CGAL/Handle_tunnel_loops/Triangle_arrays.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/handle_tunnel_loops.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Handle_tunnel_loops::Triangle_arrays<Point>;

int main() {
  constexpr int n = 40;
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const double u = 2. * CGAL_PI * i / n, v = 2. * CGAL_PI * j / n, r = 2. + std::cos(v);
      points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
      const int a = n * i + j, b = n * ((i + 1) % n) + j, c = n * ((i + 1) % n) + (j + 1) % n,
                d = n * i + (j + 1) % n;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }

  try {
    const Mesh mesh(std::move(points), triangles);
    std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
    CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
    for(const auto& pair : pairs) {
      std::cout << "handle loop of length " << pair.handle().length() << " past the triangles";
      for(const auto& step : pair.handle().steps())
        std::cout << ' ' << mesh.face(step.halfedge);
      std::cout << "\ntunnel loop of length " << pair.tunnel().length() << '\n';
    }
  } catch(const CGAL::Handle_tunnel_loops::Invalid_mesh_exception& e) {
    std::cerr << "the triangles are no surface: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
