// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The layers and the arrival times of the vertices, as every solver gives them: they fit the events
// of the fronts and the surface.

#include "Meshes_of_soups.h"
#include "Same_events.h"
#include "Same_loops.h"

#include "generators/Random.h"
#include "generators/generators.h"

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test_layers {

namespace params = CGAL::parameters;
using namespace CGAL::Handle_tunnel_loops;
using generators::Random;
using Vertex = Mesh::Vertex_index;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;

constexpr std::size_t no_layer = 12345678;
constexpr double no_time = -1.;

// A property map of its own, by index.
template <typename T> struct Vector_map
{
  using key_type = Vertex;
  using value_type = T;
  using reference = void;
  using category = boost::writable_property_map_tag;
  std::vector<T>* values;

  friend void put(const Vector_map& map, Vertex v, const T& value) {
    map.values->at(v.idx()) = value;
  }
};

struct Told
{
  std::vector<std::size_t> layer;
  std::vector<double> time;
  std::vector<Front_event> events;
  std::size_t genus = 0, components = 0;

  std::size_t number_of_layers() const {
    std::size_t number = components;
    for(const Front_event& event : events)
      number += event.after.size();
    return number;
  }
};

template <typename Tag> Told told_by(const Mesh& mesh, Vertex seed = Mesh::null_vertex()) {
  Told told;
  told.layer.assign(mesh.number_of_vertices(), no_layer);
  told.time.assign(mesh.number_of_vertices(), no_time);
  Solver_options options;
  options.do_log_fronts = true;
  options.do_tighten = false;
  Solver solver(mesh);
  solver.find_loops<Tag>(
      CGAL::Emptyset_iterator(),
      params::vertex_layer_map(
          Vector_map<std::size_t>{&told.layer},
          params::vertex_value_map(Vector_map<double>{&told.time},
                                   params::solver_options(options, params::seed_vertex(seed)))));
  told.events = solver.statistics().front_events;
  told.genus = solver.genus();
  told.components = solver.number_of_components();
  return told;
}

template <typename Tag> class Layers : public testing::Test
{};

using Tags = testing::Types<CGAL::Sequential_tag,
                            CGAL::Parallel_if_available_tag,
                            CGAL::Cuda_if_available_tag
#ifdef CGAL_EIGEN3_ENABLED
                            ,
                            CGAL::Reference_tag
#endif
                            >;
TYPED_TEST_SUITE(Layers, Tags);

// Each vertex that has neighbors has one of the layers, and no front comes before the first ones,
// nor anywhere without having come to a neighbor, unless it comes over a hole.
void expect_all_told(const Mesh& mesh, const Told& told) {
  for(const Vertex v : mesh.vertices()) {
    if(mesh.is_isolated(v)) {
      EXPECT_EQ(told.layer[v], no_layer);
      EXPECT_EQ(told.time[v], no_time);
      continue;
    }
    EXPECT_GE(told.layer[v], 1u);
    EXPECT_LE(told.layer[v], told.number_of_layers());
    EXPECT_GE(told.time[v], 0.);
    const auto ring = vertices_around_target(mesh.halfedge(v), mesh);
    EXPECT_TRUE(told.time[v] == 0. || mesh.is_border(v) ||
                std::any_of(ring.begin(), ring.end(),
                            [&](Vertex u) { return told.time[u] <= told.time[v]; }));
  }
  EXPECT_GE(static_cast<std::size_t>(std::count(told.time.begin(), told.time.end(), 0.)),
            told.components);
}

// With a node for each seed and each event, the layers are the arcs of a graph: the Reeb graph of
// the arrival times, which has as many cycles as the surface has handles.
void expect_graph_of_surface(const Told& told) {
  std::map<std::size_t, std::size_t> number_of_ends;
  std::size_t number_of_merges = 0, number_of_events = 0;
  for(const Front_event& event : told.events) {
    number_of_merges += event.type == Front_event_type::MERGE;
    number_of_events += event.type != Front_event_type::REST;
    for(const Front_event::Front& front : event.before)
      ++number_of_ends[front.layer];
  }
  EXPECT_EQ(number_of_merges, told.genus);
  EXPECT_EQ(told.number_of_layers() - number_of_events, told.genus);
  EXPECT_EQ(number_of_ends.size(), told.number_of_layers());
  for(const auto& [layer, count] : number_of_ends) {
    EXPECT_LE(layer, told.number_of_layers());
    EXPECT_EQ(count, 1u) << "layer " << layer;
  }
}

// By layer, those that come after it, itself included, and the vertices at which it begins and
// ends.
struct Events_of_layers
{
  std::vector<std::set<std::size_t>> after;
  std::vector<Vertex> begin, end;

  explicit Events_of_layers(const Told& told)
      : after(told.number_of_layers() + 1)
      , begin(after.size(), Mesh::null_vertex())
      , end(after.size(), Mesh::null_vertex()) {
    for(std::size_t layer = 0; layer < after.size(); ++layer)
      after[layer].insert(layer);
    for(auto event = told.events.rbegin(); event != told.events.rend(); ++event)
      for(const Front_event::Front& before : event->before) {
        end.at(before.layer) = Vertex(static_cast<Mesh::size_type>(event->vertex));
        for(const Front_event::Front& next : event->after) {
          after.at(before.layer).insert(after.at(next.layer).begin(), after.at(next.layer).end());
          begin.at(next.layer) = end[before.layer];
        }
      }
  }
};

// By vertex, its layer; where there is an event, all that end there.
std::vector<std::set<std::size_t>> layers_at_vertices(const Told& told) {
  std::vector<std::set<std::size_t>> layers(told.layer.size());
  for(const Front_event& event : told.events)
    if(event.vertex < layers.size()) // and no hole
      for(const Front_event::Front& front : event.before)
        layers[event.vertex].insert(front.layer);
  for(std::size_t v = 0; v < layers.size(); ++v) {
    EXPECT_TRUE(layers[v].empty() || layers[v].count(told.layer[v]) == 1) << "vertex " << v;
    layers[v].insert(told.layer[v]);
  }
  return layers;
}

// A vertex comes between the events with which its layer begins and ends, and one at which there is
// an event is in a layer that ends there; along an edge a layer goes on, or one that has come out
// of it, up to those that end at its later vertex.
void expect_layers_of_events(const Mesh& mesh, const Told& told) {
  const Events_of_layers events(told);
  const auto is_of_mesh = [&](Vertex v) {
    return v != Mesh::null_vertex() && v.idx() < mesh.number_of_vertices();
  };
  for(const Vertex v : mesh.vertices()) {
    if(mesh.is_isolated(v))
      continue;
    const Vertex begin = events.begin[told.layer[v]], end = events.end[told.layer[v]];
    if(is_of_mesh(begin)) {
      EXPECT_LE(told.time[begin], told.time[v]);
    }
    if(is_of_mesh(end)) {
      EXPECT_LE(told.time[v], told.time[end]);
    }
  }
  const auto layers_at = layers_at_vertices(told);
  for(const Mesh::Edge_index e : mesh.edges()) {
    const auto &a = layers_at[mesh.vertex(e, 0)], &b = layers_at[mesh.vertex(e, 1)];
    EXPECT_TRUE(
        std::any_of(a.begin(), a.end(),
                    [&](std::size_t from) {
                      return std::any_of(b.begin(), b.end(), [&](std::size_t to) {
                        return events.after[from].count(to) + events.after[to].count(from) != 0;
                      });
                    }))
        << "from layer " << told.layer[mesh.vertex(e, 0)] << " to "
        << told.layer[mesh.vertex(e, 1)];
  }
}

void expect_all(const Mesh& mesh, const Told& told) {
  expect_all_told(mesh, told);
  expect_graph_of_surface(told);
  expect_layers_of_events(mesh, told);
}

TYPED_TEST(Layers, FitTheEventsAndTheSurface) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 2, 7}, 2)) {
    SCOPED_TRACE(recipe);
    const Mesh mesh = mesh_of(recipe);
    const Told told = told_by<TypeParam>(mesh);
    EXPECT_EQ(told.genus, recipe.request.genus);
    expect_all(mesh, told);
  }
}

