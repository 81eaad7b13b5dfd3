// Every model of FaceListGraph will do, whatever it holds besides the surface.

#include "Loop_definitions.h"
#include "Meshes_of_soups.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

namespace test_meshes {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Simple = CGAL::Simple_cartesian<double>;

constexpr std::size_t genus = 4;

// Two components, the vertices and faces of which are numbered all mixed.
Soup mixed_soup() {
  const Soup soup = generators::disjoint_union(
      {soup_of({"multi-torus", {1200, 3, 0}}), soup_of({"random", {100, 1, 0}})});
  return generators::permute_vertices(soup, 1);
}

template <typename TriangleMesh> void expect_loops(const TriangleMesh& tm, std::size_t g = genus) {
  std::vector<CGAL::Handle_tunnel_pair<TriangleMesh>> pairs;
  CGAL::handle_tunnel_loops(tm, std::back_inserter(pairs));
  expect_handle_tunnel_pairs(tm, pairs, g);
}

template <typename TriangleMesh> class Mesh_type : public testing::Test
{};

using Mesh_types = testing::Types<CGAL::Surface_mesh<Simple::Point_3>,
                                  CGAL::Surface_mesh<Epick::Point_3>,
                                  CGAL::Surface_mesh<Epeck::Point_3>,
                                  CGAL::Polyhedron_3<Simple>,
                                  CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>>;
TYPED_TEST_SUITE(Mesh_type, Mesh_types);

TYPED_TEST(Mesh_type, HasLoops) { expect_loops(mesh_of<TypeParam>(mixed_soup())); }

TEST(Polyhedron_with_id, MayHaveItsIdsSet) {
  using Polyhedron = CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>;
  Polyhedron mesh = mesh_of<Polyhedron>(mixed_soup());
  CGAL::set_halfedgeds_items_id(mesh);
  expect_loops(mesh);
}

TEST(Loops, AreTheSameOnEveryMeshType) {
  using Polyhedron = CGAL::Polyhedron_3<Simple>;
  const Soup soup = mixed_soup();
  const Mesh mesh = mesh_of(soup);
  const Polyhedron polyhedron = mesh_of<Polyhedron>(soup);
  const Pairs expected = find_loops(mesh);
  std::vector<CGAL::Handle_tunnel_pair<Polyhedron>> pairs;
  CGAL::handle_tunnel_loops(polyhedron, std::back_inserter(pairs));
  ASSERT_EQ(pairs.size(), expected.size());
  for(std::size_t k = 0; k < pairs.size(); ++k) {
    EXPECT_EQ(pairs[k].handle().points(), expected[k].handle().points());
    EXPECT_EQ(pairs[k].tunnel().points(), expected[k].tunnel().points());
  }
}

// ---- what else a mesh may hold

std::set<Mesh::Vertex_index> component_of(Mesh::Vertex_index vertex, const Mesh& mesh) {
  std::set<Mesh::Vertex_index> component = {vertex};
  std::vector<Mesh::Vertex_index> queue(1, vertex);
  for(std::size_t q = 0; q < queue.size(); ++q)
    for(const auto u : CGAL::vertices_around_target(Mesh::Vertex_index(queue[q]), mesh))
      if(component.insert(u).second)
        queue.push_back(u);
  return component;
}

std::vector<Mesh::Face_index> faces_of(const std::set<Mesh::Vertex_index>& component,
                                       const Mesh& mesh) {
  std::vector<Mesh::Face_index> faces;
  for(const Mesh::Face_index f : mesh.faces())
    if(component.count(mesh.source(mesh.halfedge(f))) != 0)
      faces.push_back(f);
  return faces;
}

// Removes the component of a vertex, element by element: the numbers of the others stay.
void remove_component(Mesh::Vertex_index vertex, Mesh& mesh) {
  const std::set<Mesh::Vertex_index> component = component_of(vertex, mesh);
  std::vector<Mesh::Edge_index> edges;
  for(const Mesh::Edge_index e : mesh.edges())
    if(component.count(mesh.vertex(e, 0)) != 0)
      edges.push_back(e);
  for(const Mesh::Face_index f : faces_of(component, mesh))
    mesh.remove_face(f);
  for(const Mesh::Edge_index e : edges)
    mesh.remove_edge(e);
  for(const Mesh::Vertex_index v : component)
    mesh.remove_vertex(v);
}

TEST(Removed_elements, AreNotThere) {
  Mesh mesh = mesh_of(mixed_soup());
  const Mesh::Vertex_index removed(0);
  remove_component(removed, mesh);
  ASSERT_TRUE(mesh.has_garbage());
  ASSERT_TRUE(mesh.is_removed(removed));
  const CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  EXPECT_EQ(solver.number_of_components(), 1u);
  EXPECT_EQ(solver.statistics().number_of_vertices, mesh.number_of_vertices());
  EXPECT_EQ(solver.statistics().number_of_faces, mesh.number_of_faces());
  expect_loops(mesh, solver.genus());
  EXPECT_THROW(find_loops(mesh, CGAL::parameters::seed_vertex(removed)), std::invalid_argument);
}

TEST(Isolated_vertices, AreIgnored) {
  Soup soup = mixed_soup();
  soup.points.insert(soup.points.begin(), {1e30, -1e30, 0.});
  for(auto& triangle : soup.triangles)
    for(auto& v : triangle)
      ++v;
  soup.points.push_back({0., 0., 0.});
  const Mesh mesh = mesh_of(soup);
  const CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  EXPECT_EQ(solver.number_of_components(), 2u);
  EXPECT_EQ(solver.genus(), genus);
  EXPECT_EQ(solver.statistics().number_of_vertices, soup.points.size() - 2);
  expect_loops(mesh);
  expect_loops(mesh_of<CGAL::Polyhedron_3<Epick>>(soup));
}

TEST(Face_filtered_graph, HasTheLoopsOfTheSelectedFaces) {
  const Mesh mesh = mesh_of(mixed_soup());
  const CGAL::Handle_tunnel_loops_solver<Mesh> whole(mesh);
  const auto selected = faces_of(component_of(Mesh::Vertex_index(0), mesh), mesh);
  const CGAL::Face_filtered_graph<Mesh> graph(mesh, selected);
  const CGAL::Handle_tunnel_loops_solver<CGAL::Face_filtered_graph<Mesh>> solver(graph);
  EXPECT_EQ(solver.number_of_components(), 1u);
  EXPECT_LT(solver.genus(), whole.genus());
  expect_loops(graph, solver.genus());
}

// ---- property maps of the caller

TEST(Vertex_point_map, TakesThePlaceOfTheMeshsOwn) {
  using Point = Epick::Point_3; // of another kernel than the mesh's own
  const Soup soup = mixed_soup();
  Mesh mesh = mesh_of(transformed(soup, 0., 7.));
  std::vector<Point> points;
  for(const auto& [x, y, z] : soup.points)
    points.emplace_back(x, y, z);
  const auto point_map = boost::make_function_property_map<Mesh::Vertex_index, const Point&>(
      [&points](Mesh::Vertex_index v) -> const Point& { return points[v]; });
  std::vector<CGAL::Handle_tunnel_pair<Mesh, Point>> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs),
                            CGAL::parameters::vertex_point_map(point_map));
  expect_handle_tunnel_pairs(mesh, point_map, pairs, genus);

  const Pairs expected = find_loops(mesh_of(soup));
  for(std::size_t k = 0; k < genus; ++k)
    EXPECT_EQ(pairs[k].handle().length(), expected[k].handle().length());
}

