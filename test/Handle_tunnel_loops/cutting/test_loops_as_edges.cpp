// Loops as walks of halfedges: closed, in the classes of the loops, short, and simple where it can
// be.

#include "Flat_torus.h"
#include "Loop_definitions.h"
#include "Meshes_of_soups.h"
#include "random_input.h"

#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Walk_improvement.h>
#include <CGAL/Handle_tunnel_loops/loops_as_edges.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace test_loops_as_edges {

using namespace CGAL::Handle_tunnel_loops::internal;
using generators::Random;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;

template <typename TriangleMesh, typename Loop>
Edge_walk<TriangleMesh> walk_of(const TriangleMesh& tm, const Loop& loop) {
  Edge_walk<TriangleMesh> walk;
  CGAL::loop_to_halfedges(loop, tm, std::back_inserter(walk));
  return walk;
}

template <typename TriangleMesh>
bool is_closed(const TriangleMesh& tm, const Edge_walk<TriangleMesh>& walk) {
  for(std::size_t i = 0; i < walk.size(); ++i)
    if(target(walk[i], tm) != source(walk[(i + 1) % walk.size()], tm))
      return false;
  return walk.size() >= 3;
}

template <typename TriangleMesh>
bool is_simple(const TriangleMesh& tm, const Edge_walk<TriangleMesh>& walk) {
  std::set<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  for(const auto h : walk)
    vertices.insert(target(h, tm));
  return vertices.size() == walk.size();
}

template <typename TriangleMesh>
double length_of(const TriangleMesh& tm, const Edge_walk<TriangleMesh>& walk) {
  double sum = 0.;
  const auto point = get(CGAL::vertex_point, tm);
  for(const auto h : walk)
    sum += distance(coordinates(get(point, source(h, tm))), coordinates(get(point, target(h, tm))));
  return sum;
}

// The walks have the intersection numbers of the loops, with each other and with the loops.
template <typename TriangleMesh, typename PairRange>
void expect_classes_of_loops(const TriangleMesh& tm, const PairRange& pairs) {
  std::vector<Edge_walk<TriangleMesh>> walks;
  for(const auto& pair : pairs)
    for(const auto* loop : {&pair.handle(), &pair.tunnel()})
      walks.push_back(walk_beside(tm, *loop));
  const std::size_t n = walks.size();
  for(const auto& pair : pairs)
    for(const auto* loop : {&pair.handle(), &pair.tunnel()}) {
      walks.push_back(walk_of(tm, *loop));
      ASSERT_TRUE(is_closed(tm, walks.back()));
      EXPECT_LE(length_of(tm, walks.back()), length_of(tm, walks[walks.size() - 1 - n]) * 1.5);
    }
  const Integer_matrix matrix = intersection_matrix(tm, walks);
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j) {
      EXPECT_EQ(matrix[i][j], matrix[n + i][j]);
      EXPECT_EQ(matrix[i][j], matrix[n + i][n + j]);
    }
}

// ---- the walk beside a loop

double length_of_choice(const std::vector<Edge_ends>& places,
                        const std::vector<std::vector<double>>& length,
                        std::size_t choice) {
  double sum = 0.;
  for(std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t next = (i + 1) % places.size();
    sum += length[places[i][choice >> i & 1]][places[next][choice >> next & 1]];
  }
  return sum;
}

TEST(Walk_beside, IsTheShortestOfAll) {
  Random random(1);
  for(int round = 0; round < 300; ++round) {
    const std::size_t number_of_vertices = 3 + random.below(6), n = 1 + random.below(9);
    std::vector<std::vector<double>> length(number_of_vertices,
                                            std::vector<double>(number_of_vertices, 0.));
    for(std::size_t u = 0; u < number_of_vertices; ++u)
      for(std::size_t v = 0; v < u; ++v)
        length[u][v] = length[v][u] = random.uniform(0., 1.);
    std::vector<Edge_ends> places(n);
    for(Edge_ends& place : places)
      place = {static_cast<Index>(random.below(number_of_vertices)),
               static_cast<Index>(random.below(number_of_vertices))};
    double best = (std::numeric_limits<double>::max)();
    for(std::size_t choice = 0; choice < std::size_t(1) << n; ++choice)
      best = (std::min)(best, length_of_choice(places, length, choice));
    const std::vector<Index> walk =
        places_of_shortest_walk_beside(places, [&](Index u, Index v) { return length[u][v]; });
    ASSERT_EQ(walk.size(), n);
    double sum = 0.;
    for(std::size_t i = 0; i < n; ++i) {
      EXPECT_TRUE(walk[i] == places[i][0] || walk[i] == places[i][1]);
      sum += length[walk[i]][walk[(i + 1) % n]];
    }
    EXPECT_NEAR(sum, best, 1e-12);
  }
  EXPECT_TRUE(shortest_walk_beside({}, [](Index, Index) { return 1.; }).empty());
}

// ---- the halfedges of arrays

TEST(Flat_halfedges, AreThoseOfTheFaces) {
  Random random(2);
  for(int round = 0; round < 30; ++round) {
    const Flat_mesh mesh = flat_mesh_of(random_recipe(random, 4));
    const Flat_halfedges halfedges(Execution(), mesh);
    std::vector<int> size_of_face(mesh.number_of_faces(), 0);
    for(Index h = 0; h < halfedges.size(); ++h) {
      const Index twin = halfedges.twin(h);
      ASSERT_EQ(halfedges.twin(twin), h);
      EXPECT_EQ(halfedges.source(twin), halfedges.target(h));
      EXPECT_EQ(halfedges.target(twin), halfedges.source(h));
      EXPECT_EQ(halfedges.after(halfedges.before(h)), h);
      EXPECT_EQ(halfedges.next(halfedges.next(halfedges.next(h))), h);
      EXPECT_EQ(halfedges.face(halfedges.next(h)), halfedges.face(h));
      EXPECT_EQ(halfedges.between(halfedges.source(h), halfedges.target(h)), h);
      ++size_of_face[halfedges.face(h)];
    }
    EXPECT_EQ(std::count(size_of_face.begin(), size_of_face.end(), 3),
              static_cast<std::ptrdiff_t>(mesh.number_of_faces()));
  }
}