TYPED_TEST(Layers, FitOnTheCoarsestSurfaces) {
  Random random(31);
  for(int i = 0; i < number_of_cases(60); ++i) {
    const std::size_t genus = random.below(6);
    const Recipe recipe = {
        "random",
        {20 + 12 * genus + random.below(100), genus, static_cast<unsigned>(random.next())}};
    SCOPED_TRACE(recipe);
    const Mesh mesh = mesh_of(recipe);
    expect_all(mesh, told_by<TypeParam>(mesh));
  }
}

TYPED_TEST(Layers, GrowFromTheSeed) {
  const Mesh mesh = mesh_of({"multi-torus", {3000, 2, 0}});
  for(const Mesh::size_type i : {0u, 17u, mesh.number_of_vertices() - 1}) {
    const Vertex seed(i);
    const Told told = told_by<TypeParam>(mesh, seed);
    expect_all(mesh, told);
    EXPECT_EQ(told.time[seed], 0.);
    EXPECT_EQ(told.layer[seed], 1u);
    std::size_t number_of_first = 0;
    for(const Vertex u : vertices_around_target(mesh.halfedge(seed), mesh))
      EXPECT_LT(told.time[u], 0.1);
    for(const double time : told.time)
      number_of_first += time < 0.1;
    EXPECT_EQ(number_of_first, 1 + mesh.degree(seed));
  }
}

