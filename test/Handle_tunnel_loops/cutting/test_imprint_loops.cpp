// Loops that become edges: the mesh stays a closed manifold of triangles, and the walks are the
// loops.

#include "Loop_definitions.h"
#include "Meshes_of_soups.h"
#include "random_input.h"

#include <CGAL/Handle_tunnel_loops/loops_as_edges.h>
#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace test_imprint_loops {

using generators::Random;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;

template <typename TriangleMesh> long euler_characteristic(const TriangleMesh& tm) {
  return static_cast<long>(vertices(tm).size()) - static_cast<long>(edges(tm).size()) +
         static_cast<long>(faces(tm).size());
}

template <typename TriangleMesh> double area_of(const TriangleMesh& tm) {
  double sum = 0.;
  const auto point = get(CGAL::vertex_point, tm);
  for(const auto f : faces(tm)) {
    const auto h = halfedge(f, tm);
    sum += std::sqrt(CGAL::squared_area(get(point, source(h, tm)), get(point, target(h, tm)),
                                        get(point, target(next(h, tm), tm))));
  }
  return sum;
}

template <typename TriangleMesh>
double length_of(const TriangleMesh& tm, const Edge_walk<TriangleMesh>& walk) {
  double sum = 0.;
  const auto point = get(CGAL::vertex_point, tm);
  for(const auto h : walk)
    sum += distance(coordinates(get(point, source(h, tm))), coordinates(get(point, target(h, tm))));
  return sum;
}

template <typename TriangleMesh> void expect_imprint(TriangleMesh tm) {
  std::vector<CGAL::Handle_tunnel_pair<TriangleMesh>> pairs;
  CGAL::handle_tunnel_loops(tm, std::back_inserter(pairs));
  std::vector<Edge_walk<TriangleMesh>> beside;
  std::vector<double> lengths;
  for(const auto& pair : pairs)
    for(const auto* loop : {&pair.handle(), &pair.tunnel()}) {
      beside.push_back(walk_beside(tm, *loop));
      lengths.push_back(loop->length());
    }
  const Integer_matrix expected = intersection_matrix(tm, beside);
  const long characteristic = euler_characteristic(tm);
  const double area = area_of(tm);
  double rounding = 0.; // of a coordinate
  for(const auto v : vertices(tm))
    for(const double x : coordinates(get(get(CGAL::vertex_point, tm), v)))
      rounding = (std::max)(rounding, 1e-15 * std::abs(x));

  std::vector<Edge_walk<TriangleMesh>> walks;
  CGAL::imprint_loops(pairs, tm, std::back_inserter(walks));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(tm));
  EXPECT_TRUE(CGAL::is_closed(tm));
  EXPECT_TRUE(CGAL::is_triangle_mesh(tm));
  EXPECT_EQ(euler_characteristic(tm), characteristic);
  EXPECT_NEAR(area_of(tm), area, 1e-3 * area);
  ASSERT_EQ(walks.size(), lengths.size());
  for(std::size_t i = 0; i < walks.size(); ++i) {
    for(std::size_t k = 0; k < walks[i].size(); ++k)
      ASSERT_EQ(target(walks[i][k], tm), source(walks[i][(k + 1) % walks[i].size()], tm));
    EXPECT_NEAR(length_of(tm, walks[i]), lengths[i],
                2e-2 * lengths[i] + rounding * static_cast<double>(walks[i].size()));
  }
  EXPECT_EQ(intersection_matrix(tm, walks), expected);
  // Nothing that would make the mesh unfit.
  std::vector<CGAL::Handle_tunnel_pair<TriangleMesh>> again;
  ASSERT_NO_THROW(CGAL::handle_tunnel_loops(tm, std::back_inserter(again)));
  EXPECT_EQ(again.size(), pairs.size());
}

TEST(Imprint_loops, KeepsTheSurface) {
  Random random(1);
  for(int round = 0; round < 60; ++round) {
    const Recipe recipe = random_recipe(random, 6);
    SCOPED_TRACE(testing::PrintToString(recipe));
    expect_imprint(mesh_of(recipe));
  }
}

TEST(Imprint_loops, KeepsPolyhedra) {
  Random random(2);
  for(int round = 0; round < 10; ++round)
    expect_imprint(mesh_of<Polyhedron>(soup_of(random_recipe(random, 4))));
}

TEST(Imprint_loops, TellsEdgesAndFaces) {
  Mesh mesh = mesh_of(Recipe{"multi-torus", {1000, 2, 1}});
  const Pairs pairs = find_loops(mesh);
  const auto marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:loop", false).first;
  const auto origin = mesh.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:origin").first;
  for(const auto f : mesh.faces())
    origin[f] = f;
  const auto old_faces = mesh.number_of_faces();
  std::vector<Edge_walk<Mesh>> walks;
  CGAL::imprint_loops(pairs, mesh, std::back_inserter(walks),
                      CGAL::parameters::face_to_face_map(origin).edge_is_constrained_map(marks));
  std::set<Mesh::Edge_index> on_loops;
  for(const auto& walk : walks)
    for(const auto h : walk)
      on_loops.insert(mesh.edge(h));
  for(const auto e : mesh.edges())
    EXPECT_EQ(marks[e], on_loops.count(e) != 0);
  for(const auto f : mesh.faces())
    EXPECT_LT(origin[f].idx(), old_faces);
}

} // namespace test_imprint_loops
