#include "Flat_mesh_of_soup.h"
#include "Meshes_of_soups.h"
#include "Number_of_cases.h"
#include "generators/Field.h"
#include "generators/mesh_of_field.h"

#include <CGAL/Handle_tunnel_loops/internal/reeb/find_necks.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_necks {

namespace impl = CGAL::Handle_tunnel_loops::internal;
using impl::Crossing;
using impl::Crossing_loop;
using impl::Flat_neck;

std::vector<Flat_neck> flat_necks(const Flat_mesh& mesh, double length, double share) {
  return impl::find_flat_necks(impl::Execution(), mesh, {length, share});
}

double area_of_face(const Flat_mesh& mesh, Index a, Index b, Index c) {
  using impl::operator-; // vectors are arrays
  return impl::norm(impl::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a])) /
         2.;
}

// The areas of the pieces into which loops cut the surface, each face a third to each of its
// vertices.
std::vector<double> piece_areas(const Flat_mesh& mesh, const std::vector<Flat_neck>& necks) {
  std::set<std::pair<Index, Index>> crossed;
  for(const Flat_neck& neck : necks)
    for(const Crossing& c : neck.loop)
      EXPECT_TRUE(crossed.insert(std::minmax(c.left, c.right)).second) << "an edge crossed twice";
  std::vector<char> is_reached(mesh.number_of_vertices(), 0);
  std::vector<double> areas;
  for(Index seed = 0; seed < is_reached.size(); ++seed) {
    if(is_reached[seed] != 0)
      continue;
    areas.push_back(0.);
    std::vector<Index> reached = {seed};
    is_reached[seed] = 1;
    while(!reached.empty()) {
      const Index v = reached.back();
      reached.pop_back();
      const impl::Ring ring = mesh.ring(v);
      for(Index p = 0; p < ring.size(); ++p) {
        areas.back() += area_of_face(mesh, v, ring[p], ring[ring.next(p)]) / 3.;
        if(is_reached[ring[p]] == 0 && crossed.count(std::minmax(v, ring[p])) == 0) {
          is_reached[ring[p]] = 1;
          reached.push_back(ring[p]);
        }
      }
    }
  }
  return areas;
}

// Of the area, how much is on the smaller side of a neck.
double smaller_share(const Flat_mesh& mesh, const Flat_neck& neck) {
  const std::vector<double> sides = piece_areas(mesh, {neck});
  return (std::min)(sides[0], sides[1]) / (sides[0] + sides[1]);
}

bool visits_no_vertex_twice(const Crossing_loop& loop, Index Crossing::*side) {
  std::vector<Index> walk;
  for(const Crossing& c : loop)
    if(walk.empty() || walk.back() != c.*side)
      walk.push_back(c.*side);
  if(walk.size() > 1 && walk.front() == walk.back())
    walk.pop_back();
  return walk.size() >= 3 && std::set<Index>(walk.begin(), walk.end()).size() == walk.size();
}

// All that find_necks() promises, for a connected surface.
void expect_necks(const Flat_mesh& mesh,
                  const std::vector<Flat_neck>& necks,
                  double length,
                  double share) {
  std::set<Index> ends_of_all;
  double previous = 0.;
  for(const Flat_neck& neck : necks) {
    EXPECT_TRUE(impl::are_consecutive(mesh, neck.loop));
    EXPECT_DOUBLE_EQ(neck.length, impl::length(mesh, neck.loop));
    EXPECT_LT(neck.length, length);
    EXPECT_GE(neck.length, previous);
    previous = neck.length;
    EXPECT_TRUE(visits_no_vertex_twice(neck.loop, &Crossing::left) ||
                visits_no_vertex_twice(neck.loop, &Crossing::right));
    std::set<Index> ends;
    for(const Crossing& c : neck.loop) {
      ends.insert(c.left);
      ends.insert(c.right);
    }
    for(Index v : ends)
      EXPECT_TRUE(ends_of_all.insert(v).second) << "necks meet";
    const std::vector<double> sides = piece_areas(mesh, {neck});
    ASSERT_EQ(sides.size(), 2u);
  }
  const std::vector<double> pieces = piece_areas(mesh, necks);
  ASSERT_EQ(pieces.size(), necks.size() + 1);
  double all = 0.;
  for(double area : pieces)
    all += area;
  for(double area : pieces)
    EXPECT_GE(area, (share - 1e-9) * all);
}

