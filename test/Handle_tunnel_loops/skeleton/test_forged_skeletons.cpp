// True skeletons, broken in one way each, are refused, and for that reason.

#include "Skeleton_checks.h"

#include <CGAL/curve_skeleton.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace test_forged_skeletons {

using namespace skeleton_checks;
using Edge = std::pair<std::size_t, std::size_t>;

std::vector<Edge> edges_of(const Graph& graph) {
  std::vector<Edge> all;
  for(const auto e : CGAL::make_range(edges(graph)))
    all.emplace_back(source(e, graph), target(e, graph));
  return all;
}

std::string name(const Edge& e) {
  return "edge " + std::to_string(e.first) + "-" + std::to_string(e.second);
}

Vector place(const Graph& graph, std::size_t v) {
  const auto& p = graph[v].point;
  return {p.x(), p.y(), p.z()};
}

void move(Graph& graph, std::size_t v, const Vector& p) {
  graph[v].point = Mesh::Point(p[0], p[1], p[2]);
}

bool is_on_cycle(const Graph& graph, const Edge& e) {
  return !skeleton_definitions::is_bridge(skeleton_definitions::skeleton_of(graph),
                                          {e.first, e.second});
}

Graph circle() {
  Graph graph;
  add_line(graph, wound(2., 1, 0., 30), true);
  return graph;
}

// ---- of an answer

class Forged_skeleton : public testing::Test
{
protected:
  void SetUp() override {
    CGAL::curve_skeleton(mesh, graph);
    ASSERT_TRUE(check(mesh, graph, pairs));
  }

  // So many edges with a property.
  template <typename Property> std::vector<Edge> some(std::size_t n, const Property& holds) const {
    std::vector<Edge> found;
    const std::vector<Edge> all = edges_of(graph);
    for(std::size_t i = 0; i < all.size() && found.size() < n; i += 1 + all.size() / (4 * n))
      if(holds(all[i]))
        found.push_back(all[i]);
    EXPECT_FALSE(found.empty());
    return found;
  }

  std::vector<Edge> some_on_cycles(std::size_t n) const {
    return some(n, [this](const Edge& e) { return is_on_cycle(graph, e); });
  }

  const Mesh mesh = mesh_of(Recipe{"lattice", {900, 2, 1}});
  const Pairs pairs = find_loops(mesh);
  Graph graph;
};

TEST_F(Forged_skeleton, MustNotHaveABendBeyondAWall) {
  for(const auto& [p, q] : some_on_cycles(6)) {
    Graph forged = graph;
    move(forged, p, 40. * (place(graph, p) - place(graph, q)) + Vector(0., 0., 30.));
    const Certificate c = check(mesh, forged, pairs);
    EXPECT_TRUE(c.connected);
    EXPECT_FALSE(c.inside);
    expect_failure(c, " leaves through face ");
  }
}

TEST_F(Forged_skeleton, MustNotLackAnEdge) {
  for(const auto& [p, q] : some_on_cycles(4)) {
    Graph forged = graph;
    remove_edge(p, q, forged);
    expect_failure(check(mesh, forged, pairs), "has 1 cycle, but the genus is 2");
    // A limb in its place does not help.
    add_edge(p, add_point(forged, 0.9 * place(graph, p) + 0.1 * place(graph, q)), forged);
    expect_failure(check(mesh, forged, pairs), "has 1 cycle, but the genus is 2");
  }
}

TEST_F(Forged_skeleton, MustNotHaveAnEdgeTwice) {
  for(const Edge& e : some_on_cycles(4)) {
    Graph forged = graph;
    add_edge(e.first, e.second, forged);
    const Certificate c = check(mesh, forged, pairs);
    expect_failure(c, "has 3 cycles, but the genus is 2");
    expect_failure(c, name(e) + " meets " + name(e));
  }
}

