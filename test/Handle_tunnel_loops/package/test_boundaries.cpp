// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces with boundary: loops stay on the surface, and are a basis of its first homology group
// together with all boundary curves but one of each component.

#include "Boundary_definitions.h"
#include "Disks.h"
#include "Loop_definitions.h"
#include "Meshes_of_soups.h"
#include "Number_of_cases.h"
#include "Walk_of_class_oracle.h"

#include "generators/Random.h"
#include "generators/generators.h"

#include <CGAL/Handle_tunnel_loops/loops_as_edges.h>
#include <CGAL/boundary_loops.h>
#include <CGAL/cut_to_disk.h>
#include <CGAL/reeb_graph.h>
#include <CGAL/reeb_graph_of_function.h>
#include <CGAL/remove_handles.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_boundaries {

using generators::Random;

Soup soup_with_holes(const Recipe& recipe, std::size_t number, std::size_t size, Random& random) {
  generators::Hole_request holes;
  holes.number = number;
  holes.faces = size;
  holes.is_ragged = random.below(2) == 0;
  holes.seed = static_cast<unsigned>(random.next());
  holes.may_be_fewer = true;
  return generators::with_holes(soup_of(recipe), holes);
}

void expect_loops(const Soup& soup, std::size_t genus) {
  const Mesh mesh = mesh_of(soup);
  const std::size_t number_of_boundaries = generators::number_of_boundaries(soup);
  ASSERT_GT(number_of_boundaries, 0u);
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  EXPECT_EQ(solver.genus(), genus);
  EXPECT_EQ(solver.number_of_boundaries(), number_of_boundaries);
  Pairs pairs;
  solver.find_loops(std::back_inserter(pairs));
  expect_pairs_with_boundaries(mesh, pairs, genus);
  EXPECT_TRUE(CGAL::certify_handle_tunnel_loops(mesh, pairs));
}

TEST(Boundaries, AreNotLeft) {
  Random random(1);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 5}, 2))
    for(const std::size_t size : {1, 20, 200}) {
      SCOPED_TRACE(testing::Message() << recipe << ", holes of " << size << " faces");
      expect_loops(soup_with_holes(recipe, 1 + random.below(12), size, random),
                   recipe.request.genus);
    }
}

TEST(Boundaries, MayBeEverywhere) {
  Random random(2);
  for(const Recipe& recipe : recipes_of_all_kinds({1, 4}, 2)) {
    SCOPED_TRACE(testing::Message() << recipe);
    expect_loops(soup_with_holes(recipe, recipe.request.faces, 1, random), recipe.request.genus);
  }
}

// ---- what loops are for

Mesh mesh_with_holes(const Recipe& recipe, std::size_t number, std::size_t size, Random& random) {
  return mesh_of(soup_with_holes(recipe, number, size, random));
}

TEST(Boundaries, AreReachedByCuts) {
  Random random(3);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 2))
    for(const std::size_t size : {1, 30}) {
      SCOPED_TRACE(testing::Message() << recipe << ", holes of " << size << " faces");
      const Mesh mesh = mesh_with_holes(recipe, 1 + random.below(6), size, random);
      std::vector<Mesh::Edge_index> cut;
      CGAL::cut_to_disk(mesh, std::back_inserter(cut));
      for(const auto e : cut)
        ASSERT_FALSE(is_border(e, mesh));
      for(const auto e : edges(mesh))
        if(is_border(e, mesh))
          cut.push_back(e);
      const Opened_surface<Mesh> opened(mesh, cut);
      EXPECT_EQ(opened.number_of_pieces(), 1u);
      EXPECT_TRUE(opened.are_disks());
    }
}