// ---- loops

TEST(Loops_as_edges, AreInTheClassesOfTheLoops) {
  Random random(3);
  for(int round = 0; round < 60; ++round) {
    const Recipe recipe = random_recipe(random, 6);
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Mesh mesh = mesh_of(recipe);
    expect_classes_of_loops(mesh, find_loops(mesh));
  }
}

TEST(Loops_as_edges, AreThoseOfPolyhedraToo) {
  const Recipe recipe = {"random", {400, 3, 4}};
  const Mesh mesh = mesh_of(recipe);
  const auto polyhedron = mesh_of<Polyhedron>(soup_of(recipe));
  std::vector<CGAL::Handle_tunnel_pair<Polyhedron>> pairs;
  CGAL::handle_tunnel_loops(polyhedron, std::back_inserter(pairs));
  expect_classes_of_loops(polyhedron, pairs);
  const Pairs same = find_loops(mesh);
  for(std::size_t k = 0; k < pairs.size(); ++k)
    EXPECT_DOUBLE_EQ(length_of(polyhedron, walk_of(polyhedron, pairs[k].tunnel())),
                     length_of(mesh, walk_of(mesh, same[k].tunnel())));
}

// On meshes that are not coarse nothing stands in the way of simple walks, nearly as short as
// loops.
TEST(Loops_as_edges, AreSimpleAndShortOnFineMeshes) {
  for(const char* kind : {"torus", "knot", "multi-torus", "lattice", "gyroid", "sponge"}) {
    const std::size_t genus = has_genus(kind, 5) ? 5 : 1;
    const Mesh mesh = mesh_of(Recipe{kind, {3000 + 1000 * genus, genus, 1}});
    SCOPED_TRACE(kind);
    for(const auto& pair : find_loops(mesh))
      for(const auto* loop : {&pair.handle(), &pair.tunnel()}) {
        const auto walk = walk_of(mesh, *loop);
        EXPECT_TRUE(is_simple(mesh, walk));
        EXPECT_LE(length_of(mesh, walk), 1.2 * loop->length());
      }
  }
}

// A loop of one step after the other around a vertex is none.
TEST(Loops_as_edges, OfAContractibleLoopAreNone) {
  const Mesh mesh = mesh_of(Recipe{"torus", {400, 1, 0}});
  using Loop = Pairs::value_type::Loop;
  std::vector<Loop::Step> steps;
  for(const auto h : CGAL::halfedges_around_source(Mesh::Vertex_index(0), mesh))
    steps.push_back({h, 0.5});
  std::reverse(steps.begin(), steps.end());
  EXPECT_TRUE(walk_of(mesh, Loop(steps, {}, 0., CGAL::Loop_type::HANDLE, 0)).empty());
  EXPECT_TRUE(walk_of(mesh, Loop()).empty());
}

TEST(Loops_as_edges, AreRefusedOffTheSurface) {
  const Mesh mesh = mesh_of(Recipe{"torus", {400, 1, 0}});
  using Loop = Pairs::value_type::Loop;
  const Mesh::Halfedge_index h(0);
  Mesh::Halfedge_index far = h;
  for(int i = 0; i < 10; ++i)
    far = mesh.next(mesh.opposite(mesh.next(mesh.next(mesh.opposite(mesh.next(far))))));
  Mesh::Halfedge_index other(mesh.number_of_halfedges() / 2);
  ASSERT_NE(mesh.target(other), mesh.source(h));
  const Loop loop({{h, 0.}, {other, 1.}}, {}, 0., CGAL::Loop_type::HANDLE, 0);
  EXPECT_THROW(walk_of(mesh, loop), std::invalid_argument);
}

// What the marks are for: one loop does not separate, and two parallel ones would.
TEST(Loop_edges, CanBeMarkedAsWalls) {
  Mesh mesh = mesh_of(Recipe{"torus", {2000, 1, 0}});
  const Pairs pairs = find_loops(mesh);
  auto marks = mesh.add_property_map<Mesh::Edge_index, bool>("e:loop", false).first;
  CGAL::mark_loop_edges(pairs, mesh, marks);
  std::size_t marked = 0;
  for(const auto e : mesh.edges())
    marked += marks[e];
  EXPECT_GE(marked, walk_of(mesh, pairs[0].handle()).size());
  EXPECT_LE(marked,
            walk_of(mesh, pairs[0].handle()).size() + walk_of(mesh, pairs[0].tunnel()).size());
  auto pieces = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:piece", 0).first;
  EXPECT_EQ(CGAL::Polygon_mesh_processing::connected_components(
                mesh, pieces, CGAL::parameters::edge_is_constrained_map(marks)),
            1u);
  auto others = mesh.add_property_map<Mesh::Edge_index, bool>("e:other", false).first;
  CGAL::mark_loop_edges(std::vector{pairs[0].handle(), pairs[0].tunnel()}, mesh, others);
  for(const auto e : mesh.edges())
    EXPECT_EQ(marks[e], others[e]);
}

} // namespace test_loops_as_edges
