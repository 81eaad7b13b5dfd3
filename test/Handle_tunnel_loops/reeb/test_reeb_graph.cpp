// The Reeb graphs that are handed out: of any function, of diffusions, simplified or not.

#include "Mesh_corpus.h"
#include "Meshes_of_soups.h"
#include "Number_of_cases.h"
#include "Reeb_by_definition.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/reeb_arc_shapes.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/reeb_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>

namespace test_reeb_graph {

namespace parameters = CGAL::parameters;
using generators::Random;
using Graph = CGAL::Reeb_graph<Mesh>;
using Statistics = CGAL::Handle_tunnel_loops::Reeb_statistics;
using Vertex = Mesh::Vertex_index;
using Function = std::vector<double>;

// A view of a vector as a property map on the vertices.
template <typename T> struct Vector_map
{
  using key_type = Vertex;
  using value_type = T;
  using reference = T;
  using category = boost::read_write_property_map_tag;

  std::vector<T>* values;

  friend T get(const Vector_map& map, Vertex v) { return (*map.values)[v.idx()]; }
  friend void put(const Vector_map& map, Vertex v, T value) { (*map.values)[v.idx()] = value; }
};

struct Options : CGAL::Handle_tunnel_loops::Reeb_options
{
  Options() {
    threshold = 0.;
    measure = CGAL::Reeb_measure::PERSISTENCE;
  }
};

struct Reeb
{
  Graph graph;
  Statistics statistics;
  std::vector<std::size_t> vertex_arc;
};

template <typename FindGraph>
Reeb found(const Mesh& mesh, const Options& options, const FindGraph& find_graph) {
  Reeb reeb;
  reeb.vertex_arc.assign(mesh.number_of_vertices(), std::size_t(-1));
  const Vector_map<std::size_t> arcs{&reeb.vertex_arc};
  reeb.statistics = find_graph(
      reeb.graph,
      parameters::reeb_options(
          options, parameters::vertex_arc_map(arcs, parameters::geom_traits(Mesh::Point::R()))));
  return reeb;
}

Reeb reeb_of(const Mesh& mesh, Function function, const Options& options = {}) {
  return found(mesh, options, [&](Graph& graph, const auto& np) {
    return CGAL::reeb_graph_of_function(mesh, Vector_map<double>{&function}, graph, np);
  });
}

Reeb reeb_of_diffusion(const Mesh& mesh,
                       const Options& options = {},
                       const std::vector<Vertex>& sources = {}) {
  return found(mesh, options, [&](Graph& graph, const auto& np) {
    return CGAL::reeb_graph(mesh, graph, parameters::source_vertices(sources, np));
  });
}

Function random_function(const Mesh& mesh, Random& random, std::size_t number_of_values) {
  Function function(mesh.number_of_vertices());
  for(double& value : function)
    value = 0.25 * static_cast<double>(random.below(number_of_values)) - 1.;
  return function;
}

Function height(const Mesh& mesh) {
  Function function;
  for(const auto& p : mesh.points())
    function.push_back(p.x() + 0.2 * p.y() + 0.1 * p.z());
  return function;
}

std::size_t number_of_pieces(const Graph& graph) {
  std::vector<std::size_t> piece(num_vertices(graph));
  std::iota(piece.begin(), piece.end(), std::size_t(0));
  const auto root = [&piece](std::size_t i) {
    while(piece[i] != i)
      i = piece[i];
    return i;
  };
  std::size_t count = piece.size();
  for(const auto e : CGAL::make_range(edges(graph))) {
    const std::size_t a = root(source(e, graph)), b = root(target(e, graph));
    count -= a != b;
    piece[a] = b;
  }
  return count;
}

void expect_nodes(const Reeb& reeb) {
  std::ptrdiff_t sum = 0;
  for(const auto v : CGAL::make_range(vertices(reeb.graph))) {
    const auto type = reeb.graph[v].type;
    const bool is_saddle = type == CGAL::Reeb_node_type::SADDLE;
    const bool is_regular = type == CGAL::Reeb_node_type::REGULAR;
    sum += is_regular ? 0 : is_saddle ? -1 : 1;
    EXPECT_EQ(degree(v, reeb.graph), is_regular ? 2u : is_saddle ? 3u : 1u);
  }
  EXPECT_EQ(sum, 2 * static_cast<std::ptrdiff_t>(reeb.statistics.number_of_components) -
                     2 * static_cast<std::ptrdiff_t>(reeb.statistics.genus));
}

void expect_arcs(const Mesh& mesh, const Reeb& reeb) {
  std::vector<int> is_on_arc(mesh.number_of_vertices(), 0);
  std::size_t index = 0;
  for(const auto e : CGAL::make_range(edges(reeb.graph))) {
    const auto& arc = reeb.graph[e];
    EXPECT_EQ(arc.index, index++);
    ASSERT_GE(arc.polyline.size(), 2u);
    EXPECT_EQ(arc.polyline.front(), reeb.graph[source(e, reeb.graph)].point);
    EXPECT_EQ(arc.polyline.back(), reeb.graph[target(e, reeb.graph)].point);
    EXPECT_GE(arc.length, 0.);
    for(const Vertex v : arc.vertices) {
      ++is_on_arc[v.idx()];
      EXPECT_EQ(reeb.vertex_arc[v.idx()], arc.index);
    }
  }
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(is_on_arc[v.idx()], mesh.is_isolated(v) ? 0 : 1);
}

void expect_simple(const Graph& graph) {
  std::set<std::pair<std::size_t, std::size_t>> seen;
  for(const auto e : CGAL::make_range(edges(graph))) {
    EXPECT_NE(source(e, graph), target(e, graph));
    EXPECT_TRUE(seen.insert(std::minmax(source(e, graph), target(e, graph))).second);
  }
}

// What is true of the Reeb graph of any function, simplified or not.
void expect_reeb_graph(const Mesh& mesh, const Reeb& reeb) {
  EXPECT_EQ(number_of_pieces(reeb.graph), reeb.statistics.number_of_components);
  EXPECT_EQ(num_edges(reeb.graph) + reeb.statistics.number_of_components,
            num_vertices(reeb.graph) + reeb.statistics.genus);
  expect_nodes(reeb);
  expect_arcs(mesh, reeb);
}

// The ends of the arcs and their regular vertices, in the numbering of the given map. Saddles may
// be unfolded in more than one way; what is between the nodes of one saddle is left out.
using Arcs = std::multiset<std::tuple<std::size_t, std::size_t, std::set<std::size_t>>>;

Arcs arcs_of(const Graph& graph, const std::vector<std::size_t>& number) {
  std::set<Vertex> critical;
  for(const auto v : CGAL::make_range(vertices(graph)))
    critical.insert(graph[v].vertex);
  Arcs arcs;
  for(const auto e : CGAL::make_range(edges(graph))) {
    const Vertex lower = graph[source(e, graph)].vertex, upper = graph[target(e, graph)].vertex;
    std::set<std::size_t> regular;
    for(const Vertex v : graph[e].vertices)
      if(critical.count(v) == 0)
        regular.insert(number[v.idx()]);
    if(lower != upper)
      arcs.insert({number[lower.idx()], number[upper.idx()], regular});
  }
  return arcs;
}

std::vector<std::size_t> identity(const Mesh& mesh) {
  std::vector<std::size_t> number(mesh.number_of_vertices());
  std::iota(number.begin(), number.end(), std::size_t(0));
  return number;
}

constexpr CGAL::Reeb_measure measures[] = {
    CGAL::Reeb_measure::LIMBS, CGAL::Reeb_measure::PERSISTENCE, CGAL::Reeb_measure::LENGTH,
    CGAL::Reeb_measure::AREA, CGAL::Reeb_measure::VERTICES};

TEST(Reeb_graph, HasAsManyCyclesAsHandlesWhateverTheFunction) {
  Random random(1);
  for(int i = 0; i < 400; ++i) {
    const std::size_t genus = random.below(15);
    const Recipe recipe = {
        "random",
        {20 + 12 * genus + random.below(300), genus, static_cast<unsigned>(random.next())}};
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    Options options;
    options.threshold = i % 2 == 0 ? 0. : random.uniform(0., 1.);
    options.measure = measures[i % 5];
    options.allow_parallel_arcs = i % 3 == 0;
    const Reeb reeb = reeb_of(mesh, random_function(mesh, random, i % 4 == 0 ? 3 : 1000), options);
    EXPECT_EQ(reeb.statistics.genus, genus);
    expect_reeb_graph(mesh, reeb);
    if(!options.allow_parallel_arcs)
      expect_simple(reeb.graph);
  }
}

// By increasing value, of equal ones by number.
std::vector<std::uint32_t> order_of(const Function& function) {
  std::vector<std::uint32_t> order(function.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t v, std::uint32_t w) { return function[v] < function[w]; });
  return order;
}