TEST(Boundaries, AreFilledByReebGraphsWithCaps) {
  using Graph = CGAL::Reeb_graph<Mesh>;
  Random random(4);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 2)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_with_holes(recipe, 1 + random.below(9), 1 + random.below(60), random);
    for(const bool of_function : {false, true}) {
      Graph graph;
      CGAL::Handle_tunnel_loops::Reeb_options options;
      options.capped = true;
      const auto np = CGAL::parameters::reeb_options(options);
      const auto height = [&](Mesh::Vertex_index v) { return mesh.point(v).z(); };
      const auto map = boost::make_function_property_map<Mesh::Vertex_index>(height);
      if(of_function)
        CGAL::reeb_graph_of_function(mesh, map, graph, np);
      else
        CGAL::reeb_graph(mesh, graph, np);
      EXPECT_EQ(num_edges(graph) + 1 - num_vertices(graph), recipe.request.genus);
      std::set<Mesh::Vertex_index> seen;
      for(const auto arc : boost::make_iterator_range(boost::edges(graph)))
        for(const Mesh::Vertex_index v : graph[arc].vertices)
          EXPECT_TRUE(mesh.has_valid_index(v) && !mesh.is_removed(v) && seen.insert(v).second);
    }
  }
}

// Loops come to large holes, and are led beside them; these are round, so that there is room.
TEST(Boundaries, StayWhereHandlesAreRemoved) {
  std::size_t before = 0, after = 0;
  for(const char* kind : {"torus", "multi-torus", "lattice", "gyroid"})
    for(const std::size_t size : {20, 300}) {
      const Recipe recipe = {kind, {4000, kind == std::string("torus") ? 1u : 4u, 1}};
      SCOPED_TRACE(testing::Message() << recipe << ", holes of " << size << " faces");
      generators::Hole_request holes;
      holes.number = 5;
      holes.faces = size;
      Mesh mesh = mesh_of(generators::with_holes(soup_of(recipe), holes));
      const auto walks = boundary_walks(mesh);
      const auto report = CGAL::remove_handles(mesh);
      EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
      EXPECT_EQ(boundary_walks(mesh).size(), walks.size());
      for(const auto& walk : walks)
        for(const auto h : walk)
          EXPECT_TRUE(!mesh.is_removed(h) && is_border(h, mesh));
      EXPECT_EQ(CGAL::Handle_tunnel_loops_solver<Mesh>(mesh).genus(), report.genus_after);
      before += report.genus_before;
      after += report.genus_after;
    }
  EXPECT_LE(8 * after, before) << after << " of " << before << " handles are left";
}

TEST(Boundaries, DoNotKeepLoopsFromEdges) {
  Random random(6);
  for(const Recipe& recipe : recipes_of_all_kinds({1, 4}, 2)) {
    SCOPED_TRACE(testing::Message() << recipe);
    Mesh mesh = mesh_with_holes(recipe, 1 + random.below(9), 1 + random.below(60), random);
    const std::size_t boundaries = boundary_walks(mesh).size();
    const Pairs pairs = find_loops(mesh);
    for(const auto& pair : pairs) {
      std::vector<Mesh::Halfedge_index> walk;
      CGAL::loop_to_halfedges(pair.handle(), mesh, std::back_inserter(walk));
      ASSERT_FALSE(walk.empty());
      for(std::size_t i = 0; i < walk.size(); ++i)
        EXPECT_EQ(mesh.target(walk[i]), mesh.source(walk[(i + 1) % walk.size()]));
    }
    CGAL::imprint_loops(pairs, mesh, CGAL::Emptyset_iterator());
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_triangle_mesh(mesh));
    EXPECT_EQ(boundary_walks(mesh).size(), boundaries);
    EXPECT_EQ(CGAL::Handle_tunnel_loops_solver<Mesh>(mesh).genus(), recipe.request.genus);
  }
}

// ---- inside and outside