// Also of those that have no handle, and where a vertex has no face.
TYPED_TEST(Layers, AreThoseOfAllComponents) {
  Mesh mesh = mesh_of(
      generators::disjoint_union({soup_of({"torus", {800, 1, 0}}), soup_of({"sphere", {200, 0, 0}}),
                                  soup_of({"multi-torus", {1500, 3, 0}})}));
  mesh.add_vertex(Mesh::Point(9., 9., 9.));
  const Told told = told_by<TypeParam>(mesh);
  EXPECT_EQ(told.components, 3u);
  expect_all(mesh, told);
}

TYPED_TEST(Layers, CoverSurfacesWithBoundary) {
  Random random(32);
  for(const Recipe& recipe : {Recipe{"sphere", {600, 0, 0}}, Recipe{"lattice", {2000, 3, 0}}}) {
    SCOPED_TRACE(recipe);
    generators::Hole_request holes;
    holes.number = 3;
    holes.faces = 12;
    const Mesh mesh = mesh_of(generators::with_holes(soup_of(recipe), holes));
    expect_all(mesh, told_by<TypeParam>(mesh));
  }
}

TYPED_TEST(Layers, AreOneOnASphere) {
  const Mesh mesh = mesh_of({"sphere", {2000, 0, 0}});
  const Told told = told_by<TypeParam>(mesh);
  expect_all(mesh, told);
  EXPECT_EQ(told.number_of_layers(), 1u);
  ASSERT_EQ(told.events.size(), 1u);
  EXPECT_EQ(told.events[0].type, Front_event_type::CLOSING);
}

// The parts in which a layer lies: edges that it passes, or may pass between those of their ends,
// and the faces between them.
std::size_t number_of_parts(const Mesh& mesh, const Told& told, std::size_t layer) {
  const Events_of_layers events(told);
  const auto layers_at = layers_at_vertices(told);
  const auto comes_between = [&](std::size_t from, std::size_t to) {
    return events.after[from].count(layer) + events.after[layer].count(to) == 2;
  };
  const auto is_passed = [&](Mesh::Edge_index e) {
    for(const std::size_t a : layers_at[mesh.vertex(e, 0)])
      for(const std::size_t b : layers_at[mesh.vertex(e, 1)])
        if(comes_between(a, b) || comes_between(b, a))
          return true;
    return false;
  };
  std::vector<char> is_left(mesh.number_of_edges());
  for(const Mesh::Edge_index e : mesh.edges())
    is_left[e] = is_passed(e);
  std::size_t number = 0;
  for(const Mesh::Edge_index start : mesh.edges()) {
    number += is_left[start] != 0;
    std::vector<Mesh::Edge_index> stack(1, start);
    while(!stack.empty()) {
      const Mesh::Edge_index e = stack.back();
      stack.pop_back();
      if(is_left[e] == 0)
        continue;
      is_left[e] = 0;
      for(const Mesh::Halfedge_index h : {mesh.halfedge(e, 0), mesh.halfedge(e, 1)})
        for(const Mesh::Halfedge_index next : {mesh.next(h), mesh.prev(h)})
          stack.push_back(mesh.edge(next));
    }
  }
  return number;
}