std::size_t number_of_cycles(const Reeb& reeb) {
  return num_edges(reeb.graph) + reeb.statistics.number_of_components - num_vertices(reeb.graph);
}

TEST(Reeb_graph, OfASurfaceWithBoundaryIsThatOfTheDefinition) {
  Random random(5);
  for(int i = 0; i < number_of_cases(600); ++i) {
    const std::size_t genus = random.below(4);
    const Recipe recipe = {
        "random",
        {20 + 12 * genus + random.below(80), genus, static_cast<unsigned>(random.next())}};
    const Soup closed = soup_of(recipe);
    const std::size_t faces_less = random.below(closed.triangles.size());
    SCOPED_TRACE(testing::Message() << recipe << ", " << faces_less << " faces less, " << i);
    const Soup soup = reeb_by_definition::with_fewer_faces(closed, faces_less, random);
    const Mesh mesh = mesh_of(soup);
    const Function function = random_function(mesh, random, i % 4 == 0 ? 3 : 1000);
    Options options;
    options.allow_parallel_arcs = true;
    const Reeb reeb = reeb_of(mesh, function, options);
    ASSERT_EQ(reeb_by_definition::arcs_of(reeb.graph),
              reeb_by_definition::arcs_of(soup, order_of(function)));
    const auto topology = reeb_by_definition::topology_of(soup);
    EXPECT_EQ(reeb.statistics.number_of_components, topology.number_of_components);
    EXPECT_EQ(number_of_pieces(reeb.graph), topology.number_of_components);
    EXPECT_GE(number_of_cycles(reeb), topology.genus);
    EXPECT_LE(number_of_cycles(reeb), topology.most_cycles);
    expect_arcs(mesh, reeb);
  }
}