TEST(Index_maps, NumberTheElementsAsTheyLike) {
  const Mesh mesh = mesh_of(mixed_soup());
  const std::size_t n = num_vertices(mesh), m = num_faces(mesh);
  const auto vertex_index = boost::make_function_property_map<Mesh::Vertex_index, std::size_t>(
      [n](Mesh::Vertex_index v) { return n - 1 - v; });
  const auto face_index = boost::make_function_property_map<Mesh::Face_index, std::size_t>(
      [m](Mesh::Face_index f) { return m - 1 - f; });
  expect_handle_tunnel_pairs(
      mesh,
      find_loops(mesh, CGAL::parameters::vertex_index_map(vertex_index).face_index_map(face_index)),
      genus);
}

TEST(Index_maps, NameTheElementsInMessages) {
  Soup soup = mixed_soup();
  soup.points[5][1] = std::numeric_limits<double>::quiet_NaN();
  const Mesh mesh = mesh_of(soup);
  const auto vertex_index = boost::make_function_property_map<Mesh::Vertex_index, std::size_t>(
      [&mesh](Mesh::Vertex_index v) { return num_vertices(mesh) - 1 - v; });
  try {
    find_loops(mesh, CGAL::parameters::vertex_index_map(vertex_index));
    FAIL() << "a coordinate is not a number";
  } catch(const CGAL::Handle_tunnel_loops::Invalid_mesh_exception& e) {
    EXPECT_EQ(e.vertices(), std::vector<std::size_t>(1, num_vertices(mesh) - 6));
  }
}

} // namespace test_meshes