// A face at each boundary edge, to the middle of that. Coordinates are rounded such that it is
// exact.
Soup with_flat_rims(Soup soup) {
  for(auto& point : soup.points)
    for(double& x : point)
      x = std::round(std::ldexp(x, 32)) / std::ldexp(1., 32);
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for(const auto& t : soup.triangles)
    for(int i = 0; i < 3; ++i)
      edges.emplace(t[i], t[(i + 1) % 3]);
  for(const auto& [u, v] : edges)
    if(edges.count({v, u}) == 0) {
      const auto &p = soup.points[u], &q = soup.points[v];
      soup.triangles.push_back({v, u, static_cast<std::uint32_t>(soup.points.size())});
      soup.points.push_back({(p[0] + q[0]) / 2., (p[1] + q[1]) / 2., (p[2] + q[2]) / 2.});
    }
  return soup;
}

std::vector<bool> sides(const Mesh& mesh) {
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  Pairs pairs;
  solver.find_loops(std::back_inserter(pairs));
  std::vector<bool> result;
  for(const auto& linking : solver.certificate().linking)
    result.insert(result.end(),
                  {linking.bounds_inside(), linking.bounds_outside(), linking.problem.empty()});
  return result;
}

TEST(Boundaries, LeaveInsideAndOutsideKnown) {
  Random random(7);
  for(const Recipe& recipe : {Recipe{"multi-torus", {2000, 3, 0}}, Recipe{"knot", {1500, 1, 0}},
                              Recipe{"lattice", {3000, 5, 0}}})
  {
    SCOPED_TRACE(testing::Message() << recipe);
    const Soup soup = soup_with_holes(recipe, 5, 10, random);
    std::vector<bool> expected;
    for(std::size_t k = 0; k < recipe.request.genus; ++k)
      expected.insert(expected.end(), {true, false, true, false, true, true});
    EXPECT_EQ(sides(mesh_of(soup)), expected);
    // The other way around, too: a handle is what bounds behind the faces.
    EXPECT_EQ(sides(mesh_of(generators::reversed(soup))), expected);
  }
}

// A copy of a loop that entered a cap would meet whatever lies in its way: here the rest of the
// surface, as holes are so large or ragged that straight caps cross it. The discs that were there
// cross nothing.
TEST(Boundaries, LeaveTheSidesOfTheClosedSurface) {
  Random random(9);
  for(const Recipe& recipe : recipes_of_all_kinds({1, 4}, 4))
    for(const std::size_t part : {40, 8, 4}) { // of the faces, in each of three holes
      if(recipe.kind == std::string("random")) // it crosses itself
        continue;
      SCOPED_TRACE(testing::Message() << recipe << ", holes of a part of 1/" << part);
      const std::vector<bool> closed = sides(mesh_of(recipe));
      EXPECT_EQ(sides(mesh_with_holes(recipe, 3, recipe.request.faces / part, random)), closed);
    }
}

// Faces without area are added at all boundary edges of some holes: copies of the curves must not
// run over them.
TEST(Boundaries, AreGoneAroundWhereFacesHaveNoArea) {
  Random random(13);
  for(const char* kind : {"torus", "multi-torus", "lattice"}) {
    const Recipe recipe = {kind, {4000, kind == std::string("torus") ? 1u : 4u, 1}};
    SCOPED_TRACE(recipe);
    const std::vector<bool> closed = sides(mesh_of(recipe));
    EXPECT_EQ(sides(mesh_of(with_flat_rims(soup_with_holes(recipe, 2, 12, random)))), closed);
  }
}

TEST(Boundaries, TellBehindByTheirFaces) {
  Random random(8);
  const Soup soup = soup_with_holes({"torus", {2000, 1, 0}}, 3, 10, random);
  const Pairs pairs = find_loops(mesh_of(soup)),
              reversed = find_loops(mesh_of(generators::reversed(soup)));
  EXPECT_LT(pairs[0].handle().length(), pairs[0].tunnel().length());
  EXPECT_NEAR(pairs[0].handle().length(), reversed[0].tunnel().length(), 1e-3);
  EXPECT_NEAR(pairs[0].tunnel().length(), reversed[0].handle().length(), 1e-3);
}