// In the plane, with so many vertices on each of its curves.
Soup annulus(std::uint32_t n) {
  Soup soup;
  for(const double radius : {1., 2.})
    for(std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2. * CGAL_PI * (i + 0.3) / n;
      soup.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.});
    }
  for(std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    soup.triangles.push_back({i, n + i, n + j});
    soup.triangles.push_back({i, n + j, j});
  }
  return soup;
}

TEST(Reeb_graph, OfTheHeightOfAnAnnulusGoesAroundTheHole) {
  const Mesh mesh = mesh_of(annulus(24));
  Options options;
  options.allow_parallel_arcs = true;
  Function heights;
  for(const auto& p : mesh.points())
    heights.push_back(p.y());
  const Reeb reeb = reeb_of(mesh, heights, options);
  EXPECT_EQ(num_vertices(reeb.graph), 4u);
  EXPECT_EQ(num_edges(reeb.graph), 4u);
  options.capped = true;
  const Reeb capped = reeb_of(mesh, heights, options);
  EXPECT_EQ(num_vertices(capped.graph), 2u);
  EXPECT_EQ(num_edges(capped.graph), 1u);
}

Soup soup_with_holes(const Recipe& recipe, Random& random) {
  generators::Hole_request holes;
  holes.number = 1 + random.below(5);
  holes.faces = 1 + random.below(60);
  holes.seed = static_cast<unsigned>(random.next());
  holes.may_be_fewer = true;
  return generators::with_holes(soup_of(recipe), holes);
}

TEST(Reeb_graph, OfADiffusionIsThatOfItsTimes) {
  Random random(6);
  for(const Recipe& recipe : enough_of(recipes_of_all_kinds({0, 1, 2, 5}, 1))) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(soup_with_holes(recipe, random));
    for(const bool capped : {false, true}) {
      Options options;
      options.allow_parallel_arcs = true;
      options.capped = capped;
      Function times(mesh.number_of_vertices());
      const Reeb diffused = found(mesh, options, [&](Graph& graph, const auto& np) {
        return CGAL::reeb_graph(mesh, graph,
                                parameters::vertex_value_map(Vector_map<double>{&times}, np));
      });
      const Reeb expected = reeb_of(mesh, times, options);
      EXPECT_EQ(arcs_of(diffused.graph, identity(mesh)), arcs_of(expected.graph, identity(mesh)));
      if(capped)
        expect_reeb_graph(mesh, diffused);
    }
  }
}

