// Cuts: what is left is disks, the vertices and edges asked for are on the boundary, others are
// not, and the cut is short.

#include "Disks.h"
#include "Meshes_of_soups.h"
#include "Shortest_cut_oracle.h"
#include "random_input.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/cut_to_disk.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace test_cut_to_disk {

using CGAL::Handle_tunnel_loops::No_cut_exception;
using generators::Random;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
using Edges = std::vector<Mesh::Edge_index>;
using Marks = Mesh::Property_map<Mesh::Edge_index, bool>;

template <typename... NamedParameters>
Edges cut_of(const Mesh& mesh, const NamedParameters&... np) {
  Edges cut;
  CGAL::cut_to_disk(mesh, std::back_inserter(cut), np...);
  return cut;
}

double length_of(const Mesh& mesh, const Edges& cut) {
  double sum = 0.;
  for(const auto e : cut)
    sum += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum;
}

Mesh random_mesh(Random& random, std::size_t largest_genus) {
  return mesh_of(random_recipe(random, largest_genus));
}

std::vector<Mesh::Vertex_index> random_vertices(Random& random, const Mesh& mesh, std::size_t n) {
  std::vector<Mesh::Vertex_index> vertices;
  while(vertices.size() < n)
    vertices.emplace_back(static_cast<unsigned>(random.below(mesh.number_of_vertices())));
  return vertices;
}

auto marks_of(const std::vector<Mesh::Vertex_index>& cones) {
  return boost::make_function_property_map<Mesh::Vertex_index, bool>(
      [cones](Mesh::Vertex_index v) { return std::count(cones.begin(), cones.end(), v) > 0; });
}

// Lengths, infinite of marked edges.
auto weights_by(const Mesh& mesh, const Marks& avoided) {
  return boost::make_function_property_map<Mesh::Edge_index, double>(
      [&mesh, avoided](Mesh::Edge_index e) {
        return avoided[e] ? (std::numeric_limits<double>::infinity)() : length_of(mesh, {e});
      });
}

Marks marks_of(Mesh& mesh, const char* name) {
  return mesh.add_property_map<Mesh::Edge_index, bool>(name, false).first;
}

// ---- disks

TEST(Cut_to_disk, LeavesADisk) {
  Random random(1);
  for(int round = 0; round < 150; ++round) {
    const Mesh mesh = random_mesh(random, 8);
    const Edges cut = cut_of(mesh);
    const Opened_surface<Mesh> opened(mesh, cut);
    SCOPED_TRACE(testing::Message() << "round " << round);
    ASSERT_EQ(opened.number_of_pieces(), 1u);
    EXPECT_TRUE(opened.is_unique());
    EXPECT_TRUE(cut.empty() ? opened.is_sphere(0) : opened.is_disk(0));
  }
}

TEST(Cut_to_disk, LeavesADiskOfEveryKind) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 2, 6, 20}, 1)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Mesh mesh = mesh_of(recipe);
    EXPECT_TRUE(Opened_surface<Mesh>(mesh, cut_of(mesh)).are_disks());
  }
}

TEST(Cut_to_disk, IsThatOfPolyhedraToo) {
  const Recipe recipe = {"random", {600, 3, 5}};
  const auto polyhedron = mesh_of<Polyhedron>(soup_of(recipe));
  std::vector<boost::graph_traits<Polyhedron>::edge_descriptor> cut;
  CGAL::cut_to_disk(polyhedron, std::back_inserter(cut));
  EXPECT_TRUE(Opened_surface<Polyhedron>(polyhedron, cut).are_disks());
  EXPECT_EQ(cut.size(), cut_of(mesh_of(recipe)).size());
}

TEST(Cut_to_disk, TakesComponentsOneByOne) {
  Random random(2);
  for(int round = 0; round < 30; ++round) {
    std::vector<Soup> soups;
    std::size_t spheres = 0;
    for(int c = 0; c < 4; ++c) {
      const Recipe recipe = random_recipe(random, 2);
      spheres += recipe.request.genus == 0;
      soups.push_back(soup_of(recipe));
    }
    const Mesh mesh = mesh_of(generators::permute_vertices(generators::disjoint_union(soups), 1));
    const Opened_surface<Mesh> opened(mesh, cut_of(mesh));
    ASSERT_EQ(opened.number_of_pieces(), 4u);
    std::size_t left = 0;
    for(std::size_t p = 0; p < 4; ++p) {
      EXPECT_TRUE(opened.is_disk(p) || opened.is_sphere(p));
      left += opened.is_sphere(p);
    }
    EXPECT_EQ(left, spheres);
    EXPECT_TRUE(Opened_surface<Mesh>(mesh, cut_of(mesh, CGAL::parameters::do_cut_spheres(true)))
                    .are_disks());
  }
}

