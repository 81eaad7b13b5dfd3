// The Reeb graph from the fields of the reference solver, beside that of the others: two solvers
// that share no field come to the same limbs and cycles, at the same places and times.

#include "Meshes_of_soups.h"
#include "with.h"

#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/reeb_graph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace test_reeb_by_reference {

namespace parameters = CGAL::parameters;
using CGAL::Reference_tag;
using CGAL::Sequential_tag;
using Graph = CGAL::Reeb_graph<Mesh>;
using Vertex = Mesh::Vertex_index;

struct Times_map
{
  using key_type = Vertex;
  using value_type = double;
  using reference = double;
  using category = boost::writable_property_map_tag;

  std::vector<double>* times;

  friend void put(const Times_map& map, Vertex v, double time) { (*map.times)[v.idx()] = time; }
};

struct Diffusion
{
  Graph graph;
  CGAL::Handle_tunnel_loops::Reeb_statistics statistics;
  std::vector<double> times; // by vertex, in steps

  std::map<CGAL::Reeb_node_type, std::size_t> count() const {
    std::map<CGAL::Reeb_node_type, std::size_t> count;
    for(const auto v : CGAL::make_range(vertices(graph)))
      ++count[graph[v].type];
    return count;
  }
};

template <typename Tag>
Diffusion diffused(const Mesh& mesh, const std::vector<Vertex>& sources = {}) {
  Diffusion diffusion;
  diffusion.times.resize(mesh.number_of_vertices());
  diffusion.statistics = CGAL::reeb_graph<Tag>(
      mesh, diffusion.graph,
      parameters::reeb_options(
          with(&CGAL::Handle_tunnel_loops::Reeb_options::allow_parallel_arcs, true),
          parameters::vertex_value_map(
              Times_map{&diffusion.times},
              parameters::source_vertices(sources, parameters::geom_traits(Mesh::Point::R())))));
  return diffusion;
}

double diagonal(const Mesh& mesh) {
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  return std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin()) +
                   CGAL::square(box.zmax() - box.zmin()));
}

// How far the saddles of one graph are from those of the other, at most.
double distance_of_junctions(const Graph& a, const Graph& b) {
  double largest = 0.;
  for(const auto v : CGAL::make_range(vertices(a)))
    if(a[v].type == CGAL::Reeb_node_type::SADDLE) {
      double nearest = std::numeric_limits<double>::infinity();
      for(const auto u : CGAL::make_range(vertices(b)))
        if(b[u].type == CGAL::Reeb_node_type::SADDLE)
          nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(a[v].point, b[u].point)));
      largest = (std::max)(largest, nearest);
    }
  return largest;
}

// In steps, at most.
double distance_of_times(const Diffusion& a, const Diffusion& b) {
  double largest = 0.;
  for(std::size_t v = 0; v < a.times.size(); ++v)
    largest = (std::max)(largest, std::abs(a.times[v] - b.times[v]));
  return largest;
}

std::ptrdiff_t number_of_cycles(const Diffusion& diffusion) {
  return static_cast<std::ptrdiff_t>(num_edges(diffusion.graph)) -
         static_cast<std::ptrdiff_t>(num_vertices(diffusion.graph)) +
         static_cast<std::ptrdiff_t>(diffusion.statistics.number_of_components);
}

TEST(Reeb_by_reference, SaysWhoItWas) {
  const Mesh mesh = mesh_of({"torus", {800, 1, 0}});
  EXPECT_EQ(diffused<Reference_tag>(mesh).statistics.backend, "reference");
  EXPECT_EQ(diffused<Sequential_tag>(mesh).statistics.backend, "host");
  EXPECT_EQ(diffused<Sequential_tag>(mesh).statistics.fallback, "");
}

// From the same vertices the same front grows, in other arithmetic and with another rule for who
// has to wait: no vertex is a step off.
void expect_agreement(const Mesh& mesh, const Diffusion& found, const Diffusion& expected) {
  EXPECT_LT(distance_of_times(found, expected), 1.);
  EXPECT_EQ(number_of_cycles(found), static_cast<std::ptrdiff_t>(expected.statistics.genus));
  EXPECT_EQ(found.count(), expected.count());
  EXPECT_EQ(num_edges(found.graph), num_edges(expected.graph));
  const double tolerance = 0.02 * diagonal(mesh);
  EXPECT_LE(distance_of_junctions(found.graph, expected.graph), tolerance);
  EXPECT_LE(distance_of_junctions(expected.graph, found.graph), tolerance);
}

TEST(Reeb_by_reference, IsThatOfTheOthersFromTheSameVertices) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    const std::vector<Vertex> sources = {Vertex(0), Vertex(7), Vertex(7)};
    const Diffusion found = diffused<Reference_tag>(mesh, sources);
    for(const Vertex v : sources)
      EXPECT_EQ(found.times[v.idx()], 0.);
    expect_agreement(mesh, found, diffused<Sequential_tag>(mesh, sources));
  }
}

// The reference starts from handle loops of its own, which are others; from these the others come
// to the same.
TEST(Reeb_by_reference, IsThatOfTheOthersFromItsHandleLoops) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 4}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    const Diffusion found = diffused<Reference_tag>(mesh);
    std::vector<Vertex> sources;
    for(const Vertex v : mesh.vertices())
      if(found.times[v.idx()] == 0.)
        sources.push_back(v);
    EXPECT_GE(sources.size(), 3u);
    expect_agreement(mesh, found, diffused<Sequential_tag>(mesh, sources));
  }
}

// One of the components has no handle, and no source: there it starts from the end of a limb, as
// the reference finds it.
TEST(Reeb_by_reference, KnowsSeveralComponents) {
  const Soup torus = soup_of({"torus", {800, 1, 0}});
  const Mesh mesh = mesh_of(generators::disjoint_union({torus, soup_of({"lattice", {600, 0, 0}})}));
  const Diffusion found = diffused<Reference_tag>(mesh);
  EXPECT_EQ(number_of_cycles(found), 1);
  std::size_t sources = 0;
  for(std::size_t v = torus.points.size(); v < mesh.number_of_vertices(); ++v)
    sources += found.times[v] == 0.;
  EXPECT_EQ(sources, 1u);
}

TEST(Reeb_by_reference, CanBeStopped) {
  const Mesh mesh = mesh_of({"torus", {2000, 1, 0}});
  std::size_t calls = 0;
  Graph graph(5);
  const auto count = [&calls](double) {
    ++calls;
    return true;
  };
  CGAL::reeb_graph<Reference_tag>(mesh, graph, parameters::callback(count));
  for(std::size_t stop = 1; stop < calls; stop += 1 + calls / 7) {
    std::size_t left = stop;
    graph = Graph(5);
    EXPECT_THROW(CGAL::reeb_graph<Reference_tag>(
                     mesh, graph, parameters::callback([&left](double) { return --left > 0; })),
                 CGAL::Handle_tunnel_loops::Interrupted_exception);
    EXPECT_EQ(num_vertices(graph), 5u);
  }
}

} // namespace test_reeb_by_reference