TEST(Reeb_graph, OfASurfaceWithBoundaryMayBeSimplified) {
  Random random(7);
  for(const Recipe& recipe : enough_of(recipes_of_all_kinds({0, 1, 2, 5}, 2))) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(soup_with_holes(recipe, random));
    Options options;
    options.allow_parallel_arcs = true;
    const Function function =
        random.below(2) == 0 ? height(mesh) : random_function(mesh, random, 99);
    const std::size_t cycles = number_of_cycles(reeb_of(mesh, function, options));
    for(const double shortest_arc : {0., 2.})
      for(const auto measure : measures) {
        options.shortest_arc = shortest_arc;
        options.measure = measure;
        options.threshold = 0.05;
        const Reeb reeb = reeb_of(mesh, function, options);
        EXPECT_EQ(number_of_cycles(reeb), cycles);
        EXPECT_EQ(number_of_pieces(reeb.graph), reeb.statistics.number_of_components);
        expect_arcs(mesh, reeb);
      }
  }
}

TEST(Reeb_graph, OfADiffusionIsRight) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 2, 5}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    for(const double threshold : {0., 0.03, 1.}) {
      Options options;
      options.threshold = threshold;
      options.measure = CGAL::Reeb_measure::LIMBS;
      expect_reeb_graph(mesh, reeb_of_diffusion(mesh, options));
      expect_reeb_graph(mesh, reeb_of_diffusion(mesh, options, {Vertex(3), Vertex(100)}));
    }
  }
}

TEST(Reeb_graph, OfTheHeightOfASphereIsOneArc) {
  const Mesh mesh = mesh_of(Recipe{"sphere", {2000, 0, 0}});
  const Reeb reeb = reeb_of(mesh, height(mesh));
  ASSERT_EQ(num_edges(reeb.graph), 1u);
  EXPECT_EQ(reeb.graph[*edges(reeb.graph).first].vertices.size(), mesh.number_of_vertices());
}

TEST(Reeb_graph, OfTheHeightOfATorusIsARingWithTwoEnds) {
  const Mesh mesh = mesh_of(Recipe{"torus", {5000, 1, 0}});
  Options options;
  options.allow_parallel_arcs = true;
  EXPECT_EQ(num_edges(reeb_of(mesh, height(mesh), options).graph), 4u);
  // One of two parallel arcs gets a node between its ends.
  EXPECT_EQ(num_edges(reeb_of(mesh, height(mesh)).graph), 5u);
}

// The means of the contours of a tube are in its middle.
TEST(Reeb_graph, RunsAlongTheMiddleOfATube) {
  const Mesh mesh = mesh_of(Recipe{"torus", {20000, 1, 0}});
  Options options;
  options.threshold = 0.03;
  options.measure = CGAL::Reeb_measure::LIMBS;
  const Reeb reeb = reeb_of_diffusion(mesh, options);
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double tube = box.zmax(), ring = box.xmax() - tube;
  double length = 0.;
  for(const auto e : CGAL::make_range(edges(reeb.graph))) {
    length += reeb.graph[e].length;
    for(const auto& p : reeb.graph[e].polyline)
      EXPECT_LE(std::hypot(std::hypot(p.x(), p.y()) - ring, p.z()), 1.01 * tube);
  }
  const double circle = 2. * 3.14159265 * ring;
  EXPECT_GT(length, 0.8 * circle);
  EXPECT_LT(length, 1.2 * circle + 2. * tube);
}

