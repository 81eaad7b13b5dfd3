// A mesh of arrays is the surface that its triangles are, and it is refused if they are none.

#include "Meshes_of_soups.h"
#include "Number_of_cases.h"

#include "generators/Random.h"
#include "generators/generators.h"

#include <CGAL/Handle_tunnel_loops/Triangle_arrays.h>
#include <CGAL/Handle_tunnel_loops/certificate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/cut_to_disk.h>
#include <CGAL/reeb_graph.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace test_triangle_arrays {

namespace htl = CGAL::Handle_tunnel_loops;
using generators::Random;
using htl::Mesh_defect;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Arrays = htl::Triangle_arrays<Point>;
using Triangle = std::array<std::uint32_t, 3>;
using Triangles = std::vector<Triangle>;
using Side = std::pair<std::uint32_t, std::uint32_t>;

const Triangles tetrahedron = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};

std::vector<Point> some_points(std::size_t n) {
  std::vector<Point> points;
  for(std::size_t i = 0; i < n; ++i)
    points.emplace_back(double(i % 3), double(i * i), double(i));
  return points;
}

Triangles with(Triangles triangles, const Triangle& triangle) {
  triangles.push_back(triangle);
  return triangles;
}

// ---- definitions

// How many faces traverse each side in its direction.
std::map<Side, std::size_t> sides_of(const Triangles& triangles) {
  std::map<Side, std::size_t> sides;
  for(const Triangle& t : triangles)
    for(int i = 0; i < 3; ++i)
      ++sides[{t[i], t[(i + 1) % 3]}];
  return sides;
}

// Whether the corners at a vertex are all reached from one of them, in either direction.
bool is_one_fan(const Triangles& triangles, std::uint32_t v) {
  std::map<std::uint32_t, std::uint32_t> next; // from neighbor to neighbor across a face
  for(const Triangle& t : triangles)
    for(int i = 0; i < 3; ++i)
      if(t[i] == v)
        next[t[(i + 1) % 3]] = t[(i + 2) % 3];
  if(next.empty())
    return true;
  std::set<std::uint32_t> targets;
  for(const auto& [from, to] : next)
    targets.insert(to);
  std::uint32_t first = next.begin()->first;
  for(const auto& [from, to] : next)
    if(targets.count(from) == 0)
      first = from;
  std::size_t size = 0;
  std::uint32_t u = first;
  do {
    ++size;
    u = next[u];
  } while(u != first && next.count(u) != 0);
  return size == next.size();
}