// ---- boundary loops

TEST(Boundary_loops, FollowTheBoundary) {
  Random random(10);
  const Mesh mesh = mesh_with_holes({"multi-torus", {3000, 2, 0}}, 6, 40, random);
  std::vector<CGAL::Loop_on_surface<Mesh>> curves, tight;
  CGAL::boundary_loops(mesh, std::back_inserter(curves));
  CGAL::boundary_loops(
      mesh, std::back_inserter(tight),
      CGAL::parameters::basis_kind(CGAL::Handle_tunnel_loops::Basis_kind::SHORTEST));
  ASSERT_EQ(curves.size(), 6u);
  ASSERT_EQ(tight.size(), 6u);
  const Homology_by_collapse<Mesh> homology(mesh);
  for(std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(curves[i].type(), CGAL::Loop_type::BOUNDARY);
    EXPECT_EQ(curves[i].pair_index(), i);
    expect_loop(mesh, get(CGAL::vertex_point, mesh), curves[i]);
    expect_loop(mesh, get(CGAL::vertex_point, mesh), tight[i]);
    for(const auto h : walk_beside(mesh, curves[i]))
      EXPECT_TRUE(is_border(opposite(h, mesh), mesh));
    EXPECT_LE(tight[i].length(), curves[i].length());
    EXPECT_EQ(homology.coordinates(walk_beside(mesh, tight[i])),
              homology.coordinates(walk_beside(mesh, curves[i])));
  }
}

// Around the z axis, from z = -2 to z = 2.
template <typename Radius> Mesh tube(const Radius& radius) {
  const unsigned around = 40, along = 60;
  Soup soup;
  for(unsigned i = 0; i <= along; ++i)
    for(unsigned j = 0; j < around; ++j) {
      const double z = 4. * i / along - 2., a = 2. * CGAL_PI * j / around;
      soup.points.push_back({radius(z) * std::cos(a), radius(z) * std::sin(a), z});
    }
  for(unsigned i = 0; i < along; ++i)
    for(unsigned j = 0; j < around; ++j) {
      const unsigned v = i * around + j, w = i * around + (j + 1) % around;
      soup.triangles.push_back({v, w, v + around});
      soup.triangles.push_back({w, w + around, v + around});
    }
  return mesh_of(soup);
}

std::vector<CGAL::Loop_on_surface<Mesh>> waists_of(const Mesh& mesh) {
  std::vector<CGAL::Loop_on_surface<Mesh>> waists;
  CGAL::boundary_loops(
      mesh, std::back_inserter(waists),
      CGAL::parameters::basis_kind(CGAL::Handle_tunnel_loops::Basis_kind::SHORTEST));
  return waists;
}

TEST(Boundary_loops, ShrinkToTheWaist) {
  const auto waists = waists_of(tube([](double z) { return 0.5 + 0.25 * z * z; }));
  ASSERT_EQ(waists.size(), 2u);
  for(const auto& waist : waists)
    EXPECT_NEAR(waist.length(), CGAL_PI, 0.02 * CGAL_PI);
}

// The curve at the upper end would rest at the wider waist beside it.
TEST(Boundary_loops, ShrinkToTheNarrowestWaist) {
  const auto waists =
      waists_of(tube([](double z) { return 0.75 + 0.1 * z + 0.2 * std::cos(2. * CGAL_PI * z); }));
  ASSERT_EQ(waists.size(), 2u);
  EXPECT_NEAR(waists[0].length(), waists[1].length(), 1e-3);
  for(const auto& waist : waists) {
    EXPECT_LT(waist.length(), 2. * CGAL_PI * 0.41);
    for(const auto& p : waist.points())
      EXPECT_NEAR(p.z(), -1.5, 0.1);
  }
}