TEST(Reeb_graph, IsThatOfTheFunctionAndNotOfTheNumbering) {
  Random random(2);
  for(int i = 0; i < 60; ++i) {
    const std::size_t genus = random.below(8);
    const Recipe recipe = {"random",
                           {60 + 12 * genus, genus, static_cast<unsigned>(random.next())}};
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    Function function(mesh.number_of_vertices());
    std::iota(function.begin(), function.end(), 0.);
    random.shuffle(function); // all values differ
    std::vector<std::size_t> old_number = identity(mesh), new_number(old_number.size());
    random.shuffle(old_number);
    for(std::size_t v = 0; v < old_number.size(); ++v)
      new_number[old_number[v]] = v;
    Soup soup = soup_of(recipe), permuted = soup;
    Function permuted_function(function.size());
    for(std::size_t v = 0; v < old_number.size(); ++v) {
      permuted.points[v] = soup.points[old_number[v]];
      permuted_function[v] = function[old_number[v]];
    }
    for(auto& triangle : permuted.triangles)
      for(auto& v : triangle)
        v = static_cast<std::uint32_t>(new_number[v]);
    random.shuffle(permuted.triangles);
    Options options;
    options.allow_parallel_arcs = true;
    EXPECT_EQ(arcs_of(reeb_of(mesh, function, options).graph, identity(mesh)),
              arcs_of(reeb_of(mesh_of(permuted), permuted_function, options).graph, old_number));
  }
}

TEST(Reeb_graph, KnowsSeveralComponentsAndIsolatedVertices) {
  Mesh mesh = mesh_of(generators::disjoint_union(
      {soup_of({"torus", {800, 1, 0}}), soup_of({"sphere", {500, 0, 0}}),
       soup_of({"multi-torus", {2000, 3, 0}}), soup_of({"sphere", {60, 0, 0}})}));
  mesh.add_vertex({0, 0, 0});
  const Reeb by_height = reeb_of(mesh, height(mesh));
  EXPECT_EQ(by_height.statistics.number_of_components, 4u);
  EXPECT_EQ(by_height.statistics.genus, 4u);
  expect_reeb_graph(mesh, by_height);
  for(const double threshold : {0., 0.1}) {
    Options options;
    options.threshold = threshold;
    expect_reeb_graph(mesh, reeb_of_diffusion(mesh, options));
    expect_reeb_graph(mesh, reeb_of_diffusion(mesh, options, {Vertex(0)}));
  }
  EXPECT_THROW(
      reeb_of_diffusion(mesh, {}, {Vertex(Mesh::size_type(mesh.number_of_vertices() - 1))}),
      std::invalid_argument);
}

TEST(Reeb_graph, OfAConstantFunctionIsRight) {
  for(const std::size_t genus : {0, 1, 4}) {
    const Mesh mesh = mesh_of(Recipe{"random", {300, genus, 7}});
    for(const double threshold : {0., 0.1}) {
      Options options;
      options.threshold = threshold;
      expect_reeb_graph(mesh, reeb_of(mesh, Function(mesh.number_of_vertices(), 2.), options));
    }
  }
}

// The more is taken off, the less is left; what is left and could go is larger than the threshold.
TEST(Reeb_graph, LosesSmallLeavesOnly) {
  Random random(3);
  const Mesh mesh = mesh_of(Recipe{"multi-torus", {4000, 3, 0}});
  Function function = height(mesh);
  for(double& value : function)
    value += random.uniform(0., 0.05);
  const auto [low, high] = std::minmax_element(function.begin(), function.end());
  const double range = *high - *low;
  std::size_t before = std::size_t(-1);
  for(const double threshold : {0., 0.001, 0.01, 0.05, 0.2}) {
    Options options;
    options.threshold = threshold;
    options.allow_parallel_arcs = true;
    const Reeb reeb = reeb_of(mesh, function, options);
    EXPECT_LT(num_edges(reeb.graph), before);
    before = num_edges(reeb.graph);
    for(const auto e : CGAL::make_range(edges(reeb.graph))) {
      const auto s = source(e, reeb.graph), t = target(e, reeb.graph);
      if((degree(s, reeb.graph) == 1) != (degree(t, reeb.graph) == 1)) {
        auto [lowest, highest] = std::minmax({reeb.graph[s].value, reeb.graph[t].value});
        for(const Vertex v : reeb.graph[e].vertices) {
          lowest = (std::min)(lowest, function[v.idx()]);
          highest = (std::max)(highest, function[v.idx()]);
        }
        EXPECT_GT(highest - lowest, 0.5 * threshold * range);
      }
    }
  }
}