// On meshes that are fine, where no edge may pass two layers side by side.
TYPED_TEST(Layers, HangTogether) {
  for(const Recipe& recipe : {Recipe{"torus", {8000, 1, 0}}, Recipe{"multi-torus", {8000, 2, 0}}}) {
    SCOPED_TRACE(recipe);
    const Mesh mesh = mesh_of(recipe);
    const Told told = told_by<TypeParam>(mesh);
    EXPECT_GE(told.number_of_layers(), 4 * recipe.request.genus);
    for(std::size_t layer = 1; layer <= told.number_of_layers(); ++layer)
      EXPECT_EQ(number_of_parts(mesh, told, layer), 1u) << "layer " << layer;
  }
}

TEST(Layers_of_solvers, AreTheSameToTheLastBit) {
  for(const Recipe& recipe : {Recipe{"gyroid", {20000, 9, 0}}, Recipe{"random", {2000, 30, 1}}}) {
    SCOPED_TRACE(recipe);
    const Mesh mesh = mesh_of(recipe);
    const Told expected = told_by<CGAL::Sequential_tag>(mesh);
    for(const Told& told : {told_by<CGAL::Parallel_if_available_tag>(mesh),
                            told_by<CGAL::Cuda_if_available_tag>(mesh)})
    {
      EXPECT_EQ(told.layer, expected.layer);
      EXPECT_EQ(told.time, expected.time);
      EXPECT_EQ(told.events, expected.events);
    }
  }
}

#ifdef CGAL_EIGEN3_ENABLED
// On a smooth surface, each of its own field.
TEST(Layers_of_solvers, AreAboutThoseOfTheReference) {
  const Mesh mesh = mesh_of({"torus", {8000, 1, 0}});
  const Told reference = told_by<CGAL::Reference_tag>(mesh);
  const Told host = told_by<CGAL::Sequential_tag>(mesh);
  EXPECT_EQ(reference.number_of_layers(), host.number_of_layers());
  for(std::size_t v = 0; v < host.time.size(); ++v)
    EXPECT_NEAR(host.time[v], reference.time[v], 3.);
}

// To the letter of the paper there are no exact fronts, but layers.
TEST(Layers_of_solvers, AreThereByTheLetterOfThePaper) {
  Mesh mesh = mesh_of({"torus", {8000, 1, 0}});
  const auto layers = mesh.add_property_map<Vertex, std::size_t>("v:layer", 0).first;
  const auto times = mesh.add_property_map<Vertex, double>("v:time", no_time).first;
  Solver_options options;
  options.literal_rules.bands = true;
  Solver solver(mesh);
  solver.find_loops<CGAL::Reference_tag>(
      CGAL::Emptyset_iterator(),
      params::vertex_layer_map(layers,
                               params::vertex_value_map(times, params::solver_options(options))));
  std::set<std::size_t> present;
  for(const Vertex v : mesh.vertices()) {
    present.insert(layers[v]);
    EXPECT_GE(times[v], 0.);
  }
  EXPECT_GE(*present.begin(), 1u);
  EXPECT_GE(present.size(), 4u) << "one that splits, its two parts, and what they meet in";
}
#endif

TEST(Layers_of_solvers, AreFoundIfAskedFor) {
  const Mesh sphere = mesh_of({"sphere", {500, 0, 0}}), torus = mesh_of({"torus", {500, 1, 0}});
  Solver of_sphere(sphere);
  of_sphere.find_loops(CGAL::Emptyset_iterator());
  EXPECT_EQ(of_sphere.statistics().backend, "") << "no field without handles";
  std::vector<double> times(sphere.number_of_vertices(), no_time);
  of_sphere.find_loops(CGAL::Emptyset_iterator(),
                       params::vertex_value_map(Vector_map<double>{&times}));
  EXPECT_EQ(of_sphere.statistics().backend, "host");
  EXPECT_EQ(of_sphere.statistics().front_events.size(), 0u);
  EXPECT_EQ(std::count(times.begin(), times.end(), no_time), 0);

  std::vector<std::size_t> layers(torus.number_of_vertices(), no_layer);
  Pairs pairs = find_loops(torus, params::vertex_layer_map(Vector_map<std::size_t>{&layers}));
  expect_same(pairs, find_loops(torus));
  EXPECT_EQ(std::count(layers.begin(), layers.end(), no_layer), 0);
}

} // namespace test_layers
