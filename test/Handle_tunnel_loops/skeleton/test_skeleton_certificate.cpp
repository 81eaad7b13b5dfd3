// The certificate of a skeleton says what holds by definition, of good skeletons and of such as are
// wrong in one way each, and names what is wrong.

#include "Skeleton_checks.h"

#include <CGAL/Handle_tunnel_loops/internal/solid/Exact_meeting.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace test_skeleton_certificate {

using namespace skeleton_checks;
using CGAL::Handle_tunnel_loops::Skeleton_certificate;

// ---- skeletons

// Of the lines of `line`, without the point at the end that is the first once more.
Line opened(Line line) {
  line.pop_back();
  return line;
}

// ---- closed surfaces

TEST(Skeleton_certificate, IsGivenForCenterLines) {
  const Mesh ring = mesh_of(torus(2., 0.5, 8, 20));
  Graph circle;
  add_line(circle, wound(2., 1, 0., 30), true);
  EXPECT_TRUE(check(ring, circle));
  add_edge(0, add_point(circle, {2.2, 0., 0.}), circle); // a limb
  EXPECT_TRUE(check(ring, circle));
  const Mesh knot = mesh_of(trefoil_tube());
  Graph trefoil_line;
  add_line(trefoil_line, opened(trefoil()), true);
  EXPECT_TRUE(check(knot, trefoil_line));
  const Mesh ball = mesh_of(Recipe{"sphere", {200, 0, 0}});
  Graph point;
  add_point(point, {0.01, 0.02, 0.03});
  EXPECT_TRUE(check(ball, point));
}

// A circle and a diameter: two handles.
Mesh theta_surface() {
  return mesh_of(surface_of(united(tube(circle({0, 0, 0}, {2, 0, 0}, {0, 2, 0}), 0.4),
                                   tube({{-2, 0, 0}, {2, 0, 0}}, 0.4)),
                            3., 0.25));
}

Graph theta_graph() {
  Graph graph;
  add_line(graph, wound(2., 1, 0., 40), true);
  std::size_t last = 20;
  for(const double x : {-1., 0.1, 1.}) {
    const std::size_t v = add_point(graph, {x, 0.02, 0.});
    add_edge(last, v, graph);
    last = v;
  }
  add_edge(last, 0, graph);
  return graph;
}

TEST(Skeleton_certificate, KnowsTwoHandles) {
  const Mesh mesh = theta_surface();
  EXPECT_TRUE(check(mesh, theta_graph()));
  // Twice around the same hole: the cycles are dependent.
  Graph twice;
  add_line(twice, wound(2., 2, 0.1, 40, 0.1), true);
  add_edge(0, 20, twice); // across the hole, but along the diameter
  expect_failure(check(mesh, twice), "determinant of their linking numbers");
}

TEST(Skeleton_certificate, IsRefusedToLinesThatWindTwiceOrNotAtAll) {
  const Mesh ring = mesh_of(torus(2., 0.7, 12, 24));
  Graph twice;
  add_line(twice, wound(2., 2, 0.2, 30, 0.2), true);
  const Skeleton_certificate c = check(ring, twice);
  EXPECT_TRUE(c.connected && c.inside && c.embedded);
  expect_failure(c, "the 1 cycle is not a basis: the determinant of their linking numbers with the "
                    "handle loops is 2, not 1");
  Graph small;
  add_line(small, {{2., 0., 0.}, {2.2, 0., 0.1}, {2.1, 0.2, 0.}}, true);
  expect_failure(check(ring, small), "is 0, not 1");
  Graph tree;
  add_line(tree, {{2., 0., 0.}, {2.2, 0., 0.1}}, false);
  expect_failure(check(ring, tree), "has 0 cycles, but the genus is 1");
  Graph pieces;
  add_line(pieces, wound(2., 1, 0., 30), true);
  add_point(pieces, {2.2, 0., 0.1});
  expect_failure(check(ring, pieces), "is in 2 pieces");
  expect_failure(check(ring, Graph()), "the skeleton is missing");
}