TEST(Reeb_graph, RefusesWhatIsNotFinite) {
  const Mesh mesh = mesh_of(Recipe{"sphere", {100, 0, 0}});
  for(const double bad :
      {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
       -std::numeric_limits<double>::infinity()})
  {
    Function function = height(mesh);
    function[7] = function[30] = bad;
    try {
      reeb_of(mesh, function);
      FAIL() << "a function with " << bad;
    } catch(const CGAL::Handle_tunnel_loops::Invalid_function_exception& exception) {
      EXPECT_EQ(exception.vertex(), 7u);
    }
  }
  for(const double threshold : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    Options options;
    options.threshold = threshold;
    EXPECT_THROW(reeb_of(mesh, height(mesh), options), std::invalid_argument);
  }
}

// As double these integers are equal.
TEST(Reeb_graph, ComparesIntegersExactly) {
  const Mesh mesh = mesh_of(Recipe{"sphere", {100, 0, 0}});
  std::vector<std::size_t> numbers(mesh.number_of_vertices());
  Function same(numbers.size(), 0.);
  const Function heights = height(mesh);
  std::vector<std::size_t> order = identity(mesh);
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return heights[i] < heights[j]; });
  for(std::size_t i = 0; i < order.size(); ++i)
    numbers[order[i]] = (std::size_t(1) << 60) + i;
  Graph graph;
  CGAL::reeb_graph_of_function(mesh, Vector_map<std::size_t>{&numbers}, graph);
  EXPECT_EQ(num_edges(graph), 1u);
  EXPECT_GT(num_edges(reeb_of(mesh, same).graph), 1u);
}

TEST(Reeb_graph, DoesNotDependOnTheThreads) {
  const Mesh mesh = mesh_of(Recipe{"gyroid", {6000, 5, 0}});
  Graph sequential, parallel;
  CGAL::reeb_graph(mesh, sequential);
  CGAL::reeb_graph<CGAL::Parallel_if_available_tag>(mesh, parallel);
  EXPECT_EQ(arcs_of(sequential, identity(mesh)), arcs_of(parallel, identity(mesh)));
  for(auto a = edges(sequential).first, b = edges(parallel).first; a != edges(sequential).second;
      ++a, ++b)
    EXPECT_EQ(sequential[*a].polyline, parallel[*b].polyline);
}

TEST(Reeb_graph, CanBeStopped) {
  const Mesh mesh = mesh_of(Recipe{"torus", {2000, 1, 0}});
  Graph graph(5);
  EXPECT_THROW(CGAL::reeb_graph(
                   mesh, graph,
                   parameters::callback(std::function<bool(double)>([](double) { return false; }))),
               CGAL::Handle_tunnel_loops::Interrupted_exception);
  EXPECT_EQ(num_vertices(graph), 5u);
}

struct Polylines
{
  const Graph& graph;
  std::vector<std::size_t> sizes = {};
  std::set<std::size_t> arcs = {};

  void start_new_polyline() { sizes.push_back(0); }
  void add_node(Graph::vertex_descriptor) { ++sizes.back(); }
  void add_edge(const Graph::edge_descriptor& e) { arcs.insert(graph[e].index); }
  void end_polyline() {}
};

TEST(Reeb_graph, SplitsIntoPolylines) {
  for(const std::size_t genus : {1, 2, 5}) {
    const Mesh mesh = mesh_of(Recipe{"multi-torus", {3000, genus, 0}});
    const Graph graph = reeb_of(mesh, height(mesh)).graph;
    Options options;
    options.allow_parallel_arcs = true;
    Polylines polylines{graph};
    CGAL::split_graph_into_polylines(graph, polylines);
    EXPECT_EQ(polylines.arcs.size(), num_edges(graph));
    EXPECT_EQ(polylines.sizes.size(), num_edges(reeb_of(mesh, height(mesh), options).graph));
  }
}