Soup stretched(Soup soup, double factor) {
  for(auto& point : soup.points)
    point[0] *= factor;
  return soup;
}

Request necks_request(std::size_t genus, std::size_t necks, unsigned seed) {
  Request request = {60000, genus, seed};
  request.necks = necks;
  return request;
}

TEST(Necks, AreFoundBetweenTwoBodies) {
  for(const char* kind : {"twins", "hollow"})
    for(const std::size_t genus : {0, 1, 3})
      for(unsigned seed = 0; seed < (are_few_cases_tried() ? 1 : 3); ++seed) {
        const Recipe recipe = {kind, necks_request(genus, 1, seed)};
        SCOPED_TRACE(testing::PrintToString(recipe));
        const Flat_mesh mesh = flat_mesh_of(recipe);
        const std::vector<Flat_neck> necks = flat_necks(mesh, 0.5, 0.1);
        ASSERT_EQ(necks.size(), 1u);
        EXPECT_GT(smaller_share(mesh, necks.front()), 0.35);
        expect_necks(mesh, necks, 0.5, 0.1);
      }
}

TEST(Necks, AreNoneOfSeveralThatJoinTheSameBodies) {
  for(const char* kind : {"twins", "hollow"})
    for(const std::size_t number : {2, 7})
      EXPECT_TRUE(flat_necks(flat_mesh_of({kind, necks_request(0, number, 0)}), 0.5, 0.1).empty());
}

TEST(Necks, AreAsShortAndCutOffAsMuchAsIsAskedFor) {
  const Flat_mesh mesh = flat_mesh_of({"hollow", necks_request(0, 1, 0)});
  const std::vector<Flat_neck> necks = flat_necks(mesh, 0.5, 0.1);
  ASSERT_EQ(necks.size(), 1u);
  const double length = necks.front().length, share = smaller_share(mesh, necks.front());
  EXPECT_EQ(flat_necks(mesh, 1.001 * length, 0.1).size(), 1u);
  EXPECT_EQ(flat_necks(mesh, length, 0.1).size(), 0u);
  EXPECT_EQ(flat_necks(mesh, 0.5, 0.999 * share).size(), 1u);
  EXPECT_EQ(flat_necks(mesh, 0.5, 1.001 * share).size(), 0u);
}

TEST(Necks, AreNotOnPlainBodies) {
  const Soup sphere = soup_of({"sphere", {20000, 0, 0}}), torus = soup_of({"torus", {20000, 1, 0}});
  for(const double length : {0.1, 1., 100.})
    for(const double share : {0.001, 0.05}) {
      for(const double factor : {1., 1.5, 3.})
        EXPECT_TRUE(flat_necks(flat_mesh_of(stretched(sphere, factor)), length, share).empty());
      EXPECT_TRUE(flat_necks(flat_mesh_of(torus), length, share).empty());
    }
}

// Balls joined by tubes, as a tree.
class Beads : public generators::Field
{
public:
  using Vec = generators::Vector;

  explicit Beads(std::vector<std::pair<Vec, Vec>> tubes)
      : tubes_(std::move(tubes)) {}

  generators::Box box() const override {
    generators::Box box = {tubes_[0].first, tubes_[0].first};
    for(const auto& [p, q] : tubes_)
      box = box.with(p).with(q);
    return box.grown(0.5);
  }

  double operator()(const Vec& p) const override {
    double least = std::numeric_limits<double>::max();
    for(const auto& [a, b] : tubes_) {
      const Vec along = b - a;
      const double t = std::clamp(((p - a) * along) / along.squared_length(), 0., 1.);
      least = (std::min)({least, generators::length(p - a) - 0.35, generators::length(p - b) - 0.35,
                          generators::length(p - a - t * along) - 0.1});
    }
    return least;
  }

private:
  std::vector<std::pair<Vec, Vec>> tubes_;
};

// A tree of neighbours in a grid, grown at random.
std::vector<std::pair<Beads::Vec, Beads::Vec>> random_tree(std::size_t edges, unsigned seed) {
  std::vector<std::array<int, 3>> nodes = {{0, 0, 0}};
  std::vector<std::pair<Beads::Vec, Beads::Vec>> tubes;
  std::uint64_t state = seed + 1;
  const auto below = [&](std::size_t n) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::size_t>(state >> 33) % n;
  };
  while(tubes.size() < edges) {
    const std::array<int, 3> from = nodes[below(nodes.size())];
    std::array<int, 3> to = from;
    to[below(3)] += below(2) == 0 ? -1 : 1;
    if(std::find(nodes.begin(), nodes.end(), to) != nodes.end())
      continue;
    nodes.push_back(to);
    tubes.emplace_back(Beads::Vec(from[0], from[1], from[2]), Beads::Vec(to[0], to[1], to[2]));
  }
  return tubes;
}