std::optional<Mesh_defect> defect_by_definition(const Triangles& triangles, std::uint32_t n) {
  for(const Triangle& t : triangles)
    if(t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      return Mesh_defect::DEGENERATE_FACE;
  std::map<Side, std::size_t> edges; // by their smaller vertex, then the larger
  const std::map<Side, std::size_t> sides = sides_of(triangles);
  for(const auto& [side, number] : sides)
    edges[std::minmax(side.first, side.second)] += number;
  for(const auto& [edge, number] : edges)
    if(number > 2)
      return Mesh_defect::NON_MANIFOLD_EDGE;
    else if(number == 2 && sides.count(edge) != sides.count({edge.second, edge.first}))
      return Mesh_defect::INCONSISTENT_ORIENTATION;
  for(std::uint32_t v = 0; v < n; ++v)
    if(!is_one_fan(triangles, v))
      return Mesh_defect::NON_MANIFOLD_VERTEX;
  return std::nullopt;
}

template <typename Tag>
std::optional<Mesh_defect> defect_found(const Triangles& triangles, std::size_t n) {
  try {
    const Arrays mesh(Tag(), some_points(n), triangles);
    return std::nullopt;
  } catch(const htl::Invalid_mesh_exception& exception) {
    return exception.defect();
  }
}

// A halfedge for each side, one more where it is on the boundary, and all about them.
void expect_mesh_of(const Triangles& triangles, std::size_t n, const Arrays& mesh) {
  const std::map<Side, std::size_t> sides = sides_of(triangles);
  ASSERT_EQ(mesh.number_of_vertices(), n);
  ASSERT_EQ(mesh.number_of_faces(), triangles.size());
  std::set<Side> found;
  std::vector<char> is_used(n, 0);
  for(const auto h : mesh.halfedges()) {
    const Side side(source(h, mesh).idx(), target(h, mesh).idx());
    EXPECT_TRUE(found.insert(side).second);
    EXPECT_EQ(is_border(h, mesh), sides.count(side) == 0);
    EXPECT_EQ(source(opposite(h, mesh), mesh).idx(), side.second);
    EXPECT_EQ(target(opposite(h, mesh), mesh).idx(), side.first);
    EXPECT_EQ(prev(next(h, mesh), mesh), h);
    EXPECT_EQ(source(next(h, mesh), mesh).idx(), side.second);
    EXPECT_EQ(halfedge(source(h, mesh), target(h, mesh), mesh), std::make_pair(h, true));
    EXPECT_EQ(edge(h, mesh), edge(opposite(h, mesh), mesh));
    EXPECT_EQ(source(edge(h, mesh), mesh).idx(), side.first);
    is_used[side.first] = 1;
    if(is_border(h, mesh)) {
      EXPECT_TRUE(is_border(next(h, mesh), mesh));
      EXPECT_EQ(halfedge(target(h, mesh), mesh), h);
    }
  }
  for(const auto f : mesh.faces())
    for(int i = 0; i < 3; ++i) {
      const Arrays::Halfedge_index h(3 * f.idx() + i);
      EXPECT_EQ(source(h, mesh).idx(), triangles[f.idx()][i]);
      EXPECT_EQ(face(h, mesh), f);
    }
  for(const auto v : mesh.vertices())
    EXPECT_EQ(mesh.is_isolated(v), is_used[v.idx()] == 0);
  // CGAL's check takes a vertex without faces for a mistake.
  if(std::count(is_used.begin(), is_used.end(), 0) == 0) {
    EXPECT_TRUE(CGAL::is_valid_face_graph(mesh));
  }
  std::size_t number_of_edges = 0;
  for(const auto e : mesh.edges()) {
    EXPECT_EQ(e.idx(), mesh.halfedge(e).idx());
    EXPECT_LT(mesh.halfedge(e), mesh.opposite(mesh.halfedge(e)));
    ++number_of_edges;
  }
  EXPECT_EQ(number_of_edges, mesh.number_of_edges());
}

// ---- tests

TEST(Triangle_arrays, HaveTheHalfedgesOfTheirTriangles) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3}, 1))
    for(const std::size_t holes : {0, 3}) {
      SCOPED_TRACE(testing::Message() << recipe << ", " << holes << " holes");
      Soup soup = soup_of(recipe);
      if(holes != 0)
        soup = generators::with_holes(soup, {holes, 8, true, 0, true});
      if(holes != 0)
        soup.points.push_back({}); // without faces
      std::shuffle(soup.triangles.begin(), soup.triangles.end(), std::mt19937(1));
      const Triangles triangles(soup.triangles.begin(), soup.triangles.end());
      expect_mesh_of(triangles, soup.points.size(), mesh_of<Arrays>(soup));
    }
}

TEST(Triangle_arrays, AreAnyTrianglesThatAreASurface) {
  Random random(2);
  std::map<std::optional<Mesh_defect>, std::size_t> seen;
  for(int i = 0; i < number_of_cases(30000); ++i) {
    const std::uint32_t n = 3 + static_cast<std::uint32_t>(random.below(5));
    Triangles triangles(1 + random.below(6));
    for(Triangle& t : triangles)
      for(std::uint32_t& v : t)
        v = static_cast<std::uint32_t>(random.below(n));
    const auto defect = defect_by_definition(triangles, n);
    ++seen[defect];
    ASSERT_EQ(defect_found<CGAL::Sequential_tag>(triangles, n).has_value(), defect.has_value());
    if(!defect)
      expect_mesh_of(triangles, n, Arrays(some_points(n), triangles));
  }
  EXPECT_GT(seen[std::nullopt], 50u);
  EXPECT_GT(seen[Mesh_defect::NON_MANIFOLD_VERTEX], 10u);
}

// One thing at a time is wrong, so that there is no choice.
TEST(Triangle_arrays, SayWhatKeepsThemFromBeingASurface) {
  Triangles two_at_a_vertex = tetrahedron;
  for(const Triangle& t : tetrahedron)
    two_at_a_vertex.push_back({t[0] + 3, t[1] + 3, t[2] + 3});
  Triangles flipped = tetrahedron;
  std::swap(flipped[2][0], flipped[2][1]);
  const std::map<Mesh_defect, Triangles> cases = {
      {Mesh_defect::DEGENERATE_FACE, with(tetrahedron, {4, 5, 4})},
      {Mesh_defect::NON_MANIFOLD_EDGE, with(tetrahedron, {0, 1, 4})},
      {Mesh_defect::INCONSISTENT_ORIENTATION, flipped},
      {Mesh_defect::NON_MANIFOLD_VERTEX, two_at_a_vertex}};
  for(const auto& [defect, triangles] : cases) {
    EXPECT_EQ(defect_by_definition(triangles, 7), defect);
    EXPECT_EQ(defect_found<CGAL::Sequential_tag>(triangles, 7), defect);
    EXPECT_EQ(defect_found<CGAL::Parallel_if_available_tag>(triangles, 7), defect);
  }
  const Triangles two_at_a_corner = {{0, 1, 2}, {0, 3, 4}};
  EXPECT_EQ(defect_found<CGAL::Sequential_tag>(two_at_a_corner, 5),
            Mesh_defect::NON_MANIFOLD_VERTEX);
}

