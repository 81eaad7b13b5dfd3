// Curve skeletons are what they are to be, by definition, on surfaces of all kinds; and an answer
// that is not certified says why.

#include "Generated_soups.h"
#include "Meshes_of_soups.h"
#include "Skeleton_checks.h"
#include "Skeleton_definitions.h"
#include "Solids.h"

#include "generators/Random.h"

#include <CGAL/curve_skeleton.h>

#include <boost/graph/adjacency_list.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_curve_skeleton {

using Graph = CGAL::Curve_skeleton<Mesh>;
using CGAL::Handle_tunnel_loops::Skeleton_options;
using CGAL::Handle_tunnel_loops::Skeleton_statistics;
using Place = skeleton_definitions::Place;

Place place_of(const Mesh::Point& p) { return {p.x(), p.y(), p.z()}; }

// ---- distances

double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Place difference(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double distance_to_line(const Place& p, const Place& a, const Place& b) {
  const Place along = difference(b, a), to = difference(p, a);
  const double square = dot(along, along);
  const double t = square > 0. ? std::clamp(dot(to, along) / square, 0., 1.) : 0.;
  const Place off = {to[0] - t * along[0], to[1] - t * along[1], to[2] - t * along[2]};
  return std::sqrt(dot(off, off));
}

// In the plane of the triangle, if the foot of the point is in it, or else to a side.
double distance_to_triangle(const Place& p, const std::array<Place, 3>& t) {
  double least = std::numeric_limits<double>::infinity();
  for(int k = 0; k < 3; ++k)
    least = (std::min)(least, distance_to_line(p, t[k], t[(k + 1) % 3]));
  const auto cross = [](const Place& a, const Place& b) -> Place {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const Place normal = cross(difference(t[1], t[0]), difference(t[2], t[0]));
  const double square = dot(normal, normal);
  bool is_above = square > 0.;
  for(int k = 0; k < 3; ++k)
    is_above =
        is_above && dot(cross(difference(t[(k + 1) % 3], t[k]), difference(p, t[k])), normal) >= 0.;
  return is_above ? std::abs(dot(normal, difference(p, t[0]))) / std::sqrt(square) : least;
}

double distance_to_surface(const Place& p, const Mesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for(const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    least = (std::min)(
        least, distance_to_triangle(p, {place_of(mesh.point(source(h, mesh))),
                                        place_of(mesh.point(target(h, mesh))),
                                        place_of(mesh.point(target(next(h, mesh), mesh)))}));
  }
  return least;
}

// ---- what holds of each answer

std::vector<std::size_t> degrees(const Graph& graph) {
  std::vector<std::size_t> degree(num_vertices(graph), 0);
  for(const auto e : CGAL::make_range(edges(graph))) {
    ++degree[source(e, graph)];
    ++degree[target(e, graph)];
  }
  return degree;
}

void expect_right_radii(const Mesh& mesh, const Graph& graph) {
  for(const auto v : CGAL::make_range(vertices(graph))) {
    const double distance = distance_to_surface(place_of(graph[v].point), mesh);
    EXPECT_NEAR(graph[v].radius, distance, 1e-9 * distance);
  }
}

// Each vertex that has a face belongs to one point, of its component.
template <typename AnyGraph> void expect_shared_vertices(const Mesh& mesh, const AnyGraph& graph) {
  std::map<Mesh::Vertex_index, int> times;
  for(const auto v : CGAL::make_range(vertices(graph)))
    for(const auto of_mesh : graph[v].vertices)
      ++times[of_mesh];
  for(const auto v : vertices(mesh))
    EXPECT_EQ(times[v], mesh.is_isolated(v) ? 0 : 1);
}

void expect_inlets(const Mesh& mesh, const Graph& graph, std::size_t number_of_boundaries) {
  const std::vector<std::size_t> degree = degrees(graph);
  std::size_t number = 0;
  for(const auto v : CGAL::make_range(vertices(graph)))
    if(graph[v].is_inlet) {
      ++number;
      EXPECT_EQ(degree[v], 1u);
    }
  std::set<Mesh::Halfedge_index> seen;
  std::size_t curves = 0;
  for(const auto first : halfedges(mesh))
    if(is_border(first, mesh) && seen.count(first) == 0) {
      ++curves;
      for(auto h = first; seen.insert(h).second;)
        h = next(h, mesh);
    }
  EXPECT_EQ(number, curves);
  EXPECT_EQ(number_of_boundaries, curves);
}

void expect_same(const Graph& a, const Graph& b) {
  ASSERT_EQ(num_vertices(a), num_vertices(b));
  for(const auto v : CGAL::make_range(vertices(a))) {
    EXPECT_EQ(a[v].point, b[v].point);
    EXPECT_EQ(a[v].radius, b[v].radius);
    EXPECT_EQ(a[v].component, b[v].component);
    EXPECT_EQ(a[v].is_inlet, b[v].is_inlet);
    EXPECT_EQ(a[v].vertices, b[v].vertices);
  }
  EXPECT_EQ(skeleton_definitions::skeleton_of(a).edges, skeleton_definitions::skeleton_of(b).edges);
}

Graph skeleton_of(const Mesh& mesh, double shortest_limb = Skeleton_options().shortest_limb) {
  Graph graph;
  Skeleton_options options;
  options.shortest_limb = shortest_limb;
  const Skeleton_statistics statistics =
      CGAL::curve_skeleton(mesh, graph, CGAL::parameters::skeleton_options(options));
  EXPECT_TRUE(statistics.certificate) << statistics.certificate.failure;
  expect_shared_vertices(mesh, graph);
  expect_inlets(mesh, graph, statistics.number_of_boundaries);
  return graph;
}

void expect_truth(const Mesh& mesh, const Graph& graph) {
  const auto truth =
      skeleton_definitions::truth(mesh, skeleton_definitions::skeleton_of(graph), find_loops(mesh));
  EXPECT_TRUE(truth.is_connected);
  EXPECT_TRUE(truth.is_inside);
  EXPECT_TRUE(truth.is_embedded);
  EXPECT_TRUE(truth.is_basis);
}

Graph expect_skeleton(const Mesh& mesh) {
  const Graph graph = skeleton_of(mesh);
  expect_truth(mesh, graph);
  expect_right_radii(mesh, graph);
  return graph;
}

// ---- coarse surfaces

/// Plates of a regular grid, one above the other; prisms of three sides lead through a plate, or
/// from one to the next.
class Plates
{
public:
  explicit Plates(int size)
      : size_(size) {}

  /// with prisms through it, one after the other, at places that are not beside each other.
  Soup bored(double thickness, int number) const {
    Soup soup;
    add_plate(soup, 0., thickness, number, number);
    add_prisms(soup, 0, layer(), number, true);
    return soup;
  }

  /// two, on as many columns.
  Soup on_columns(double thickness, double gap, int number) const {
    Soup soup;
    add_plate(soup, 0., thickness, 0, number);
    add_plate(soup, thickness + gap, 2 * thickness + gap, number, 0);
    add_prisms(soup, layer(), 2 * layer(), number, false);
    return soup;
  }

private:
  std::uint32_t layer() const { return static_cast<std::uint32_t>((size_ + 1) * (size_ + 1)); }
  std::uint32_t at(int i, int j) const { return static_cast<std::uint32_t>(i * (size_ + 1) + j); }

  // The cells of which a half is left out for prisms.
  bool is_open(int i, int j, int number) const {
    const int in_row = (size_ - 1) / 2;
    return i % 2 == 1 && j % 2 == 1 && i < size_ && j < size_ &&
           (i / 2) * in_row + j / 2 < number && j / 2 < in_row;
  }

  void add_plate(Soup& soup, double low, double high, int open_below, int open_above) const {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for(const double z : {low, high})
      for(int i = 0; i <= size_; ++i)
        for(int j = 0; j <= size_; ++j)
          soup.points.push_back({double(i), double(j), z});
    const std::uint32_t top = first + layer();
    for(int i = 0; i < size_; ++i)
      for(int j = 0; j < size_; ++j) {
        const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
        soup.triangles.push_back({top + a, top + c, top + d});
        soup.triangles.push_back({first + a, first + d, first + c});
        if(!is_open(i, j, open_above))
          soup.triangles.push_back({top + a, top + b, top + c});
        if(!is_open(i, j, open_below))
          soup.triangles.push_back({first + a, first + c, first + b});
      }
    const auto add_wall = [&](std::uint32_t u, std::uint32_t v) {
      soup.triangles.push_back({first + u, first + v, top + v});
      soup.triangles.push_back({first + u, top + v, top + u});
    };
    for(int k = 0; k < size_; ++k) {
      add_wall(at(k, 0), at(k + 1, 0));
      add_wall(at(size_, k), at(size_, k + 1));
      add_wall(at(k + 1, size_), at(k, size_));
      add_wall(at(0, k + 1), at(0, k));
    }
  }

  void
  add_prisms(Soup& soup, std::uint32_t low, std::uint32_t high, int number, bool is_hole) const {
    for(int i = 0; i < size_; ++i)
      for(int j = 0; j < size_; ++j) {
        if(!is_open(i, j, number))
          continue;
        const std::array corners = {at(i, j), at(i + 1, j), at(i + 1, j + 1)};
        for(int k = 0; k < 3; ++k) {
          std::uint32_t u = corners[k], v = corners[(k + 1) % 3];
          if(is_hole)
            std::swap(u, v);
          soup.triangles.push_back({low + u, low + v, high + v});
          soup.triangles.push_back({low + u, high + v, high + u});
        }
      }
  }

  int size_;
};

Soup box() { return Plates(1).bored(1., 0); }

Soup tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

// Along a side, a face without area between its two faces, for some of the faces.
Soup with_degenerate_faces(Soup soup) {
  const std::size_t n = soup.triangles.size();
  std::map<std::array<std::uint32_t, 2>, std::size_t> left; // face of a halfedge
  for(std::size_t t = 0; t < n; ++t)
    for(int k = 0; k < 3; ++k)
      left[{soup.triangles[t][k], soup.triangles[t][(k + 1) % 3]}] = t;
  std::vector<bool> is_used(n, false);
  for(std::size_t t = 0; t < n; ++t) {
    if(is_used[t])
      continue;
    const std::uint32_t a = soup.triangles[t][0], b = soup.triangles[t][1];
    const std::size_t other = left.at({b, a});
    if(is_used[other])
      continue;
    is_used[t] = is_used[other] = true;
    std::uint32_t d = 0;
    for(const std::uint32_t v : soup.triangles[other])
      if(v != a && v != b)
        d = v;
    const auto m = static_cast<std::uint32_t>(soup.points.size());
    const auto p = soup.points[a], q = soup.points[b];
    soup.points.push_back({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])});
    soup.triangles[other] = {m, a, d};
    soup.triangles.push_back({b, m, d});
    soup.triangles.push_back({b, a, m});
  }
  return soup;
}