TEST(Cut_to_disk, DoesNotDependOnThreads) {
#ifdef CGAL_LINKED_WITH_TBB
  const Mesh mesh = mesh_of(Recipe{"gyroid", {6000, 10, 3}});
  const Edges expected = cut_of(mesh);
  for(const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Edges cut;
    CGAL::cut_to_disk<CGAL::Parallel_tag>(mesh, std::back_inserter(cut));
    EXPECT_EQ(cut, expected);
  }
#endif
}

// ---- what the caller asks for

TEST(Cut_to_disk, PassesCones) {
  Random random(3);
  for(int round = 0; round < 100; ++round) {
    const Mesh mesh = random_mesh(random, 4);
    const auto cones = random_vertices(random, mesh, 1 + random.below(6));
    const Opened_surface<Mesh> opened(
        mesh, cut_of(mesh, CGAL::parameters::vertex_is_constrained_map(marks_of(cones))));
    EXPECT_TRUE(opened.are_disks());
    for(const auto v : cones)
      EXPECT_TRUE(opened.is_on_boundary(v));
  }
}

TEST(Cut_to_disk, AvoidsEdges) {
  Random random(4);
  int cuts = 0;
  for(int round = 0; round < 200; ++round) {
    Mesh mesh = random_mesh(random, 3);
    const Marks avoided = marks_of(mesh, "e:avoided");
    const std::size_t one_in = 2 + random.below(8);
    for(const auto e : mesh.edges())
      avoided[e] = random.below(one_in) == 0;
    try {
      const Edges cut = cut_of(mesh, CGAL::parameters::edge_weight_map(weights_by(mesh, avoided)));
      const Opened_surface<Mesh> opened(mesh, cut);
      EXPECT_TRUE(cut.empty() ? opened.is_sphere(0) : opened.are_disks());
      for(const auto e : cut)
        EXPECT_FALSE(avoided[e]);
      ++cuts;
    } catch(const No_cut_exception&) {
      // Then the edges that are left have a piece of surface between them that is no disk.
      Edges left;
      for(const auto e : mesh.edges())
        if(!avoided[e])
          left.push_back(e);
      const Opened_surface<Mesh> opened(mesh, left);
      EXPECT_FALSE(opened.are_disks());
    }
  }
  EXPECT_GE(cuts, 50);
}

TEST(Cut_to_disk, KeepsEdges) {
  Random random(5);
  int cuts = 0;
  for(int round = 0; round < 100; ++round) {
    Mesh mesh = random_mesh(random, 3);
    const Marks kept = marks_of(mesh, "e:kept");
    for(std::size_t i = random.below(6); i > 0; --i)
      kept[Mesh::Edge_index(static_cast<unsigned>(random.below(mesh.number_of_edges())))] = true;
    Edges wanted;
    for(const auto e : mesh.edges())
      if(kept[e])
        wanted.push_back(e);
    if(Opened_surface<Mesh>(mesh, wanted).number_of_pieces() != 1)
      continue;
    const Edges cut = cut_of(mesh, CGAL::parameters::edge_is_constrained_map(kept));
    for(const auto e : wanted)
      EXPECT_NE(std::find(cut.begin(), cut.end(), e), cut.end());
    EXPECT_TRUE(cut.empty() || Opened_surface<Mesh>(mesh, cut).are_disks());
    ++cuts;
  }
  EXPECT_GE(cuts, 50);
}

// With a weight for edges on one half of a torus the cut stays on the other as far as it can.
TEST(Cut_to_disk, IsShortByWeights) {
  Mesh mesh = mesh_of(Recipe{"torus", {4000, 1, 0}});
  const auto weights = mesh.add_property_map<Mesh::Edge_index, double>("e:weight", 1.).first;
  for(const auto e : mesh.edges())
    weights[e] = mesh.point(mesh.vertex(e, 0)).x() > 0. ? 100. : 1.;
  const auto weight_of = [&](const Edges& cut) {
    double sum = 0.;
    for(const auto e : cut)
      sum += weights[e];
    return sum;
  };
  const Edges cut = cut_of(mesh, CGAL::parameters::edge_weight_map(weights));
  EXPECT_TRUE(Opened_surface<Mesh>(mesh, cut).are_disks());
  EXPECT_LT(weight_of(cut), weight_of(cut_of(mesh)));
}

TEST(Cut_to_disk, BeginsWithAnyLoops) {
  const Mesh mesh = mesh_of(Recipe{"multi-torus", {3000, 3, 1}});
  const Pairs pairs = find_loops(mesh);
  const Edges all = cut_of(mesh, CGAL::parameters::known_loops(pairs));
  EXPECT_TRUE(Opened_surface<Mesh>(mesh, all).are_disks());
  const Edges by_one =
      cut_of(mesh, CGAL::parameters::known_loops(std::vector{pairs.front().handle()}));
  EXPECT_TRUE(Opened_surface<Mesh>(mesh, by_one).are_disks());
  const Edges by_none = cut_of(mesh, CGAL::parameters::known_loops(Pairs()));
  EXPECT_TRUE(Opened_surface<Mesh>(mesh, by_none).are_disks());
  EXPECT_LE(length_of(mesh, all), 1.2 * length_of(mesh, by_none));
}