TEST(Triangle_arrays, NameTheElement) {
  const auto vertices_of_defect = [](const Triangles& triangles) {
    try {
      const Arrays mesh(some_points(6), triangles);
    } catch(const htl::Invalid_mesh_exception& exception) {
      return exception.vertices();
    }
    return std::vector<std::size_t>();
  };
  using Numbers = std::vector<std::size_t>;
  EXPECT_EQ(vertices_of_defect(with(tetrahedron, {4, 5, 4})), (Numbers{4, 5, 4}));
  EXPECT_EQ(vertices_of_defect(with(tetrahedron, {3, 4, 1})), (Numbers{1, 3}));
  EXPECT_EQ(vertices_of_defect({{5, 1, 2}, {5, 3, 4}}), Numbers{5});
}

TEST(Triangle_arrays, AreOfTrianglesOfPointsThatAreThere) {
  EXPECT_THROW(Arrays(some_points(3), tetrahedron), std::out_of_range);
  const std::vector<std::vector<int>> negative = {{0, 1, -1}}, four = {{0, 1, 2}, {0, 1, 2, 3}};
  EXPECT_THROW(Arrays(some_points(3), negative), std::out_of_range);
  try {
    const Arrays mesh(some_points(4), four);
    FAIL();
  } catch(const htl::Invalid_mesh_exception& exception) {
    EXPECT_EQ(exception.defect(), Mesh_defect::NOT_TRIANGULATED);
  }
}

TEST(Triangle_arrays, AreTheSameForAnyNumberOfThreads) {
  const Soup soup =
      generators::with_holes(soup_of(Recipe{"gyroid", {60000, 5, 1}}), {20, 12, true});
  std::vector<Point> points;
  for(const auto& [x, y, z] : soup.points)
    points.emplace_back(x, y, z);
  const Arrays a(points, soup.triangles),
      b(CGAL::Parallel_if_available_tag(), points, soup.triangles);
  ASSERT_EQ(a.number_of_halfedges(), b.number_of_halfedges());
  for(const auto h : a.halfedges()) {
    ASSERT_EQ(source(h, a), source(h, b));
    ASSERT_EQ(opposite(h, a), opposite(h, b));
    ASSERT_EQ(next(h, a), next(h, b));
  }
  for(const auto v : a.vertices())
    ASSERT_EQ(halfedge(v, a), halfedge(v, b));
}

// Whatever takes a model of FaceListGraph takes them.
TEST(Triangle_arrays, HaveTheLoopsOfTheSurface) {
  for(const std::size_t holes : {0, 2}) {
    Soup soup = soup_of(Recipe{"multi-torus", {3000, 3, 0}});
    if(holes != 0)
      soup = generators::with_holes(soup, {holes, 12, false});
    const Arrays mesh = mesh_of<Arrays>(soup);
    const auto pairs = find_loops(mesh);
    EXPECT_EQ(pairs.size(), 3u);
    EXPECT_TRUE(bool(CGAL::certify_handle_tunnel_loops(mesh, pairs)));
    EXPECT_NEAR(total_length(pairs), total_length(find_loops(mesh_of(soup))),
                0.02 * total_length(pairs));
    CGAL::Reeb_graph<Arrays> graph;
    CGAL::reeb_graph(mesh, graph);
    EXPECT_EQ(num_edges(graph) + 1 - num_vertices(graph), 3u);
    std::vector<Arrays::Edge_index> cut;
    CGAL::cut_to_disk(mesh, std::back_inserter(cut));
    EXPECT_FALSE(cut.empty());
  }
}

TEST(Triangle_arrays, AreWalkedAroundVertices) {
  const Arrays mesh(some_points(4), tetrahedron);
  for(const auto v : mesh.vertices()) {
    EXPECT_EQ(degree(v, mesh), 3u);
    const auto [out, end_of_out] = out_edges(v, mesh);
    const auto [in, end_of_in] = in_edges(v, mesh);
    EXPECT_EQ(std::distance(out, end_of_out), 3);
    EXPECT_EQ(std::distance(in, end_of_in), 3);
    EXPECT_EQ(source(*out, mesh), v);
    EXPECT_EQ(target(*in, mesh), v);
  }
}

} // namespace test_triangle_arrays