// ---- tests

TEST(Curve_skeleton, IsASkeletonByDefinition) {
  for(const Recipe& recipe : std::vector<Recipe>{{"lattice", {900, 2, 1}},
                                                 {"foam", {1200, 1, 2}},
                                                 {"gyroid", {1000, 2, 3}},
                                                 {"sponge", {160, 3, 4}},
                                                 {"plates", {120, 5, 5}},
                                                 {"bars", {150, 6, 6, 2}},
                                                 {"chain", {300, 3, 7}},
                                                 {"multi-torus", {600, 2, 8}},
                                                 {"hubs", {160, 4, 9}},
                                                 {"interlaced", {1400, 1, 10}},
                                                 {"shell", {1600, 1, 11}}})
  {
    SCOPED_TRACE(testing::PrintToString(recipe));
    expect_skeleton(mesh_of(recipe));
  }
}

TEST(Curve_skeleton, IsASkeletonOfRandomSurfaces) {
  generators::Random random(1);
  const std::array<const char*, 9> kinds = {"lattice", "foam",  "gyroid", "sponge",     "plates",
                                            "bars",    "chain", "hubs",   "multi-torus"};
  for(int i = 0; i < number_of_cases(60); ++i) {
    const std::string kind = kinds[random.below(kinds.size())];
    const std::size_t genus = 3 + random.below(are_few_cases_tried() ? 6 : 28);
    const bool is_of_tubes = kind == "lattice" || kind == "foam" || kind == "gyroid";
    const std::size_t faces = is_of_tubes             ? 600 + 600 * genus
                              : kind == "multi-torus" ? 200 + 250 * genus
                                                      : 60 + 75 * genus;
    const Recipe recipe = {kind, {faces, genus, static_cast<unsigned>(random.next())}};
    SCOPED_TRACE(testing::PrintToString(recipe));
    expect_skeleton(mesh_of(recipe));
  }
}