TEST(Skeleton_certificate, NamesEdgesThatLeave) {
  const Mesh ring = mesh_of(torus(2., 0.5, 8, 20));
  Graph chords;
  add_line(chords, wound(2., 1, 0., 4), true);
  const Skeleton_certificate c = check(ring, chords);
  EXPECT_EQ(c.edges_outside.size(), 4u);
  expect_failure(c, "edge 0-1 leaves through face ");
  for(const auto& e : c.edges_outside) {
    ASSERT_TRUE(e.face);
    using namespace CGAL::Handle_tunnel_loops::internal;
    Exact_triangle t;
    int i = 0;
    for(const auto v : CGAL::vertices_around_face(ring.halfedge(Mesh::Face_index(*e.face)), ring)) {
      const auto& p = ring.point(v);
      t[i++] = exact_point({p.x(), p.y(), p.z()});
    }
    const auto place = [&](std::size_t v) {
      const auto& p = chords[v].point;
      return exact_point({p.x(), p.y(), p.z()});
    };
    EXPECT_TRUE(do_meet(Exact_segment{place(e.edge.first), place(e.edge.second)}, t));
  }
  Graph far;
  add_line(far, wound(5., 1, 0., 8), true);
  const Skeleton_certificate d = check(ring, far);
  expect_failure(d, "edge 0-1 lies outside");
  EXPECT_FALSE(d.edges_outside[0].face);
  Graph point;
  add_point(point, {0., 0., 0.});
  expect_failure(check(mesh_of(Recipe{"sphere", {200, 0, 0}}), far), "lies outside");
  expect_failure(check(ring, point), "point 0 does not lie inside");
}

// To a vertex, to the middle of an edge, along an edge, along a face.
TEST(Skeleton_certificate, IsRefusedWhereTheSurfaceIsTouched) {
  const Mesh ring = mesh_of(torus(2., 0.5, 8, 20));
  const auto at = [&](std::uint32_t v) {
    const auto& p = ring.point(Mesh::Vertex_index(v));
    return Vector(p.x(), p.y(), p.z());
  };
  for(const Line& limb :
      {Line{at(0)}, Line{at(0), at(1)}, Line{0.5 * (at(0) + at(1))}, Line{at(0), at(8)}})
  {
    Graph graph;
    add_line(graph, wound(2., 1, 0., 30), true);
    std::size_t last = 0;
    for(const Vector& p : limb) {
      add_edge(last, add_point(graph, p), graph);
      last = num_vertices(graph) - 1;
    }
    check(ring, graph);
  }
}

TEST(Skeleton_certificate, NamesEdgesThatMeet) {
  const Mesh ball = mesh_of(transformed(soup_of({"sphere", {400, 0, 0}}), 4., 0.));
  const auto found = [&](const std::vector<Vector>& points,
                         const std::vector<std::array<std::size_t, 2>>& edges) {
    Graph graph;
    for(const Vector& p : points)
      add_point(graph, p);
    for(const auto& [p, q] : edges)
      add_edge(p, q, graph);
    return check(ball, graph);
  };
  const Vector o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), xy(1, 1, 0), z(0, 0, 1);
  EXPECT_TRUE(found({o, x, y, z}, {{0, 1}, {0, 2}, {0, 3}}));
  EXPECT_TRUE(found({-x, o, x}, {{0, 1}, {1, 2}}));
  // Across, from behind, upon each other, doubled, without length, at a point that is not common.
  expect_failure(found({o, xy, x, y}, {{0, 1}, {1, 2}, {2, 3}}), "edge 0-1 meets edge 2-3");
  expect_failure(found({o, 2. * x, x, z}, {{0, 1}, {0, 3}, {3, 2}}), "edge 0-1 meets edge 3-2");
  expect_failure(found({o, x, 2. * x}, {{0, 1}, {0, 2}}), "edge 0-1 meets edge 0-2");
  expect_failure(found({o, x, z}, {{0, 1}, {1, 2}, {0, 1}}), "edge 0-1 meets edge 0-1");
  expect_failure(found({o, o, x}, {{0, 1}, {1, 2}}), "edge 0-1 has no length");
  expect_failure(found({o, x, z, x}, {{0, 1}, {0, 2}, {2, 3}}), "edge 0-1 meets edge 2-3");
  expect_failure(found({o, x, 0.5 * x}, {{0, 1}}), "edge 0-1 meets point 2");
}

// ---- several components

