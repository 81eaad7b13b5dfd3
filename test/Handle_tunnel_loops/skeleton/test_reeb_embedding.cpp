// Reeb graphs that are drawn inside are so, by definition: no segment meets a face, and its middle
// is on the bounded side, as CGAL's own trees and tests say. Their cycles are a basis of those of
// the solid. The graphs stay what they were.

#include "Meshes_of_soups.h"
#include "Skeleton_definitions.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/embed_reeb_graph.h>
#include <CGAL/reeb_graph.h>
#include <CGAL/reeb_graph_of_function.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace test_reeb_embedding {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Solid_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Graph = CGAL::Reeb_graph<Solid_mesh>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Solid_mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Side = CGAL::Side_of_triangle_mesh<Solid_mesh, Kernel>;
using CGAL::Handle_tunnel_loops::Reeb_embedding;

void expect_same_but_for_lines(const Graph& before, const Graph& after) {
  ASSERT_EQ(num_vertices(before), num_vertices(after));
  ASSERT_EQ(num_edges(before), num_edges(after));
  for(const auto v : CGAL::make_range(vertices(before))) {
    EXPECT_EQ(before[v].vertex, after[v].vertex);
    EXPECT_EQ(before[v].type, after[v].type);
    EXPECT_EQ(before[v].value, after[v].value);
  }
  auto other = edges(after).first;
  for(const auto e : CGAL::make_range(edges(before))) {
    EXPECT_EQ(source(e, before), source(*other, after));
    EXPECT_EQ(target(e, before), target(*other, after));
    EXPECT_EQ(before[e].vertices, after[*other].vertices);
    ++other;
  }
}

// Segments lie on one side if they meet no face.
void expect_inside(const Solid_mesh& mesh, const Graph& graph) {
  const Tree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
  const Side side(mesh);
  for(const auto e : CGAL::make_range(edges(graph))) {
    const auto& line = graph[e].polyline;
    ASSERT_GE(line.size(), 2u);
    EXPECT_EQ(line.front(), graph[source(e, graph)].point);
    EXPECT_EQ(line.back(), graph[target(e, graph)].point);
    ASSERT_EQ(graph[e].radii.size(), line.size());
    ASSERT_EQ(graph[e].is_inside.size(), line.size() - 1);
    double length = 0.;
    for(std::size_t i = 0; i < line.size(); ++i) {
      EXPECT_EQ(side(line[i]), CGAL::ON_BOUNDED_SIDE);
      const double distance = std::sqrt(tree.squared_distance(line[i]));
      EXPECT_NEAR(graph[e].radii[i], distance, 1e-9 * distance);
      if(i == 0)
        continue;
      length += std::sqrt(CGAL::squared_distance(line[i - 1], line[i]));
      EXPECT_TRUE(graph[e].is_inside[i - 1]);
      EXPECT_FALSE(tree.do_intersect(Kernel::Segment_3(line[i - 1], line[i])));
    }
    EXPECT_NEAR(graph[e].length, length, 1e-9 * length);
  }
}

// Its nodes and lines, of one component.
skeleton_definitions::Skeleton skeleton_of(const Graph& graph) {
  skeleton_definitions::Skeleton skeleton;
  const auto add = [&](const Kernel::Point_3& p) {
    skeleton.points.push_back({p.x(), p.y(), p.z()});
    return skeleton.points.size() - 1;
  };
  for(const auto v : CGAL::make_range(vertices(graph)))
    add(graph[v].point);
  for(const auto e : CGAL::make_range(edges(graph))) {
    const auto& line = graph[e].polyline;
    std::size_t before = source(e, graph);
    for(std::size_t i = 1; i < line.size(); ++i) {
      const std::size_t next = i + 1 < line.size() ? add(line[i]) : target(e, graph);
      skeleton.edges.push_back({before, next});
      before = next;
    }
  }
  skeleton.component.assign(skeleton.points.size(), 0);
  skeleton.is_inlet.assign(skeleton.points.size(), false);
  return skeleton;
}

void expect_skeleton(const Solid_mesh& mesh, Graph& graph) {
  CGAL::embed_reeb_graph(mesh, graph);
  const auto truth = skeleton_definitions::truth(mesh, skeleton_of(graph), find_loops(mesh));
  EXPECT_TRUE(truth.is_connected);
  EXPECT_TRUE(truth.is_inside);
  EXPECT_TRUE(truth.is_embedded);
  EXPECT_TRUE(truth.is_basis);
}

// Whatever the contours bound.
TEST(Reeb_embedding, CyclesAreABasis) {
  for(const Recipe& recipe : {Recipe{"torus", {600, 1, 0}}, Recipe{"multi-torus", {1500, 3, 0}},
                              Recipe{"plates", {1500, 3, 0}}, Recipe{"gyroid", {2000, 5, 0}}})
  {
    const Solid_mesh mesh = mesh_of<Solid_mesh>(soup_of(recipe));
    for(const bool is_from_middle : {false, true}) {
      SCOPED_TRACE(testing::Message() << recipe << ' ' << is_from_middle);
      std::vector<double> values; // their contours lead around the hole of a torus
      for(const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        values.push_back(is_from_middle ? std::hypot(p.x(), p.y(), 0.1 * p.z())
                                        : p.x() + 0.1 * p.y());
      }
      Graph graph;
      CGAL::reeb_graph_of_function(
          mesh, boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, mesh)),
          graph);
      expect_skeleton(mesh, graph);
    }
  }
}