TEST(Curve_skeleton, HasCyclesThroughHandlesOfThreeTriangles) {
  for(const double thickness : {2., 0.2, 1e-3}) {
    SCOPED_TRACE(thickness);
    expect_skeleton(mesh_of(Plates(7).bored(thickness, 7)));
    expect_skeleton(mesh_of(Plates(5).on_columns(thickness, 1., 3)));
  }
}

TEST(Curve_skeleton, IsInsideOfNestedShells) {
  std::vector<Soup> soups = {hollow_ring(), linked_rings()};
  if(!are_few_cases_tried())
    for(const Soup& large : {ball_with_ring_cavity(), trefoil_tube(), ring_within_shells()})
      soups.push_back(large);
  for(const Soup& soup : soups)
    expect_skeleton(mesh_of(soup));
}

// Rings in the core of rings, by turns solid and void, and round voids beside each other.
TEST(Curve_skeleton, LiesInTheWallsOfRandomNests) {
  generators::Random random(1);
  for(int i = 0; i < number_of_cases(8); ++i) {
    SCOPED_TRACE(i);
    Soup soup;
    double radius = 0.9;
    for(std::size_t depth = 0, depths = 2 + random.below(3); depth < depths; ++depth) {
      Soup ring = skeleton_checks::torus(2., radius, 8, 30);
      if(depth % 2 != 0)
        reverse_orientation(ring);
      soup = skeleton_checks::together(std::move(soup), ring);
      radius *= random.uniform(0.2, 0.9);
    }
    Soup ball = transformed(soup_of({"sphere", {300, 0, 0}}), 3., 20.);
    for(const double shift : {-0.8, 0.8}) {
      Soup hole =
          transformed(soup_of({"sphere", {80, 0, 0}}), random.uniform(0.1, 1.2), 20. + shift);
      reverse_orientation(hole);
      ball = skeleton_checks::together(std::move(ball), hole);
    }
    expect_skeleton(mesh_of(skeleton_checks::together(std::move(soup), ball)));
  }
}