// An arc is on a cycle if there are as many pieces without it. A tube is as thick as it is around.
TEST(Reeb_arc_shapes, AreThoseOfTheGraph) {
  Random random(2);
  for(const std::size_t genus : {1, 3}) {
    const Mesh mesh = mesh_of(Recipe{"multi-torus", {3000, genus, 0}});
    for(Function function : {height(mesh), random_function(mesh, random, 50)}) {
      Reeb reeb = reeb_of(mesh, function);
      const CGAL::Reeb_arc_shapes shapes =
          CGAL::reeb_arc_shapes(mesh, reeb.graph, Vector_map<std::size_t>{&reeb.vertex_arc},
                                Vector_map<double>{&function});
      for(const auto e : CGAL::make_range(edges(reeb.graph))) {
        const auto& arc = reeb.graph[e];
        Graph rest = reeb.graph;
        boost::remove_edge_if([&](auto other) { return rest[other].index == arc.index; }, rest);
        EXPECT_EQ(shapes.is_on_cycle[arc.index],
                  number_of_pieces(rest) == number_of_pieces(reeb.graph));
        EXPECT_EQ(shapes.radii[arc.index].size(), arc.polyline.size());
        EXPECT_TRUE(shapes.girths[arc.index] > 0. || arc.vertices.size() < 10);
      }
    }
  }
}

// A saddle is the middle of an arc with few vertices; contours of other arcs come to it, too.
void expect_girths(const Soup& soup, Function function) {
  const Mesh mesh = mesh_of(soup);
  Options options;
  options.allow_parallel_arcs = true;
  Reeb reeb = reeb_of(mesh, function, options);
  const std::vector<double> girths = CGAL::reeb_arc_girths(
      mesh, reeb.graph, Vector_map<std::size_t>{&reeb.vertex_arc}, Vector_map<double>{&function});
  for(const auto e : CGAL::make_range(edges(reeb.graph))) {
    const auto& arc = reeb.graph[e];
    if(arc.vertices.empty())
      continue;
    std::vector<double> lengths = reeb_by_definition::lengths_below(
        soup, order_of(function), function, arc.vertices[arc.vertices.size() / 2]);
    if(lengths.empty())
      lengths.push_back(0.); // a minimum
    const auto off = [&](double length) { return std::abs(length - girths[arc.index]); };
    const double nearest = *std::min_element(lengths.begin(), lengths.end(),
                                             [&](double a, double b) { return off(a) < off(b); });
    EXPECT_NEAR(girths[arc.index], nearest, 1e-9 * (1. + nearest));
  }
}

TEST(Reeb_arc_girths, AreThoseOfContoursCutFromTheMesh) {
  Random random(8);
  const auto heights = [&random](const Soup& soup, double noise) {
    Function function;
    for(const auto& p : soup.points)
      function.push_back(.3 * p[0] + .2 * p[1] + .93 * p[2] + random.uniform(0., noise));
    return function;
  };
  for(const Recipe& recipe : {Recipe{"torus", {3000, 1, 0}}, Recipe{"multi-torus", {1500, 3, 0}},
                              Recipe{"lattice", {2000, 5, 0}}, Recipe{"random", {300, 2, 1}}})
    for(const double noise : {1e-9, 0.02}) {
      SCOPED_TRACE(testing::Message() << recipe << ", noise " << noise);
      expect_girths(soup_of(recipe), heights(soup_of(recipe), noise));
      const Soup open = soup_with_holes(recipe, random);
      expect_girths(open, heights(open, noise));
    }
}

class Reeb_graph_of_corpus : public testing::TestWithParam<std::filesystem::path>
{};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Reeb_graph_of_corpus);
INSTANTIATE_TEST_SUITE_P(Files,
                         Reeb_graph_of_corpus,
                         testing::ValuesIn(files_of_corpus()),
                         name_of_file);

TEST_P(Reeb_graph_of_corpus, HasAsManyCyclesAsHandles) {
  if(std::filesystem::file_size(GetParam()) > 4000000)
    GTEST_SKIP() << "the tool is tested on the large ones";
  Random random(4);
  Mesh mesh;
  ASSERT_TRUE(CGAL::IO::read_polygon_mesh(GetParam().string(), mesh));
  Options options;
  options.threshold = 0.03;
  expect_reeb_graph(mesh, reeb_of_diffusion(mesh, options));
  expect_reeb_graph(mesh, reeb_of(mesh, height(mesh), options));
  expect_reeb_graph(mesh, reeb_of(mesh, random_function(mesh, random, 1 << 20)));
  expect_reeb_graph(mesh, reeb_of(mesh, random_function(mesh, random, 5)));
}

} // namespace test_reeb_graph