TEST(Boundary_loops, ShrinkInTheirClass) {
  Random random(11);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 2))
    for(const std::size_t number : {2, 5}) {
      SCOPED_TRACE(testing::Message() << recipe << ", " << number << " holes");
      const Mesh mesh = mesh_with_holes(recipe, number, 1 + random.below(100), random);
      const Homology_by_collapse<Mesh> homology(mesh);
      std::vector<CGAL::Loop_on_surface<Mesh>> curves;
      CGAL::boundary_loops(mesh, std::back_inserter(curves));
      const auto waists = waists_of(mesh);
      ASSERT_EQ(waists.size(), curves.size());
      for(std::size_t i = 0; i < waists.size(); ++i) {
        expect_loop(mesh, get(CGAL::vertex_point, mesh), waists[i]);
        EXPECT_LE(waists[i].length(), (1. + 1e-12) * curves[i].length());
        EXPECT_EQ(homology.coordinates(walk_beside(mesh, waists[i])),
                  homology.coordinates(walk_beside(mesh, curves[i])));
      }
      if(waists.size() == 2) { // of one class but for the sense
        EXPECT_NEAR(waists[0].length(), waists[1].length(), 1e-12 * waists[0].length());
      }
    }
}

// Decides which chains of edges bound, by the definition: integer elimination in the boundary
// matrix of the faces. Its minors are 0, 1 and -1, as the surface is oriented, and so are all
// entries.
class Bounding_chains
{
public:
  explicit Bounding_chains(const Mesh& mesh)
      : mesh_(mesh) {
    for(const Mesh::Face_index f : faces(mesh)) {
      Chain chain;
      for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
        add(h, 1, chain);
      reduce(chain);
      if(!chain.empty())
        columns_.emplace(chain.begin()->first, chain);
    }
  }

  bool are_homologous(const Edge_walk<Mesh>& a, const Edge_walk<Mesh>& b) const {
    Chain chain;
    for(const Mesh::Halfedge_index h : a)
      add(h, 1, chain);
    for(const Mesh::Halfedge_index h : b)
      add(h, -1, chain);
    reduce(chain);
    return chain.empty();
  }

private:
  using Chain = std::map<Mesh::Edge_index, std::int64_t>;

  static void add(Mesh::Edge_index e, std::int64_t times, Chain& chain) {
    if((chain[e] += times) == 0)
      chain.erase(e);
  }

  void add(Mesh::Halfedge_index h, std::int64_t times, Chain& chain) const {
    add(mesh_.edge(h), mesh_.source(h) < mesh_.target(h) ? times : -times, chain);
  }

  // By columns with other first edges, from the first edge on.
  void reduce(Chain& chain) const {
    for(const auto& [e, column] : columns_)
      if(const auto found = chain.find(e); found != chain.end()) {
        const std::int64_t times = found->second * column.begin()->second;
        for(const auto& [other, value] : column)
          add(other, -times * value, chain);
      }
  }

  const Mesh& mesh_;
  std::map<Mesh::Edge_index, Chain> columns_; // by first edge
};

// A coarse tube around the z axis with holes of one face each: many loops run along some of them.
Mesh tube_with_small_holes(Random& random) {
  const std::size_t around = 4 + random.below(6), along = 4 + random.below(8);
  const double phase = random.uniform(0., 6.), height = random.uniform(1., 4.);
  Soup soup;
  for(std::size_t i = 0; i <= along; ++i)
    for(std::size_t j = 0; j < around; ++j) {
      const double z = height * double(i) / double(along), r = 1. + 0.5 * std::cos(phase + 3. * z),
                   a = 2. * CGAL_PI * (double(j) + random.uniform(0., 0.3)) / double(around);
      soup.points.push_back({r * std::cos(a), r * std::sin(a), z});
    }
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < around; ++j) {
      const unsigned v = static_cast<unsigned>(i * around + j),
                     w = static_cast<unsigned>(i * around + (j + 1) % around),
                     n = static_cast<unsigned>(around);
      soup.triangles.push_back({v, w, v + n});
      soup.triangles.push_back({w, w + n, v + n});
    }
  Mesh mesh = mesh_of(soup);
  for(int i = 0; i < 4; ++i) {
    const Mesh::Face_index f(static_cast<std::uint32_t>(random.below(soup.triangles.size())));
    if(mesh.is_removed(f))
      continue;
    const auto corners = CGAL::vertices_around_face(mesh.halfedge(f), mesh);
    if(std::none_of(corners.begin(), corners.end(),
                    [&](Mesh::Vertex_index v) { return mesh.is_border(v); }))
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  }
  mesh.collect_garbage();
  return mesh;
}