TEST(Curve_skeleton, HasAnInletAtEachBoundaryCurve) {
  for(const bool is_ragged : {false, true})
    for(const Recipe& recipe : std::vector<Recipe>{
            {"lattice", {1500, 3, 1}}, {"multi-torus", {1200, 2, 2}}, {"sphere", {500, 0, 3}}})
    {
      SCOPED_TRACE(testing::PrintToString(recipe));
      const Soup soup = generators::with_holes(soup_of(recipe), {3, 8, is_ragged, 1});
      ASSERT_EQ(generators::number_of_boundaries(soup), 3u);
      const Mesh mesh = mesh_of(soup);
      expect_truth(mesh, skeleton_of(mesh));
    }
}

// Walls between two copies of a polygon, which is open below and above.
Soup walls(const std::vector<std::array<double, 2>>& polygon, double height) {
  Soup soup;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for(const double z : {0., height})
    for(const auto& p : polygon)
      soup.points.push_back({p[0], p[1], z});
  for(std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    soup.triangles.push_back({i, j, n + j});
    soup.triangles.push_back({i, n + j, n + i});
  }
  return soup;
}

// The middles of their vertices lie outside.
TEST(Curve_skeleton, HasInletsAtCurvesThatWind) {
  const Soup c = walls({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {4, 3}, {4, 4}, {0, 4}}, 3.);
  const Soup spiral = walls({{0, 0},
                             {6, 0},
                             {6, 5},
                             {2, 5},
                             {2, 2},
                             {4, 2},
                             {4, 3},
                             {3, 3},
                             {3, 4},
                             {5, 4},
                             {5, 1},
                             {1, 1},
                             {1, 6},
                             {0, 6}},
                            2.);
  for(const Soup& soup : {c, generators::reversed(c), spiral}) {
    const Mesh mesh = mesh_of(soup);
    expect_truth(mesh, skeleton_of(mesh));
  }
}