// A ring with a hollow core: in its wall are a cycle along the ring and one around the core.
TEST(Skeleton_certificate, TakesAPieceOfTheSolidWithItsCavities) {
  Soup core = torus(2., 0.3, 8, 24);
  const Soup outer = torus(2., 0.9, 12, 24);
  const Mesh alike = mesh_of(together(outer, core));
  reverse_orientation(core);
  const Mesh mesh = mesh_of(together(outer, core));
  Line around = opened(circle({2, 0, 0}, {0.6, 0, 0}, {0, 0, 0.6}));
  Graph both;
  add_line(both, wound(2.6, 1, 0., 40), true, 0);
  around.erase(around.begin());
  add_line(both, around, false, 0);
  add_edge(0, 40, both);
  add_edge(num_vertices(both) - 1, 0, both);
  EXPECT_TRUE(check(mesh, both));
  const auto graph_along = [](double radius, std::size_t component) {
    Graph graph;
    add_line(graph, wound(radius, 1, 0., 40), true, component);
    return graph;
  };
  const auto along = [&](const Mesh& of, double radius, std::size_t component) {
    return check(of, graph_along(radius, component));
  };
  expect_failure(along(mesh, 2.6, 0), "has 1 cycle, but the genus is 2, with that of its cavities");
  expect_failure(along(mesh, 2., 0), "lies outside of component 0");
  expect_failure(along(mesh, 2.27, 0), "leaves through face");
  expect_failure(CGAL::certify_curve_skeleton(mesh, graph_along(2.6, 1), find_loops(mesh)),
                 "belongs to component 1, which is the wall of a cavity");
  // A core that is oriented like the ring is no cavity.
  Graph each = graph_along(2.1, 0);
  add_line(each, wound(2., 1, 0., 40), true, 1);
  const Certificate c = check(alike, each);
  EXPECT_TRUE(c) << c.failure;
  EXPECT_EQ(c.taken_alone,
            "component 1 lies in component 0 with the same orientation: it is taken alone");
  const Certificate crossing = CGAL::certify_curve_skeleton(
      mesh_of(together(outer, torus(2.6, 0.9, 12, 24))), each, Pairs());
  EXPECT_EQ(crossing.taken_alone,
            "components 0 and 1 cross or touch each other: each is taken alone");
}

// Which component is around another does not depend on their numbers.
TEST(Skeleton_certificate, TakesAloneWhatLiesInComponentsThatMeet) {
  const auto ball = [](double radius, double shift) {
    return transformed(soup_of({"sphere", {80, 0, 0}}), radius, shift);
  };
  Soup hole = ball(0.1, -0.1);
  reverse_orientation(hole);
  for(const bool is_large_first : {false, true}) {
    const Soup large = ball(2., 0.), small = ball(0.5, 0.);
    const Mesh mesh = mesh_of(together(
        together(is_large_first ? together(large, small) : together(small, large), ball(0.5, 0.3)),
        hole));
    const Certificate c = CGAL::certify_curve_skeleton(mesh, Graph(), Pairs());
    EXPECT_NE(c.taken_alone.find("component 3 lies in component " +
                                 std::to_string(is_large_first ? 1 : 0) +
                                 ", which meets another one: it is taken alone"),
              std::string::npos)
        << c.taken_alone;
  }
}

TEST(Skeleton_certificate, LinksRings) {
  // Rings that are linked with each other.
  const Mesh chain = mesh_of(linked_rings());
  Graph rings;
  const bool is_first = chain.point(Mesh::Vertex_index(0)).x() < -0.5;
  add_line(rings, opened(circle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})), true, is_first ? 0 : 1);
  add_line(rings, opened(circle({1, 0, 0}, {1, 0, 0}, {0, 0, 1})), true, is_first ? 1 : 0);
  check(chain, rings);
  Graph joined = rings;
  add_edge(0, 60, joined);
  expect_failure(check(chain, joined), "joins components");
  for(const auto v : CGAL::make_range(vertices(rings)))
    rings[v].component = 7;
  expect_failure(CGAL::certify_curve_skeleton(chain, rings, find_loops(chain)),
                 "belongs to component 7, but the mesh has only 2");
}

// ---- boundaries

