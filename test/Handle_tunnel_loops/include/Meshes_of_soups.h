#ifndef HTL_TEST_MESHES_OF_SOUPS_H
#define HTL_TEST_MESHES_OF_SOUPS_H

#include "Generated_soups.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/handle_tunnel_loops.h>

#include <array>
#include <iterator>
#include <stdexcept>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Pairs = std::vector<CGAL::Handle_tunnel_pair<Mesh>>;

// Vertex i of the mesh is point i of the soup, in the order of vertices(mesh).
template <typename TriangleMesh> TriangleMesh mesh_of(const Soup& soup) {
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  TriangleMesh mesh;
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
  return mesh;
}

inline Mesh mesh_of(const Soup& soup) { return mesh_of<Mesh>(soup); }
inline Mesh mesh_of(const Recipe& recipe) { return mesh_of(soup_of(recipe)); }

inline Pairs find_loops(const Mesh& mesh) {
  Pairs pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
  return pairs;
}

template <typename NamedParameters> Pairs find_loops(const Mesh& mesh, const NamedParameters& np) {
  Pairs pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs), np);
  return pairs;
}

inline double total_length(const Pairs& pairs) {
  double sum = 0.;
  for(const auto& pair : pairs)
    sum += pair.handle().length() + pair.tunnel().length();
  return sum;
}

#endif // HTL_TEST_MESHES_OF_SOUPS_H