// The means of their vertices lie in their plane, but for rounding: a cap there would leave no
// room.
TEST(Curve_skeleton, IsInsideOfFlatPiecesAndTheirCaps) {
  const Soup triangle = {{{0.4800198, -0.36519819, 0.79762853},
                          {0.79050479, -0.58457007, -0.18270195},
                          {0.89951939, 0.38958253, 0.19771273}},
                         {{0, 1, 2}}};
  Soup square;
  for(std::uint32_t i = 0; i < 4; ++i)
    for(std::uint32_t j = 0; j < 4; ++j) {
      square.points.push_back({0.1 * i, 0.3 * j, 0.7 * i - 0.9 * j});
      if(const std::uint32_t a = 4 * i + j; i < 3 && j < 3) {
        square.triangles.push_back({a, a + 4, a + 5});
        square.triangles.push_back({a, a + 5, a + 1});
      }
    }
  // The cap is farther from its curve than any ball is large.
  Soup within = transformed(soup_of({"sphere", {180, 0, 0}}), 3., 0.);
  const auto first = static_cast<std::uint32_t>(within.points.size());
  within.points.insert(within.points.end(), triangle.points.begin(), triangle.points.end());
  within.triangles.push_back({first, first + 1, first + 2});
  for(const Soup& soup : {triangle, square, within}) {
    const Mesh mesh = mesh_of(soup);
    expect_truth(mesh, skeleton_of(mesh));
  }
}

TEST(Curve_skeleton, DoesNotDependOnHowASurfaceWithBoundaryIsOriented) {
  const Soup soup = generators::with_holes(soup_of({"lattice", {1500, 3, 1}}), {3, 8, false, 1});
  const Mesh mesh = mesh_of(generators::reversed(soup));
  expect_truth(mesh, skeleton_of(mesh));
}

TEST(Curve_skeleton, DoesNotDependOnTheNumberOfThreads) {
  for(const Recipe& recipe :
      std::vector<Recipe>{{"lattice", {900, 2, 1}}, {"plates", {200, 6, 5, 2}}})
  {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Mesh mesh = mesh_of(recipe);
    Graph parallel;
    CGAL::curve_skeleton<CGAL::Parallel_if_available_tag>(mesh, parallel);
    expect_same(skeleton_of(mesh), parallel);
  }
}

// As Mean_curvature_flow_skeletonization::Vmap.
struct Point_and_vertices
{
  Mesh::Point point;
  std::vector<Mesh::Vertex_index> vertices;
};

TEST(Curve_skeleton, FillsTheGraphsOfMeanCurvatureFlowSkeletons) {
  const Mesh mesh = mesh_of(Recipe{"multi-torus", {600, 2, 1}});
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Point_and_vertices> other;
  EXPECT_TRUE(CGAL::curve_skeleton(mesh, other).certificate);
  const Graph graph = skeleton_of(mesh);
  expect_shared_vertices(mesh, other);
  ASSERT_EQ(num_vertices(other), num_vertices(graph));
  EXPECT_EQ(num_edges(other), num_edges(graph));
  for(const auto v : CGAL::make_range(vertices(graph))) {
    EXPECT_EQ(other[v].point, graph[v].point);
    EXPECT_EQ(other[v].vertices, graph[v].vertices);
  }
}