TEST(Skeleton_certificate, LetsInletsLieOnCaps) {
  const Mesh mesh = mesh_of(pipe(4., 0.5, 9, 10));
  const auto with = [&](const Line& line, bool are_inlets) {
    Graph graph;
    add_line(graph, line, false);
    if(are_inlets)
      graph[0].is_inlet = graph[num_vertices(graph) - 1].is_inlet = true;
    return check(mesh, graph);
  };
  const Vector first(0, 0, 0), last(4, 0, 0);
  // The middle of the curve is rounded in one way or the other.
  EXPECT_TRUE(with({first, {2, 0.1, 0}, last}, true));
  EXPECT_TRUE(with({first, last}, true));
  EXPECT_TRUE(with({{0.1, 0, 0}, {3.9, 0, 0}}, false));
  expect_failure(with({first, {2, 0, 0}, last}, false),
                 "leaves through the cap of the boundary curve");
  expect_failure(with({first, {0, 0.1, 0}, {2, 0.1, 0}, last}, true), "leaves through the cap");
  expect_failure(with({first, {-1, 0, 0}, {-1, 1, 0}, {5, 1, 0}, {5, 0, 0}, last}, true),
                 "outside");
  CGAL::Handle_tunnel_loops::Skeleton_certificate c;
  Graph graph;
  add_line(graph, {{0.1, 0, 0}, {2, 0, 0}}, false);
  graph[0].is_inlet = true;
  expect_failure(CGAL::certify_curve_skeleton(mesh, graph, Pairs()), "point 0 is not an inlet");
}

// A torus without the faces around a vertex; its faces may look inside.
TEST(Skeleton_certificate, KnowsHandlesBesideBoundaries) {
  Soup soup = torus(2., 0.5, 8, 20);
  soup.triangles.erase(
      std::remove_if(soup.triangles.begin(), soup.triangles.end(),
                     [](const auto& t) { return t[0] == 0 || t[1] == 0 || t[2] == 0; }),
      soup.triangles.end());
  for(int i = 0; i < 2; ++i) {
    const Mesh mesh = mesh_of(soup);
    Graph graph;
    add_line(graph, wound(2., 1, 0., 30), true);
    const Skeleton_certificate c = CGAL::certify_curve_skeleton(mesh, graph, find_loops(mesh));
    EXPECT_TRUE(c) << c.failure;
    reverse_orientation(soup);
  }
}

// ---- what only points and edges are known of

TEST(Places_of_skeleton, AreThoseOfComponentsAndInlets) {
  namespace internal = CGAL::Handle_tunnel_loops::internal;
  const auto places_of = [](const Mesh& mesh, const Graph& graph) {
    const auto point = get(CGAL::vertex_point, mesh);
    const internal::Prepared_surface surface(internal::Execution(), mesh,
                                             get(boost::vertex_index, mesh), point);
    internal::Flat_skeleton skeleton = internal::flat_skeleton(graph);
    skeleton.component_of.clear();
    skeleton.is_inlet.clear();
    internal::find_places(internal::Execution(), surface.mesh,
                          internal::places_of_vertices(internal::Execution(), surface), skeleton);
    return skeleton;
  };
  // Two cycles within the core, of which one is that of the surface around it; then one is not.
  Soup core = torus(2., 0.3, 8, 24);
  reverse_orientation(core);
  const Mesh hollow = mesh_of(together(torus(2., 0.9, 12, 24), core));
  for(const double radius : {2.1, 2.6}) {
    Graph graph;
    add_line(graph, wound(radius, 1, 0., 40), true);
    add_line(graph, wound(2., 1, 0., 40), true);
    const auto components = places_of(hollow, graph).component_of;
    EXPECT_EQ(std::count(components.begin(), components.end(), internal::Index(0)), 40);
    if(radius > 2.3) {
      EXPECT_EQ(components.front(), 0u);
    }
  }
  const Mesh vessel = mesh_of(pipe(4., 0.5, 9, 10));
  Graph line;
  add_line(line, {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}, false);
  EXPECT_EQ(places_of(vessel, line).is_inlet, (std::vector<char>{1, 0, 1}));
  Graph off;
  add_line(off, {{1e-6, 0, 0}, {2, 0, 0}, {3, 0, 0}}, false);
  EXPECT_EQ(places_of(vessel, off).is_inlet, (std::vector<char>{0, 0, 0}));
}

// ---- random lines

// In a tube, and in part out of it: whatever they do is said as it is by definition.
TEST(Skeleton_certificate, IsAsByDefinitionForRandomLines) {
  const Mesh mesh = theta_surface();
  std::mt19937 random(1);
  std::normal_distribution<double> shift(0., 0.12);
  for(int n = number_of_cases(40); n > 0; --n) {
    Graph graph = theta_graph();
    for(const auto v : CGAL::make_range(vertices(graph))) {
      const auto& p = graph[v].point;
      graph[v].point =
          Mesh::Point(p.x() + shift(random), p.y() + shift(random), p.z() + shift(random));
    }
    check(mesh, graph);
  }
}