TEST(Boundary_loops, ShrinkInTheirClassBesideHoles) {
  Random random(15);
  for(int i = 0; i < number_of_cases(1000); ++i) {
    SCOPED_TRACE(i);
    const Mesh mesh = tube_with_small_holes(random);
    const Bounding_chains chains(mesh);
    std::vector<CGAL::Loop_on_surface<Mesh>> curves;
    CGAL::boundary_loops(mesh, std::back_inserter(curves));
    for(const auto& waist : waists_of(mesh)) {
      const auto& curve = curves[waist.pair_index()];
      EXPECT_LE(waist.length(), (1. + 1e-12) * curve.length());
      EXPECT_TRUE(chains.are_homologous(walk_beside(mesh, waist), walk_beside(mesh, curve)));
    }
  }
}

// Where the shortest chain is several loops, as on trousers, too.
TEST(Boundary_loops, AreNoLongerThanAnyWalkOfTheirClass) {
  Random random(14);
  for(const char* kind : {"sphere", "torus", "multi-torus"})
    for(const std::size_t number : {2, 3, 4})
      for(int i = 0; i < (are_few_cases_tried() ? 1 : 30); ++i) {
        const std::size_t genus = kind == std::string("sphere") ? 0 : kind[0] == 't' ? 1 : 2;
        const Recipe recipe = {kind, {300 + 150 * genus, genus, 0}};
        SCOPED_TRACE(testing::Message() << recipe << ", " << number << " holes, " << i);
        const Mesh mesh = mesh_with_holes(recipe, number, 1 + random.below(60), random);
        const Homology_by_collapse<Mesh> homology(mesh);
        const Walk_of_class_oracle<Mesh> oracle(mesh);
        std::vector<CGAL::Loop_on_surface<Mesh>> curves;
        CGAL::boundary_loops(mesh, std::back_inserter(curves));
        const auto waists = waists_of(mesh);
        ASSERT_EQ(waists.size(), curves.size());
        for(std::size_t k = 0; k < waists.size(); ++k) {
          const auto curve = walk_beside(mesh, curves[k]);
          EXPECT_EQ(homology.coordinates(walk_beside(mesh, waists[k])),
                    homology.coordinates(curve));
          const double length = waists[k].length();
          EXPECT_EQ(oracle.shortest(curve, (1. - 1e-12) * length).value_or(length), length);
        }
      }
}

// It bounds the component; those of another one have waists, and these the numbers of their curves.
TEST(Boundary_loops, HaveNoWaistWhereThereIsOne) {
  Random random(12);
  for(const std::size_t genus : {0, 1, 2}) {
    const Recipe recipe{"multi-torus", {3000, genus, 0}};
    Mesh mesh = mesh_with_holes(recipe, 1, 40, random);
    EXPECT_TRUE(waists_of(mesh).empty());
    mesh += mesh_with_holes(recipe, 3, 40, random);
    mesh.collect_garbage();
    const auto waists = waists_of(mesh);
    ASSERT_EQ(waists.size(), 3u);
    for(std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(waists[i].pair_index(), i + 1);
  }
}

} // namespace test_boundaries