TEST(Curve_skeleton, SaysWhyNothingIsProved) {
  int number_of_failures = 0;
  for(unsigned seed = 0; seed < (are_few_cases_tried() ? 2 : 10); ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = mesh_of(Recipe{"random", {60, seed % 4, seed}});
    Graph graph;
    const auto certificate = CGAL::curve_skeleton(mesh, graph).certificate;
    EXPECT_EQ(certificate.failure.empty(), static_cast<bool>(certificate));
    number_of_failures += certificate ? 0 : 1;
  }
  EXPECT_GT(number_of_failures, 0); // lines of some happen to meet no face
}

TEST(Curve_skeleton, IsAPointWhereThereIsNoLimb) {
  const Graph graph = expect_skeleton(mesh_of(Recipe{"sphere", {300, 0, 0}}));
  EXPECT_EQ(num_vertices(graph), 1u);
  EXPECT_EQ(num_edges(graph), 0u);
}

TEST(Curve_skeleton, HasNoLimbsInCornersOfPlates) {
  const Graph graph = expect_skeleton(mesh_of(Plates(3).bored(0.2, 1)));
  EXPECT_EQ(num_edges(graph), num_vertices(graph));
  for(const std::size_t degree : degrees(graph))
    EXPECT_EQ(degree, 2u);
}

// A plate of square cells, one for each mark in the rows.
Soup plate_of(const std::vector<std::string>& rows, double thickness) {
  Soup soup;
  using Triangle = std::decay_t<decltype(soup.triangles.front())>;
  using Number = std::decay_t<decltype(std::declval<Triangle>()[0])>;
  std::map<std::array<int, 3>, Number> numbers;
  const auto number = [&](int x, int y, int z) {
    const auto [it, is_new] =
        numbers.try_emplace({x, y, z}, static_cast<Number>(soup.points.size()));
    if(is_new)
      soup.points.push_back({double(x), double(y), z * thickness});
    return it->second;
  };
  const auto add = [&](Number a, Number b, Number c, Number d) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  };
  const auto is_full = [&](int x, int y) {
    return y >= 0 && y < int(rows.size()) && x >= 0 && x < int(rows[y].size()) && rows[y][x] == '#';
  };
  for(int y = 0; y < int(rows.size()); ++y)
    for(int x = 0; x < int(rows[y].size()); ++x) {
      if(!is_full(x, y))
        continue;
      add(number(x, y, 1), number(x + 1, y, 1), number(x + 1, y + 1, 1), number(x, y + 1, 1));
      add(number(x, y, 0), number(x, y + 1, 0), number(x + 1, y + 1, 0), number(x + 1, y, 0));
      const std::array<std::array<int, 2>, 4> corners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
      for(int k = 0; k < 4; ++k) {
        const auto [ax, ay] = corners[k];
        const auto [bx, by] = corners[(k + 1) % 4];
        if(!is_full(x + by - ay, y - bx + ax))
          add(number(x + ax, y + ay, 0), number(x + bx, y + by, 0), number(x + bx, y + by, 1),
              number(x + ax, y + ay, 1));
      }
    }
  return soup;
}

// A frame with something at one side, each mark of which stands for four cells.
Soup frame_with(std::vector<std::string> rows) {
  rows.insert(rows.end(), 3, "############");
  rows.insert(rows.end(), 6, "###      ###");
  rows.insert(rows.end(), 3, "############");
  std::vector<std::string> cells;
  for(const std::string& row : rows) {
    std::string twice;
    for(const char mark : row)
      twice.append(2, mark);
    cells.insert(cells.end(), 2, twice);
  }
  return plate_of(cells, 1.);
}