// Between points of a grid of halves: along edges, through vertices, in planes of faces.
TEST(Skeleton_certificate, IsAsByDefinitionOnGrids) {
  const Mesh mesh = mesh_of(block_ring());
  const Pairs pairs = find_loops(mesh);
  std::mt19937 random(3);
  const auto up_to = [&random](int n) { return std::uniform_int_distribution<int>(0, n)(random); };
  // Around the hole, a step at a time between inner points of one block and the next.
  const std::array<std::array<int, 2>, 8> blocks = {
      {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
  int number_of_good_ones = 0;
  for(int n = number_of_cases(400); n > 0; --n) {
    Line line;
    const int turns = 1 + up_to(1), margin = up_to(1);
    for(int i = 0; i < 8 * turns; ++i) {
      const auto [x, y] = blocks[i % 8];
      line.emplace_back(2 * x + (margin + up_to(4 - 2 * margin)) / 2.,
                        2 * y + (margin + up_to(4 - 2 * margin)) / 2.,
                        (margin + up_to(4 - 2 * margin)) / 2.);
    }
    Graph graph;
    add_line(graph, line, true);
    for(int i = up_to(2); i > 0; --i)
      add_edge(up_to(int(line.size()) - 1),
               add_point(graph, {up_to(12) / 2., up_to(12) / 2., up_to(4) / 2.}), graph);
    number_of_good_ones += bool(check(mesh, graph, pairs));
  }
  EXPECT_GT(number_of_good_ones, 0);
}

TEST(Skeleton_certificate, DoesNotDependOnScaleNorPlace) {
  for(const double scale : {1e-150, 1e-5, 1e150})
    for(const double shift : {0., 1e4}) {
      const Soup soup = transformed(torus(2., 0.5, 8, 20), scale, scale * shift);
      Graph graph;
      for(const Vector& p : wound(2., 1, 0., 30))
        add_point(graph, scale * p + scale * shift * Vector(1, 1, 1));
      for(std::size_t i = 0; i < 30; ++i)
        add_edge(i, (i + 1) % 30, graph);
      EXPECT_TRUE(check(mesh_of(soup), graph));
      graph[0].point = graph[15].point;
      expect_failure(check(mesh_of(soup), graph), "leaves through face");
    }
}

// Small integers: in a plane, on a line, at one place.
TEST(Exact_meeting, IsAsByDefinition) {
  using namespace CGAL::Handle_tunnel_loops::internal;
  namespace definitions = skeleton_definitions;
  std::mt19937 random(2);
  const auto place = [&random] {
    std::uniform_int_distribution<int> number(-2, 2);
    return CGAL::Handle_tunnel_loops::internal::Vector{
        double(number(random)), double(number(random)), double(number(random)) / 2.};
  };
  for(int n = number_of_cases(20000); n > 0; --n) {
    const auto a = place(), b = place(), c = place(), d = place(), e = place();
    const Exact_segment s = {exact_point(a), exact_point(b)}, u = {exact_point(c), exact_point(d)};
    const Exact_triangle t = {exact_point(c), exact_point(d), exact_point(e)};
    const auto exact = [](const auto& p) { return definitions::exact_place({p[0], p[1], p[2]}); };
    const definitions::Exact::Segment_3 exact_s(exact(a), exact(b)), exact_u(exact(c), exact(d));
    const definitions::Exact::Triangle_3 exact_t(exact(c), exact(d), exact(e));
    if(exact_s.is_degenerate())
      continue;
    if(!exact_u.is_degenerate()) {
      EXPECT_EQ(do_meet(s, u), CGAL::do_intersect(exact_s, exact_u));
    }
    if(exact_t.is_degenerate())
      continue;
    EXPECT_EQ(do_meet(s, t), CGAL::do_intersect(exact_s, exact_t));
    if(exact(e) == exact(a) || exact(e) == exact(b))
      continue;
    if(a != c) {
      EXPECT_EQ(do_meet_beyond_corner(s[0], t),
                definitions::leads_along(exact(c), exact(a), exact_t));
    }
  }
}

} // namespace test_skeleton_certificate
