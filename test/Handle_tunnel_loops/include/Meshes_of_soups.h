#ifndef HTL_TEST_MESHES_OF_SOUPS_H
#define HTL_TEST_MESHES_OF_SOUPS_H

#include "Generated_soups.h"

#include <CGAL/Handle_tunnel_loops/Triangle_arrays.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/handle_tunnel_loops.h>

#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Pairs = std::vector<CGAL::Handle_tunnel_pair<Mesh>>;

template <typename TriangleMesh> void build(const Soup& soup, TriangleMesh& mesh) {
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  const auto point = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<decltype(point)>::value_type;
  std::vector<typename Graph_traits::vertex_descriptor> vertices;
  for(const auto& [x, y, z] : soup.points) {
    vertices.push_back(add_vertex(mesh));
    put(point, vertices.back(), Point(x, y, z));
  }
  for(const auto& [a, b, c] : soup.triangles) {
    const std::array face = {vertices[a], vertices[b], vertices[c]};
    if(CGAL::Euler::add_face(face, mesh) == Graph_traits::null_face())
      throw std::logic_error("the soup is not a mesh");
  }
}

template <typename Point>
void build(const Soup& soup, CGAL::Handle_tunnel_loops::Triangle_arrays<Point>& mesh) {
  std::vector<Point> points;
  for(const auto& [x, y, z] : soup.points)
    points.emplace_back(x, y, z);
  mesh = {std::move(points), soup.triangles};
}

// Vertex i of the mesh is point i of the soup, in the order of vertices(mesh).
template <typename TriangleMesh> TriangleMesh mesh_of(const Soup& soup) {
  TriangleMesh mesh;
  build(soup, mesh);
  return mesh;
}

template <typename TriangleMesh> TriangleMesh mesh_of(const Recipe& recipe) {
  return mesh_of<TriangleMesh>(soup_of(recipe));
}

inline Mesh mesh_of(const Soup& soup) { return mesh_of<Mesh>(soup); }
inline Mesh mesh_of(const Recipe& recipe) { return mesh_of(soup_of(recipe)); }

template <typename TriangleMesh> auto find_loops(const TriangleMesh& mesh) {
  std::vector<CGAL::Handle_tunnel_pair<TriangleMesh>> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
  return pairs;
}

template <typename TriangleMesh, typename NamedParameters>
auto find_loops(const TriangleMesh& mesh, const NamedParameters& np) {
  std::vector<CGAL::Handle_tunnel_pair<TriangleMesh>> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs), np);
  return pairs;
}

template <typename AnyPairs> double total_length(const AnyPairs& pairs) {
  double sum = 0.;
  for(const auto& pair : pairs)
    sum += pair.handle().length() + pair.tunnel().length();
  return sum;
}

#endif // HTL_TEST_MESHES_OF_SOUPS_H