TEST(Curve_skeleton, HasLimbsInEarsAndNotInWhatIsBroadWhereItBegins) {
  for(const std::size_t degree :
      degrees(expect_skeleton(mesh_of(frame_with({"    ####", "   ######"})))))
    EXPECT_EQ(degree, 2u);
  const Graph graph =
      expect_skeleton(mesh_of(frame_with({"    ####", "  ########", "  ########", "   ######"})));
  std::size_t number_of_ends = 0;
  for(const auto v : CGAL::make_range(vertices(graph)))
    if(degree(v, graph) == 1 && graph[v].point.y() < 8.)
      ++number_of_ends;
  EXPECT_GT(number_of_ends, 0u);
}

// Faces between so many profiles, each with so many points, that stand in a ring.
void add_ring(Soup& soup, int profiles, int width) {
  const auto number = [&](int i, int k) {
    return static_cast<std::uint32_t>(width * (i % profiles) + k % width);
  };
  for(int i = 0; i < profiles; ++i)
    for(int k = 0; k < width; ++k) {
      soup.triangles.push_back({number(i, k), number(i + 1, k), number(i + 1, k + 1)});
      soup.triangles.push_back({number(i, k), number(i + 1, k + 1), number(i, k + 1)});
    }
}

// A tube with thick walls, of faces as long as it is.
Soup pipe(int sides) {
  Soup soup;
  constexpr double full_turn = 6.283185307179586;
  for(int i = 0; i < sides; ++i)
    for(const auto& [radius, height] :
        std::vector<std::pair<double, double>>{{0.3, 0.}, {0.3, 1.}, {0.18, 1.}, {0.18, 0.}})
    {
      const double angle = full_turn * i / sides;
      soup.points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
  add_ring(soup, sides, 4);
  return soup;
}

TEST(Curve_skeleton, LeadsAroundTubesInTheMiddleOfTheirLengths) {
  const Graph graph = expect_skeleton(mesh_of(pipe(40)));
  EXPECT_EQ(num_edges(graph), num_vertices(graph));
  for(const auto v : CGAL::make_range(vertices(graph)))
    EXPECT_NEAR(graph[v].point.z(), 0.5, 0.2);
}

// A ring around the z axis with four arms as its profile, which wind around it.
Soup ring_with_arms(int sections) {
  constexpr double full_turn = 6.283185307179586, half_width = 0.1, length = 0.3;
  const std::array<std::array<double, 2>, 3> arm = {
      {{half_width, half_width}, {length, half_width}, {length, -half_width}}};
  Soup soup;
  for(int i = 0; i < sections; ++i)
    for(int quarter = 0; quarter < 4; ++quarter)
      for(const auto& [x, y] : arm) {
        const double around = full_turn * i / sections, turn = around - full_turn * quarter / 4,
                     out = 1. + std::cos(turn) * x - std::sin(turn) * y;
        soup.points.push_back({std::cos(around) * out, std::sin(around) * out,
                               std::sin(turn) * x + std::cos(turn) * y});
      }
  add_ring(soup, sections, 12);
  return soup;
}

TEST(Curve_skeleton, IsInTheMiddleOfAProfileWithArms) {
  const Graph graph = expect_skeleton(mesh_of(ring_with_arms(96)));
  EXPECT_EQ(num_edges(graph), num_vertices(graph));
  double sum = 0.;
  for(const auto v : CGAL::make_range(vertices(graph))) {
    const auto& p = graph[v].point;
    sum += std::hypot(std::hypot(p.x(), p.y()) - 1., p.z());
  }
  EXPECT_LT(sum, 0.05 * double(num_vertices(graph))); // half the width of an arm is 0.1
}

TEST(Curve_skeleton, IsATreeInTheSmallestMeshes) {
  for(const Soup& soup : {tetrahedron(), box()}) {
    const Graph graph = expect_skeleton(mesh_of(soup));
    EXPECT_EQ(num_edges(graph) + 1, num_vertices(graph));
  }
}

TEST(Curve_skeleton, KeepsCyclesWhateverTheShortestLimb) {
  for(const Recipe& recipe :
      std::vector<Recipe>{{"lattice", {900, 2, 1}}, {"plates", {120, 5, 5}}, {"fan", {40, 0, 1}}})
  {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Mesh mesh = mesh_of(recipe);
    for(const double shortest : {0., 1e6}) {
      const Graph graph = skeleton_of(mesh, shortest);
      EXPECT_EQ(num_edges(graph) + 1 - num_vertices(graph), recipe.request.genus);
      expect_truth(mesh, graph);
      for(const std::size_t degree : degrees(graph))
        EXPECT_TRUE(shortest == 0. || degree != 1);
    }
  }
}

TEST(Curve_skeleton, IsThereAtAllScalesAndPlaces) {
  const Soup soup = soup_of({"sponge", {160, 3, 1}});
  for(const auto& [scale, shift] :
      std::vector<std::pair<double, double>>{{1e-150, 0.}, {1e150, 0.}, {1., 1e6}})
  {
    SCOPED_TRACE(testing::Message() << scale << ' ' << shift);
    const Mesh mesh = mesh_of(transformed(soup, scale, shift));
    expect_truth(mesh, skeleton_of(mesh));
  }
}

// The same shape in another order, with x, y and z as y, z and x: turned, but not rounded.
Soup in_another_order(const Soup& soup, generators::Random& random) {
  Soup other;
  std::vector<std::size_t> order(soup.points.size()), place(order.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  for(std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(i)]);
  for(std::size_t i = 0; i < order.size(); ++i) {
    const auto& p = soup.points[order[i]];
    other.points.push_back({p[1], p[2], p[0]});
    place[order[i]] = i;
  }
  for(auto face : soup.triangles) {
    for(auto& v : face)
      v = static_cast<std::decay_t<decltype(v)>>(place[static_cast<std::size_t>(v)]);
    std::rotate(face.begin(), face.begin() + random.below(3), face.end());
    other.triangles.push_back(face);
  }
  for(std::size_t i = other.triangles.size(); i > 1; --i)
    std::swap(other.triangles[i - 1], other.triangles[random.below(i)]);
  return other;
}

// By the farthest point of one from all of the other.
double distance_between(const Graph& a, const Graph& b) {
  double most = 0.;
  for(const auto v : CGAL::make_range(vertices(a))) {
    double least = std::numeric_limits<double>::infinity();
    for(const auto e : CGAL::make_range(edges(b)))
      least =
          (std::min)(least, distance_to_line(place_of(a[v].point), place_of(b[source(e, b)].point),
                                             place_of(b[target(e, b)].point)));
    most = (std::max)(most, least);
  }
  return most;
}

TEST(Curve_skeleton, DependsNeitherOnNumbersNorOnPose) {
  generators::Random random(1);
  for(const Recipe& recipe :
      std::vector<Recipe>{{"foam", {1200, 1, 2}}, {"hubs", {160, 4, 9}}, {"shell", {1600, 1, 11}}})
  {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Soup soup = soup_of(recipe);
    const Graph skeleton = skeleton_of(mesh_of(soup));
    Graph turned = skeleton_of(mesh_of(in_another_order(soup, random)));
    for(const auto v : CGAL::make_range(vertices(turned))) {
      const auto p = turned[v].point;
      turned[v].point = {p.z(), p.x(), p.y()};
    }
    EXPECT_EQ(num_edges(skeleton), num_edges(turned));
    EXPECT_LT(distance_between(skeleton, turned), 1e-6);
  }
}

TEST(Curve_skeleton, IsInsideOfUglyMeshes) {
  for(const Soup& soup :
      {with_degenerate_faces(box()), with_degenerate_faces(soup_of({"sponge", {160, 2, 1}})),
       with_degenerate_faces(Plates(5).bored(0.5, 3)), soup_of({"fan", {60, 0, 2}})})
  {
    SCOPED_TRACE(soup.triangles.size());
    const Mesh mesh = mesh_of(soup);
    expect_truth(mesh, skeleton_of(mesh));
  }
}

} // namespace test_curve_skeleton