TEST(Necks, AreAllFoundOnTrees) {
  for(const std::size_t edges : {1, 2, 5, 12})
    for(unsigned seed = 0; seed < (are_few_cases_tried() ? 2 : 5); ++seed) {
      SCOPED_TRACE("edges " + std::to_string(edges) + " seed " + std::to_string(seed));
      const Soup soup =
          generators::mesh_of_field(Beads(random_tree(edges, seed)), 4000 * (edges + 1));
      const Flat_mesh mesh = flat_mesh_of(soup);
      const double share = 0.3 / static_cast<double>(edges + 1);
      const std::vector<Flat_neck> necks = flat_necks(mesh, 1., share);
      EXPECT_EQ(necks.size(), edges);
      expect_necks(mesh, necks, 1., share);
    }
}

TEST(Necks, AreTheSameInAnyOrderOfTheVertices) {
  const Soup soup = generators::mesh_of_field(Beads(random_tree(6, 0)), 20000);
  for(unsigned seed = 0; seed < 5; ++seed) {
    const Flat_mesh mesh = flat_mesh_of(generators::permute_vertices(soup, seed));
    const std::vector<Flat_neck> necks = flat_necks(mesh, 1., 0.05);
    EXPECT_EQ(necks.size(), 6u);
    expect_necks(mesh, necks, 1., 0.05);
  }
}

TEST(Necks, DoNotDependOnTheThreads) {
  const Flat_mesh mesh = flat_mesh_of(generators::mesh_of_field(Beads(random_tree(8, 1)), 30000));
  const std::vector<Flat_neck> necks = flat_necks(mesh, 1., 0.03);
  const std::vector<Flat_neck> others =
      impl::find_flat_necks(impl::Execution::parallel(), mesh, {1., 0.03});
  ASSERT_EQ(necks.size(), others.size());
  for(std::size_t i = 0; i < necks.size(); ++i) {
    ASSERT_EQ(necks[i].loop.size(), others[i].loop.size());
    for(std::size_t j = 0; j < necks[i].loop.size(); ++j) {
      EXPECT_EQ(necks[i].loop[j].left, others[i].loop[j].left);
      EXPECT_EQ(necks[i].loop[j].right, others[i].loop[j].right);
      EXPECT_EQ(necks[i].loop[j].ratio, others[i].loop[j].ratio);
    }
  }
}

template <typename TriangleMesh> void expect_necks_on(const TriangleMesh& mesh, double unit) {
  using Kernel =
      typename CGAL::Kernel_traits<typename boost::property_traits<typename boost::property_map<
          TriangleMesh, CGAL::vertex_point_t>::const_type>::value_type>::Kernel;
  const auto necks =
      impl::find_necks(impl::Execution(), mesh, get(CGAL::vertex_point, mesh),
                       CGAL::get_initialized_vertex_index_map(mesh), Kernel(), unit, 0.05);
  ASSERT_EQ(necks.size(), 4u); // two in each component
  for(std::size_t i = 0; i < necks.size(); ++i) {
    EXPECT_EQ(necks[i].pair_index(), i);
    EXPECT_NEAR(necks[i].length(), 2. * 3.1416 * 0.1 * unit, 0.05 * unit);
  }
}

TEST(Necks, AreFoundOnAnyMeshInItsUnitAndInEachComponent) {
  const std::vector<std::pair<Beads::Vec, Beads::Vec>> chain = {
      {Beads::Vec(0, 0, 0), Beads::Vec(1, 0, 0)}, {Beads::Vec(1, 0, 0), Beads::Vec(2, 0, 0)}};
  const Soup beads = generators::mesh_of_field(Beads(chain), 12000);
  const Soup both = generators::disjoint_union({beads, beads});
  expect_necks_on(mesh_of<Mesh>(transformed(both, 1., 0.)), 1.);
  expect_necks_on(mesh_of<Mesh>(transformed(both, 1000., 7.)), 1000.);
  expect_necks_on(
      mesh_of<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>(transformed(both, 0.01, 7.)),
      0.01);
}

} // namespace test_necks