TEST(Cut_to_disk, RefusesWhatCannotBe) {
  Mesh mesh = mesh_of(Recipe{"torus", {400, 1, 0}});
  const auto isolated = mesh.add_vertex(CGAL::ORIGIN);
  EXPECT_THROW(cut_of(mesh, CGAL::parameters::vertex_is_constrained_map(marks_of({isolated}))),
               std::invalid_argument);
  const Marks all = marks_of(mesh, "e:all"), some = marks_of(mesh, "e:some");
  for(const auto e : mesh.edges())
    all[e] = true;
  for(const auto h : CGAL::halfedges_around_face(*mesh.halfedges().begin(), mesh))
    some[mesh.edge(h)] = true;
  EXPECT_THROW(cut_of(mesh, CGAL::parameters::edge_weight_map(weights_by(mesh, all))),
               No_cut_exception);
  EXPECT_THROW(cut_of(mesh, CGAL::parameters::edge_is_constrained_map(some)), No_cut_exception);
  EXPECT_THROW(cut_of(mesh, CGAL::parameters::edge_weight_map(weights_by(mesh, some))
                                .edge_is_constrained_map(some)),
               No_cut_exception);
  const auto weights = mesh.add_property_map<Mesh::Edge_index, double>("e:weight", 1.).first;
  weights[Mesh::Edge_index(5)] = -1.;
  EXPECT_THROW(cut_of(mesh, CGAL::parameters::edge_weight_map(weights)), std::invalid_argument);
}

// ---- short

TEST(Cut_to_disk, IsNearlyTheShortestOfGenusOne) {
  Random random(6);
  double sum = 0.;
  const int rounds = 15;
  for(int round = 0; round < rounds; ++round) {
    const Recipe recipe = {"random",
                           {40 + random.below(60), 1, static_cast<unsigned>(random.next())}};
    const Mesh mesh = mesh_of(recipe);
    const double length = length_of(mesh, cut_of(mesh));
    const double shortest = Shortest_cut_oracle(flat_mesh_of(recipe)).length(length * (1. + 1e-9));
    EXPECT_LE(length, 1.35 * shortest) << recipe;
    sum += std::log(length / shortest);
  }
  EXPECT_LE(std::exp(sum / rounds), 1.1);
  RecordProperty("mean", std::to_string(std::exp(sum / rounds)));
}

// A torus of revolution is cut best along its inner circle and around its tube.
TEST(Cut_to_disk, IsWhatOneWouldDraw) {
  const Mesh mesh = mesh_of(Recipe{"torus", {20000, 1, 0}});
  const double around_tube = 2. * 3.14159265 * 0.4, around_hole = 2. * 3.14159265 * 0.6;
  EXPECT_LE(length_of(mesh, cut_of(mesh)), 1.03 * (around_tube + around_hole));
}

// ---- seams

TEST(Seams_of_a_cut, AreCounted) {
  Mesh mesh = mesh_of(Recipe{"multi-torus", {2000, 2, 1}});
  using Vertex_marks = Mesh::Property_map<Mesh::Vertex_index, bool>;
  const Marks edge_marks = marks_of(mesh, "e:seam");
  const Vertex_marks vertex_marks =
      mesh.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first;
  using Seam_mesh = CGAL::Seam_mesh<Mesh, Marks, Vertex_marks>;
  Seam_mesh seam_mesh(mesh, edge_marks, vertex_marks);
  const Edges cut = cut_of(mesh);
  const auto first = CGAL::add_seams_of_cut(seam_mesh, cut);
  EXPECT_TRUE(get(edge_marks, mesh.edge(first)));
  EXPECT_EQ(seam_mesh.number_of_seam_edges(), cut.size());
  const long v = static_cast<long>(num_vertices(seam_mesh)),
             e = static_cast<long>(num_edges(seam_mesh)),
             f = static_cast<long>(num_faces(seam_mesh));
  EXPECT_EQ(v - e + f, 1);
  std::size_t boundary = 0;
  const boost::graph_traits<Seam_mesh>::halfedge_descriptor on_seam(first);
  const auto start = opposite(on_seam, seam_mesh);
  auto h = start;
  do {
    ++boundary;
    h = next(h, seam_mesh);
  } while(h != start && boundary <= 2 * cut.size());
  EXPECT_EQ(boundary, 2 * cut.size());
}

} // namespace test_cut_to_disk