// There are two cycles, inside and apart from each other, but one of them bounds.
TEST_F(Forged_skeleton, MustNotHaveATrivialCycleForAnother) {
  for(const auto& [p, q] : some_on_cycles(4)) {
    Graph forged = graph;
    const double length =
        std::sqrt(CGAL::to_double(CGAL::squared_distance(graph[p].point, graph[q].point)));
    const Vector between =
        0.5 * place(graph, p) + 0.5 * place(graph, q) + 0.01 * length * Vector(0.3, 0.5, -0.8);
    const std::size_t v = add_point(forged, between);
    add_edge(p, v, forged);
    add_edge(v, q, forged);
    const auto dropped = some(1, [&](const Edge& e) {
      return e != Edge(p, q) && e.first != p && e.second != p && e.first != q && e.second != q &&
             is_on_cycle(graph, e);
    });
    remove_edge(dropped[0].first, dropped[0].second, forged);
    const Certificate c = check(mesh, forged, pairs);
    EXPECT_TRUE(c.connected && c.inside && c.embedded) << c.failure;
    expect_failure(
        c, "are not a basis: the determinant of their linking numbers with the handle loops "
           "is 0, not 1");
  }
}

// ---- of lines drawn by hand

TEST(Forged_skeletons, MustNotCross) {
  const Mesh ring = mesh_of(torus(2., 0.5, 8, 20));
  Graph graph = circle(); // in the plane z = 0
  add_edge(0, add_point(graph, {2.25, 0., 0.}), graph);
  add_edge(1, add_point(graph, {1.75, 0.25, 0.}), graph);
  EXPECT_TRUE(check(ring, graph));
  move(graph, 31, {2.125, -0.25, 0.});
  const Certificate c = check(ring, graph);
  EXPECT_TRUE(c.connected && c.inside && c.basis) << c.failure;
  EXPECT_FALSE(c.embedded);
  expect_failure(c, "edge 0-30 meets edge 1-31");
}

TEST(Forged_skeletons, MustNotEndOnTheSurface) {
  const Mesh ring = mesh_of(torus(2., 0.5, 8, 20));
  Graph graph = circle();
  const auto& p = ring.point(Mesh::Vertex_index(0));
  const std::size_t leaf = add_point(graph, {p.x(), p.y(), p.z()});
  add_edge(0, leaf, graph);
  expect_failure(check(ring, graph), "edge 0-30 leaves through face ");
  move(graph, leaf, 0.999 * Vector(p.x(), p.y(), p.z()) + 0.001 * place(graph, 0));
  EXPECT_TRUE(check(ring, graph));
}

// By the last bit, in a plate of which all faces are needles.
TEST(Forged_skeletons, MustNotTouchAThinWall) {
  constexpr double thickness = 0x1p-40, top = 2. * thickness;
  Soup soup = block_ring();
  for(auto& p : soup.points)
    p[2] *= thickness;
  const Mesh mesh = mesh_of(soup);
  const Pairs pairs = find_loops(mesh);
  Graph graph;
  add_line(graph, {{1, 1, thickness}, {5, 1, thickness}, {5, 5, thickness}, {1, 5, thickness}},
           true);
  EXPECT_TRUE(check(mesh, graph, pairs));
  for(const double x : {1., 1.3})
    for(const auto& [z, is_inside] : std::map<double, bool>{{std::nextafter(top, 0.), true},
                                                            {top, false},
                                                            {std::nextafter(top, 1.), false},
                                                            {std::nextafter(0., 1.), true},
                                                            {0., false},
                                                            {-std::nextafter(0., 1.), false}})
    {
      move(graph, 0, {x, 1., z});
      const Certificate c = check(mesh, graph, pairs);
      EXPECT_EQ(c.inside, is_inside) << x << ' ' << z;
      EXPECT_EQ(bool(c), is_inside);
      if(!is_inside)
        expect_failure(c, "edge 0-1 leaves through face ");
    }
}