TEST(Reeb_embedding, IsInside) {
  for(const Recipe& recipe :
      {Recipe{"torus", {600, 1, 0}}, Recipe{"plates", {3000, 3, 0}}, Recipe{"gyroid", {4000, 5, 0}},
       Recipe{"sponge", {3000, 5, 0}}, Recipe{"lattice", {3000, 5, 0}}})
    for(const double shortest_arc : {0., 2.}) {
      SCOPED_TRACE(testing::Message() << recipe << ' ' << shortest_arc);
      const Solid_mesh mesh = mesh_of<Solid_mesh>(soup_of(recipe));
      CGAL::Handle_tunnel_loops::Reeb_options options;
      options.shortest_arc = shortest_arc;
      options.allow_parallel_arcs = shortest_arc > 0.;
      Graph graph;
      CGAL::reeb_graph(mesh, graph, CGAL::parameters::reeb_options(options));
      Graph drawn = graph;
      const Reeb_embedding embedding = CGAL::embed_reeb_graph(mesh, drawn);
      EXPECT_TRUE(embedding.inside);
      EXPECT_TRUE(embedding.embedded);
      EXPECT_EQ(embedding.number_of_segments_inside, embedding.number_of_segments);
      expect_same_but_for_lines(graph, drawn);
      expect_inside(mesh, drawn);
    }
}

// Of a shape without symmetry, all coordinates of which are others then.
TEST(Reeb_embedding, TurnsWithTheMesh) {
  Solid_mesh mesh = mesh_of<Solid_mesh>(soup_of({"multi-torus", {2000, 3, 0}}));
  for(const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    mesh.point(v) = {p.x() + 0.05 * p.y() * p.y(), 0.8 * p.y() + 0.03 * p.x() * p.x(),
                     p.z() + 0.1 * p.x()};
  }
  const Kernel::Aff_transformation_3 turn(0.36, 0.48, -0.8, 5., -0.8, 0.6, 0., 2., 0.48, 0.64, 0.6,
                                          3.);
  Solid_mesh turned = mesh;
  for(const auto v : turned.vertices())
    turned.point(v) = turn(turned.point(v));
  Graph graph, other;
  CGAL::reeb_graph(mesh, graph);
  other = graph;
  CGAL::embed_reeb_graph(mesh, graph);
  CGAL::embed_reeb_graph(turned, other);
  auto e = edges(other).first;
  for(const auto a : CGAL::make_range(edges(graph))) {
    const auto &line = graph[a].polyline, &turned_line = other[*e++].polyline;
    ASSERT_EQ(line.size(), turned_line.size());
    for(std::size_t i = 0; i < line.size(); ++i)
      EXPECT_LT(CGAL::squared_distance(turn(line[i]), turned_line[i]), 1e-12);
  }
}

// Each component by itself.
TEST(Reeb_embedding, IsInsideOfEachComponent) {
  Solid_mesh mesh;
  for(const double x : {0., 10., 20.}) {
    Soup soup = soup_of({"torus", {300, 1, 0}});
    for(auto& p : soup.points)
      p[0] += x;
    const Solid_mesh part = mesh_of<Solid_mesh>(soup);
    CGAL::copy_face_graph(part, mesh);
  }
  Graph graph;
  CGAL::reeb_graph(mesh, graph);
  EXPECT_TRUE(CGAL::embed_reeb_graph(mesh, graph).inside);
  expect_inside(mesh, graph);
}

// There is no solid.
TEST(Reeb_embedding, IsThereOnFlatSurfaces) {
  for(const int flat_axes : {1, 2, 3}) {
    Soup soup = soup_of({"torus", {300, 1, 0}});
    for(auto& p : soup.points)
      for(int axis = 0; axis < flat_axes; ++axis)
        p[2 - axis] = 0.;
    const Solid_mesh mesh = mesh_of<Solid_mesh>(soup);
    Graph graph;
    CGAL::reeb_graph(mesh, graph);
    Graph drawn = graph;
    EXPECT_FALSE(CGAL::embed_reeb_graph(mesh, drawn).inside);
    expect_same_but_for_lines(graph, drawn);
    for(const auto e : CGAL::make_range(edges(drawn)))
      EXPECT_GE(drawn[e].polyline.size(), 2u);
  }
}

TEST(Reeb_embedding, DoesNotDependOnThreads) {
  const Solid_mesh mesh = mesh_of<Solid_mesh>(soup_of({"sponge", {3000, 5, 0}}));
  Graph graph, other;
  CGAL::reeb_graph(mesh, graph);
  other = graph;
  CGAL::embed_reeb_graph(mesh, graph);
  CGAL::embed_reeb_graph<CGAL::Parallel_if_available_tag>(mesh, other);
  auto e = edges(other).first;
  for(const auto a : CGAL::make_range(edges(graph)))
    EXPECT_EQ(graph[a].polyline, other[*e++].polyline);
}

} // namespace test_reeb_embedding
