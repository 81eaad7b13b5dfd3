// The solid is on the same side whether the volume is summed face by face, or ring by ring as on
// flat meshes.

#include "Flat_mesh_of_soup.h"
#include "Generated_soups.h"
#include "Meshes_of_soups.h"

#include <CGAL/Handle_tunnel_loops/internal/linking/Component_orientation.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_graph.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace test_component_orientation {

using namespace CGAL::Handle_tunnel_loops::internal;

template <typename Graph, typename PointMap, typename ComponentOfFace>
std::vector<int> outward(const Graph& g,
                         PointMap point,
                         const ComponentOfFace& component,
                         std::size_t number_of_components) {
  return Component_orientation<Graph, PointMap, ComponentOfFace>(
             Execution(), g, point, component, std::vector<char>(number_of_components, 1),
             std::vector<char>(number_of_components, 0))
      .sides()
      .outward;
}

// The signs of the components, by faces; by rings they have to be the same.
std::vector<int> sides(const Soup& soup) {
  Mesh mesh = mesh_of(soup);
  auto component = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first;
  const std::size_t n = CGAL::Polygon_mesh_processing::connected_components(mesh, component);
  const Flat_mesh flat = flat_mesh_of(soup);
  const auto point = get(CGAL::vertex_point, mesh);
  const std::vector<int> by_faces = outward(
      mesh, point, [&](Mesh::Face_index f) { return component[f]; }, n);
  const auto points = boost::make_function_property_map<Index>(
      [&](Index v) { return mesh.point(Mesh::Vertex_index(v)); });
  const Flat_graph graph(flat);
  const std::vector<int> by_rings = outward(
      graph, points,
      [&](Flat_graph::Halfedge h) {
        EXPECT_TRUE(Flat_graph::is_face(h, graph));
        return component[face(halfedge(Mesh::Vertex_index(h.source), mesh), mesh)];
      },
      n);
  EXPECT_EQ(by_rings, by_faces);
  return by_faces;
}

TEST(Sides, AreTheSameByFacesAndByRings) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 2)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    Soup soup = soup_of(recipe);
    const std::vector<int> before = sides(soup);
    reverse_orientation(soup);
    const std::vector<int> reversed = sides(soup);
    ASSERT_EQ(reversed.size(), before.size());
    for(std::size_t i = 0; i < before.size(); ++i)
      EXPECT_EQ(reversed[i], -before[i]);
  }
}

// Far from the origin the sign of the volume is beyond rounding, and is found exactly.
TEST(Sides, DoNotDependOnScaleNorPlace) {
  const Soup soup = soup_of({"torus", {300, 1, 0}});
  for(const double scale : {1e-150, 1e-3, 1e150})
    EXPECT_EQ(sides(transformed(soup, scale, 0.)), std::vector<int>(1, 1));
  EXPECT_EQ(sides(transformed(soup, 1., 1e12)), std::vector<int>(1, 1));
}

} // namespace test_component_orientation