// Of which one lies in the other, but is no cavity.
TEST(Forged_skeletons, MustNotBeOfTheOtherComponent) {
  const Mesh mesh = mesh_of(together(torus(2., 0.9, 12, 24), torus(2., 0.3, 8, 24)));
  const Pairs pairs = find_loops(mesh);
  Graph graph;
  add_line(graph, wound(2.6, 1, 0., 40), true, 0);
  add_line(graph, wound(2., 1, 0., 40), true, 1);
  EXPECT_TRUE(check(mesh, graph, pairs));
  for(const auto v : CGAL::make_range(vertices(graph)))
    graph[v].component = 1 - graph[v].component;
  expect_failure(check(mesh, graph, pairs), "edge 0-1 lies outside of component 1");
  graph[0].component = (std::numeric_limits<unsigned>::max)() + std::size_t(1); // 0, in 32 bits
  expect_failure(CGAL::certify_curve_skeleton(mesh, graph, pairs), "but the mesh has only 2");
}

TEST(Forged_skeletons, MustBeFinite) {
  const Mesh ring = mesh_of(torus(2., 0.5, 8, 20));
  const Pairs pairs = find_loops(ring);
  for(const double x :
      {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    Graph graph = circle();
    move(graph, 7, {2., x, 0.});
    expect_failure(CGAL::certify_curve_skeleton(ring, graph, pairs), "point 7 is not finite");
  }
}

// ---- at boundaries

// One of them as good as in the middle of the curve, but on the other side of the cap.
TEST(Forged_skeletons, MustNotHaveTwoInletsAtACurve) {
  const Mesh mesh = mesh_of(pipe(4., 0.5, 9, 10));
  Graph graph;
  add_line(graph, {{0, 0, 0}, {2, 0.1, 0}, {4, 0, 0}}, false);
  graph[0].is_inlet = graph[2].is_inlet = true;
  EXPECT_TRUE(check(mesh, graph));
  const std::size_t v = add_point(graph, {-0x1p-43, 0x1p-44, 0.});
  graph[v].is_inlet = true;
  add_edge(1, v, graph);
  const Certificate c = check(mesh, graph);
  expect_failure(c, "edge 1-3 leaves through the cap of the boundary curve");
  expect_failure(c, "point 3 is not an inlet");
}

TEST(Forged_skeletons, MustNotEndAtACapUnlessInTheMiddle) {
  const Mesh mesh = mesh_of(pipe(4., 0.5, 9, 10));
  Graph graph;
  add_line(graph, {{0, 0, 0}, {2, 0.1, 0}, {4.01, 0, 0}}, false);
  graph[0].is_inlet = true;
  expect_failure(check(mesh, graph), "edge 1-2 leaves through the cap of the boundary curve");
  graph[2].is_inlet = true;
  move(graph, 2, {4., 0.125, 0.});
  expect_failure(CGAL::certify_curve_skeleton(mesh, graph, Pairs()), "point 2 is not an inlet");
}

// A band along a knot: no cap of its curves is free of itself.
TEST(Forged_skeletons, MustNotBeWhereCapsCross) {
  Line knot = trefoil();
  knot.pop_back();
  Soup soup;
  const auto n = static_cast<std::uint32_t>(knot.size());
  for(const double height : {0., 0.1})
    for(const Vector& p : knot)
      soup.points.push_back({p[0], p[1], p[2] + height});
  for(std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    soup.triangles.push_back({i, j, n + j});
    soup.triangles.push_back({i, n + j, n + i});
  }
  const Mesh mesh = mesh_of(soup);
  Graph graph;
  add_point(graph, 0.5 * knot[0] + 0.25 * knot[1] + 0.25 * knot[2] + Vector(0, 0, 0.05));
  const Certificate c = CGAL::certify_curve_skeleton(mesh, graph, Pairs());
  EXPECT_FALSE(c.inside || c.basis);
  expect_failure(c, "the cap of the boundary curve at vertex ");
}

} // namespace test_forged_skeletons
