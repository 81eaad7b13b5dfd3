// Where Reeb graphs are drawn: winding numbers against CGAL's own test of sides, and lines that are
// led inside, while all that is inside stays where it is.

#include "Flat_mesh_of_soup.h"
#include "Meshes_of_soups.h"
#include "with.h"

#include "generators/Random.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/draw_lines.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/reeb_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace test_reeb_drawing {

using namespace CGAL::Handle_tunnel_loops::internal;
using generators::Random;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Solid_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Side = CGAL::Side_of_triangle_mesh<Solid_mesh, Kernel>;

// In the box around the mesh; those that are told share coordinates with vertices.
std::vector<Vector> points_in_box(const Flat_mesh& mesh, Random& random, bool is_aligned) {
  Vector low = mesh.points[0], high = low;
  for(const Vector& p : mesh.points)
    for(int d = 0; d < 3; ++d) {
      low[d] = (std::min)(low[d], p[d]);
      high[d] = (std::max)(high[d], p[d]);
    }
  std::vector<Vector> points(500);
  for(Vector& p : points) {
    const Vector& vertex = mesh.points[random.below(mesh.number_of_vertices())];
    for(int d = 0; d < 3; ++d)
      p[d] = is_aligned && d < 2 ? vertex[d] : random.uniform(low[d], high[d]);
  }
  return points;
}

TEST(Winding_numbers, AreOneInsideAndZeroOutside) {
  Random random(1);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 1)) {
    if(recipe.kind == "random")
      continue; // these cross themselves
    SCOPED_TRACE(testing::Message() << recipe);
    const Soup soup = soup_of(recipe);
    Soup turned = soup;
    for(auto& triangle : turned.triangles)
      std::swap(triangle[0], triangle[1]);
    const Flat_mesh flat = flat_mesh_of(soup), turned_flat = flat_mesh_of(turned);
    const Solid_mesh mesh = mesh_of<Solid_mesh>(soup);
    const Side side(mesh);
    for(const bool is_aligned : {false, true}) {
      const std::vector<Vector> points = points_in_box(flat, random, is_aligned);
      const std::vector<int> winding = winding_numbers(Execution(), flat, points);
      EXPECT_EQ(winding, winding_numbers(Execution::parallel(), flat, points));
      const std::vector<int> other = winding_numbers(Execution(), turned_flat, points);
      std::size_t inside = 0, wrong = 0;
      for(std::size_t i = 0; i < points.size(); ++i) {
        const auto expected = side({points[i][0], points[i][1], points[i][2]});
        if(expected == CGAL::ON_BOUNDARY)
          continue;
        wrong += winding[i] != (expected == CGAL::ON_BOUNDED_SIDE ? 1 : 0);
        EXPECT_EQ(other[i], -winding[i]);
        inside += expected == CGAL::ON_BOUNDED_SIDE;
      }
      // Where walls are steep above a point, its place is a matter of rounding.
      EXPECT_LE(wrong, is_aligned ? points.size() / 50 : 0u);
      EXPECT_GT(inside, 0u);
    }
  }
}

TEST(Winding_numbers, OfNoPointsAreNone) {
  const Flat_mesh mesh = flat_mesh_of(soup_of({"torus", {100, 1, 0}}));
  EXPECT_TRUE(winding_numbers(Execution(), mesh, {}).empty());
}

// Many points above and below each of a few large triangles.
TEST(Winding_numbers, AreNotToldWhereThatWouldTakeLong) {
  const Flat_mesh mesh = flat_mesh_of(soup_of({"torus", {100, 1, 0}}));
  Random random(3);
  const std::vector<Vector> some = points_in_box(mesh, random, false);
  EXPECT_EQ(winding_numbers(Execution(), mesh, some).size(), some.size());
  std::vector<Vector> points;
  while(points.size() < 1000000)
    points.insert(points.end(), some.begin(), some.end());
  EXPECT_TRUE(winding_numbers(Execution(), mesh, points).empty());
  EXPECT_TRUE(winding_numbers(Execution::parallel(), mesh, points).empty());
}

// What of the lines of its graph is inside, and of the junctions.
struct Inside
{
  double line = 0., junctions = 0.;
};

Inside inside_of(const Soup& soup) {
  const Solid_mesh mesh = mesh_of<Solid_mesh>(soup);
  CGAL::Reeb_graph<Solid_mesh> graph;
  CGAL::reeb_graph(mesh, graph,
                   CGAL::parameters::reeb_options(
                       with(&CGAL::Handle_tunnel_loops::Reeb_options::allow_parallel_arcs, true)));
  const Side side(mesh);
  const auto is_inside = [&side](const Kernel::Point_3& p) {
    return side(p) != CGAL::ON_UNBOUNDED_SIDE;
  };
  double length = 0., inside = 0.;
  for(const auto e : CGAL::make_range(edges(graph))) {
    const auto& line = graph[e].polyline;
    for(std::size_t i = 1; i < line.size(); ++i) {
      const double part = std::sqrt(CGAL::squared_distance(line[i - 1], line[i]));
      length += part;
      inside += is_inside(CGAL::midpoint(line[i - 1], line[i])) ? part : 0.;
    }
  }
  double junctions = 0., junctions_inside = 0.;
  for(const auto v : CGAL::make_range(vertices(graph)))
    if(graph[v].type == CGAL::Reeb_node_type::SADDLE) {
      ++junctions;
      junctions_inside += is_inside(graph[v].point);
    }
  return {inside / length, junctions > 0. ? junctions_inside / junctions : 1.};
}

// The fronts on these are far from convex.
TEST(Reeb_drawing, IsInside) {
  for(const Recipe& recipe : {Recipe{"plates", {6000, 3, 0}}, Recipe{"gyroid", {8000, 5, 0}},
                              Recipe{"sponge", {8000, 5, 0}}, Recipe{"lattice", {8000, 5, 0}}})
  {
    SCOPED_TRACE(testing::Message() << recipe);
    const Inside inside = inside_of(soup_of(recipe));
    EXPECT_GT(inside.line, 0.85);
    EXPECT_EQ(inside.junctions, 1.);
  }
}

// Rounded off as ever, and not moved before.
TEST(Reeb_drawing, LeavesWhatIsInside) {
  const Flat_mesh mesh = flat_mesh_of(soup_of({"torus", {8000, 1, 0}}));
  const auto height = [&](Index v) { return static_cast<std::uint64_t>(v); };
  const Sweep_order order(Execution(), mesh, height);
  std::vector<Vector> means;
  std::vector<Index> vertices;
  Random random(2);
  for(const Vector& p : points_in_box(mesh, random, false))
    if(winding_numbers(Execution(), mesh, {p}) == std::vector<int>(1, 1)) {
      means.push_back(p);
      vertices.push_back(static_cast<Index>(random.below(mesh.number_of_vertices())));
    }
  ASSERT_GT(means.size(), 20u);
  const std::vector<Vector> before = means;
  lead_inside(Execution(), mesh, order, vertices, means);
  EXPECT_EQ(means, before);

  std::vector<Polyline> lines = {{before[0], before[0] + 1e-3 * before[1], before[0]}};
  Polyline expected = lines[0];
  smooth(expected, 10);
  round_off(Execution(), mesh, mean_edge_length(mesh), lines);
  EXPECT_EQ(lines[0], expected);
}

} // namespace test_reeb_drawing
