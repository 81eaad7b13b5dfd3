// Linking numbers: solids of which they are known, Gauss' integral, and what must not change them.

#include "Changed_loops.h"
#include "Gauss_linking.h"
#include "Solids.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_linker.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_linking {

using CGAL::certify_handle_tunnel_loops;
using CGAL::Handle_tunnel_loops::Certificate;
using CGAL::Handle_tunnel_loops::Loop_linking;
using Rows = std::vector<std::vector<std::int64_t>>;

Rows rows_of(const Certificate& c) {
  Rows rows(c.linking.size(), std::vector<std::int64_t>(c.linking.size(), 0));
  for(std::size_t i = 0; i < rows.size(); ++i)
    for(const auto& [j, value] : c.linking[i].row)
      rows[i][j] = value;
  return rows;
}

// ---- solids of which the answer is known

struct Known_solid
{
  const char* name;
  Soup (*make)();
  std::size_t genus, handles_bound_inside, tunnels_bound_outside;
  bool bound_in_own_component; // all of them, were the other components not there
};

class Solids : public testing::TestWithParam<Known_solid>
{
protected:
  void expect_answer(const Soup& soup) const {
    const Mesh mesh = mesh_of(soup);
    const Pairs pairs = find_loops(mesh);
    ASSERT_EQ(pairs.size(), GetParam().genus);
    const Certificate c = certify_handle_tunnel_loops(mesh, pairs);
    EXPECT_TRUE(bool(c)) << c.failure;
    EXPECT_EQ(c.handles_bound_inside, GetParam().handles_bound_inside);
    EXPECT_EQ(c.tunnels_bound_outside, GetParam().tunnels_bound_outside);
    for(std::size_t i = 0; i < c.linking.size(); ++i) {
      EXPECT_EQ(c.linking[i].problem, "");
      if(GetParam().bound_in_own_component) {
        EXPECT_EQ(c.linking[i].bounds_inside_component, i % 2 == 0);
        EXPECT_EQ(c.linking[i].bounds_outside_component, i % 2 == 1);
      }
    }
  }
};

INSTANTIATE_TEST_SUITE_P(
    Known,
    Solids,
    testing::Values(Known_solid{"ring", ring, 1, 1, 1, true},
                    // Each shell's loops bound in the hollow or outside, but
                    // nothing bounds between the shells.
                    Known_solid{"hollow_ring", hollow_ring, 2, 0, 2, true},
                    // The tunnel loop of a ring is linked with that of the
                    // other.
                    Known_solid{"linked_rings", linked_rings, 2, 2, 0, true},
                    Known_solid{"ball_with_ring_cavity", ball_with_ring_cavity, 1, 1, 1, true},
                    Known_solid{"ring_within_shells", ring_within_shells, 1, 1, 1, true},
                    // The short way along the knot winds around it.
                    Known_solid{"trefoil_tube", trefoil_tube, 1, 1, 1, true},
                    // The short way along the tunnel is no boundary either.
                    Known_solid{"ball_with_knotted_tunnel", ball_with_knotted_tunnel, 1, 1, 1,
                                true}),
    [](const auto& test) { return test.param.name; });

TEST_P(Solids, AreToldInsideFromOutside) { expect_answer(GetParam().make()); }

TEST_P(Solids, MayHaveFacesThatLookInwards) {
  Soup soup = GetParam().make();
  reverse_orientation(soup);
  expect_answer(soup);
}

TEST_P(Solids, MayBeOfAnySizeAndFarAway) {
  for(const auto& [scale, shift] : {std::pair(1e-150, 0.), {1e150, 0.}, {1., 1e6}, {1e-3, -7.}})
    expect_answer(transformed(GetParam().make(), scale, shift));
}

// A cavity like a ring: what goes around the tube bounds outside the solid, in the cavity.
TEST(Cavity, HasItsTunnelAroundTheTube) {
  const Pairs pairs = find_loops(mesh_of(ball_with_ring_cavity()));
  EXPECT_LT(pairs[0].tunnel().length(), 0.8 * pairs[0].handle().length());
}

// ---- knotted tubes with longitudes of all framings

constexpr std::size_t along = 120, around = 8;

// A tube around the trefoil, by the rows and columns of a grid.
Soup grid_tube() {
  const auto curve = [](double t) {
    return Vector(std::sin(t) + 2. * std::sin(2. * t), std::cos(t) - 2. * std::cos(2. * t),
                  -std::sin(3. * t));
  };
  Soup soup;
  for(std::size_t i = 0; i < along; ++i) {
    const double t = 2. * CGAL_PI * i / along;
    const Vector p = curve(t), tangent = curve(t + 1e-4) - curve(t - 1e-4);
    Vector u = CGAL::cross_product(tangent, Vector(0, 0, 1));
    u = u / generators::length(u);
    Vector v = CGAL::cross_product(u, tangent);
    v = v / generators::length(v);
    for(std::size_t j = 0; j < around; ++j) {
      const double s = 2. * CGAL_PI * j / around;
      const Vector q = p + 0.3 * (std::cos(s) * u + std::sin(s) * v);
      soup.points.push_back({q.x(), q.y(), q.z()});
    }
  }
  const auto at = [](std::size_t i, std::size_t j) {
    return static_cast<std::uint32_t>(i % along * around + j % around);
  };
  for(std::size_t i = 0; i < along; ++i)
    for(std::size_t j = 0; j < around; ++j) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return soup;
}

// Along the tube, and `twist` times around it.
Walk longitude(const Mesh& mesh, int twist) {
  const auto vertex = [](std::size_t i, std::size_t j) {
    return Mesh::Vertex_index(static_cast<Mesh::size_type>(i % along * around + j % around));
  };
  Walk walk;
  Mesh::Vertex_index here = vertex(0, 0);
  const auto go = [&](std::size_t i, std::size_t j) {
    const Mesh::Vertex_index next = vertex(i, j);
    walk.push_back(mesh.halfedge(here, next));
    here = next;
  };
  for(std::size_t i = 0; i < along; ++i) {
    go(i + 1, 0);
    if(i % (along / 8) == 0 && int(i / (along / 8)) < std::abs(twist))
      for(std::size_t k = 1; k <= around; ++k)
        go(i + 1, twist > 0 ? k : around - k);
  }
  return walk;
}

Walk meridian(const Mesh& mesh) {
  Walk walk;
  for(std::uint32_t j = 0; j < around; ++j)
    walk.push_back(mesh.halfedge(Mesh::Vertex_index(j),
                                 Mesh::Vertex_index((j + 1) % static_cast<std::uint32_t>(around))));
  return walk;
}

TEST(Trefoil, HasOneLongitudeThatBoundsOutside) {
  const Mesh mesh = mesh_of(grid_tube());
  std::vector<std::int64_t> framings;
  for(int twist = -6; twist <= 6; ++twist) {
    const Certificate c = certify_handle_tunnel_loops(
        mesh, pairs_of(std::vector<Walk>{meridian(mesh), longitude(mesh, twist)}));
    ASSERT_TRUE(bool(c)) << c.failure;
    const Rows rows = rows_of(c);
    EXPECT_EQ(rows[0], (std::vector<std::int64_t>{0, 0}));
    EXPECT_EQ(std::abs(rows[1][0]), 1);
    framings.push_back(rows[1][1]);
    EXPECT_TRUE(c.linking[0].bounds_inside());
    EXPECT_EQ(c.linking[1].bounds_outside(), rows[1][1] == 0);
    EXPECT_FALSE(c.linking[1].bounds_inside());
  }
  // Each twist adds one to the number of times that the longitude is linked with its copy.
  const std::int64_t step = framings[1] - framings[0];
  EXPECT_EQ(std::abs(step), 1);
  for(std::size_t i = 1; i < framings.size(); ++i)
    EXPECT_EQ(framings[i] - framings[i - 1], step);
  // In this projection, where the frames stay upright, the trefoil has writhe 3.
  EXPECT_EQ(std::abs(framings[6]), 3);
  EXPECT_EQ(std::count(framings.begin(), framings.end(), 0), 1);
}

// ---- against Gauss' integral

class Linking : public testing::TestWithParam<Recipe>
{};

INSTANTIATE_TEST_SUITE_P(Surfaces,
                         Linking,
                         testing::Values(Recipe{"torus", {800, 1, 0}},
                                         Recipe{"knot", {2000, 1, 0}},
                                         Recipe{"multi-torus", {2000, 3, 0}},
                                         Recipe{"lattice", {3000, 5, 1}},
                                         Recipe{"gyroid", {4000, 6, 0}},
                                         Recipe{"sponge", {3000, 4, 0}}),
                         [](const auto& test) {
                           std::string name = test.param.kind;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(Linking, IsGaussIntegral) {
  const Mesh mesh = mesh_of(GetParam());
  const Pairs pairs = find_loops(mesh);
  const Rows rows = rows_of(certify_handle_tunnel_loops(mesh, pairs));
  std::vector<const Loop*> loops;
  for(const auto& pair : pairs)
    loops.insert(loops.end(), {&pair.handle(), &pair.tunnel()});
  constexpr double offset = 1e-3;
  for(std::size_t j = 0; j < loops.size(); ++j) {
    const Polygon pushed = moved(mesh, *loops[j], offset);
    for(std::size_t i = 0; i < loops.size(); ++i)
      EXPECT_NEAR(linking_number(moved(mesh, *loops[i], 0.), pushed),
                  static_cast<double>(rows[i][j]), 0.1)
          << i << ' ' << j;
  }
}

// Seen in a mirror, all numbers change their signs.
TEST_P(Linking, IsReversedByAMirror) {
  const Soup soup = soup_of(GetParam());
  const Mesh mesh = mesh_of(soup);
  const Pairs pairs = find_loops(mesh);
  Rows rows = rows_of(certify_handle_tunnel_loops(mesh, pairs));
  Mesh mirrored = mesh;
  for(const auto v : mirrored.vertices()) {
    const auto& p = mirrored.point(v);
    mirrored.point(v) = Mesh::Point(p.x(), -p.y(), p.z());
  }
  for(auto& row : rows)
    for(auto& value : row)
      value = -value;
  EXPECT_EQ(rows_of(certify_handle_tunnel_loops(mirrored, pairs)), rows);
}

// Linear maps that do not mirror leave all numbers as they are, however long or flat the surface
// becomes, and along whatever axis.
TEST_P(Linking, IsKeptByStretching) {
  const Mesh mesh = mesh_of(GetParam());
  const Pairs pairs = find_loops(mesh);
  const Rows rows = rows_of(certify_handle_tunnel_loops(mesh, pairs));
  for(const double factor : {1e5, 1e-5})
    for(int axis = 0; axis < 3; ++axis) {
      Mesh stretched = mesh;
      for(const auto v : stretched.vertices()) {
        std::array<double, 3> p = {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
        p[axis] *= factor;
        stretched.point(v) = Mesh::Point(p[0], p[1], p[2]);
      }
      EXPECT_EQ(rows_of(certify_handle_tunnel_loops(stretched, pairs)), rows)
          << "axis " << axis << " by " << factor;
    }
}

// Any loops will do, not just those that are found; and how they run does not matter, only their
// classes.
TEST_P(Linking, IsBilinear) {
  const Mesh mesh = mesh_of(GetParam());
  const std::vector<Walk> walks = walks_beside(mesh, find_loops(mesh));
  const Rows rows = rows_of(certify_handle_tunnel_loops(mesh, pairs_of(walks)));
  generators::Random random(3);
  for(int round = 0; round < 5; ++round) {
    const std::size_t a = random.below(walks.size()), b = random.below(walks.size());
    if(a == b)
      continue;
    std::vector<Walk> changed = walks;
    changed[a] = sum(mesh, walks[a], walks[b]);
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(random.below(mesh.num_vertices())));
    changed[b] = sum(mesh, reversed(mesh, walks[b]), ring_around(mesh, v));
    const Rows found = rows_of(certify_handle_tunnel_loops(mesh, pairs_of(changed)));
    for(std::size_t i = 0; i < walks.size(); ++i)
      for(std::size_t j = 0; j < walks.size(); ++j) {
        const auto old = [&](std::size_t k) { return rows[k][j] + (j == a ? rows[k][b] : 0); };
        const std::int64_t expected = (i == a   ? old(a) + old(b)
                                       : i == b ? -old(b)
                                                : old(i)) *
                                      (j == b ? -1 : 1);
        ASSERT_EQ(found[i][j], expected) << i << ' ' << j;
      }
  }
}

// What the solver keeps of its loops, which it may have exchanged since they were linked, is what
// is found of them anew.
TEST_P(Linking, IsKeptWithTheLoops) {
  for(unsigned seed = 0; seed < 4; ++seed) {
    Recipe recipe = GetParam();
    recipe.request.seed += seed;
    const Mesh mesh = mesh_of(recipe);
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
    Pairs pairs;
    solver.find_loops(std::back_inserter(pairs));
    const Certificate anew = certify_handle_tunnel_loops(mesh, pairs);
    const Certificate& kept = solver.certificate();
    ASSERT_EQ(kept.linking.size(), anew.linking.size());
    for(std::size_t i = 0; i < kept.linking.size(); ++i) {
      EXPECT_EQ(kept.linking[i].row, anew.linking[i].row) << "loop " << i;
      EXPECT_EQ(kept.linking[i].column, anew.linking[i].column) << "loop " << i;
      EXPECT_EQ(kept.linking[i].bounds_inside(), anew.linking[i].bounds_inside());
      EXPECT_EQ(kept.linking[i].bounds_outside(), anew.linking[i].bounds_outside());
    }
  }
}

// The same numbers for any number of threads.
TEST_P(Linking, DoesNotDependOnThreads) {
  const Mesh mesh = mesh_of(GetParam());
  const Pairs pairs = find_loops(mesh);
  EXPECT_EQ(rows_of(certify_handle_tunnel_loops<CGAL::Parallel_if_available_tag>(mesh, pairs)),
            rows_of(certify_handle_tunnel_loops(mesh, pairs)));
}

// ---- surfaces that are no boundaries of solids

// A vertex is added on an edge of each face beside a loop: faces without area, which do not matter.
TEST_P(Linking, IsNotDisturbedByFacesWithoutArea) {
  Soup soup = soup_of(GetParam());
  // So that the middle of an edge is a double.
  for(auto& point : soup.points)
    for(double& x : point)
      x = std::round(x * 0x1p20) * 0x1p-20;
  Mesh mesh = mesh_of(soup);
  generators::Random random(4);
  const std::size_t number_of_faces = mesh.num_faces();
  for(int i = 0; i < 50; ++i) {
    const Mesh::Face_index f(static_cast<Mesh::size_type>(random.below(number_of_faces)));
    const auto h = mesh.halfedge(f);
    const auto p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h));
    // At a corner, or at a place of an edge that has a double as coordinates.
    mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) =
        i % 2 == 0 ? p : CGAL::midpoint(p, q);
  }
  const Pairs pairs = find_loops(mesh);
  const Certificate c = certify_handle_tunnel_loops(mesh, pairs);
  EXPECT_TRUE(bool(c)) << c.failure;
  for(const Loop_linking& l : c.linking)
    EXPECT_EQ(l.problem, "");
}

TEST(Surface, WithoutVolumeHasNoInside) {
  Mesh mesh = mesh_of({"torus", {300, 1, 0}});
  const Pairs pairs = find_loops(mesh);
  for(const auto v : mesh.vertices())
    mesh.point(v) = Mesh::Point(mesh.point(v).x(), mesh.point(v).y(), 0.);
  const Certificate c = certify_handle_tunnel_loops(mesh, pairs);
  EXPECT_TRUE(bool(c)) << c.failure;
  for(const Loop_linking& l : c.linking)
    EXPECT_EQ(l.problem, "a component encloses no volume");
  EXPECT_EQ(c.handles_bound_inside, 0u);
}

// Quickly, too: no pair of lines is looked at more often than the surface is large.
TEST(Surface, ThatIsAPointHasLoops) {
  Mesh mesh = mesh_of({"multi-torus", {20000, 2, 0}});
  for(const auto v : mesh.vertices())
    mesh.point(v) = Mesh::Point(1., 2., 3.);
  const Pairs pairs = find_loops(mesh);
  EXPECT_EQ(pairs.size(), 2u);
  for(const Loop_linking& l : certify_handle_tunnel_loops(mesh, pairs).linking)
    EXPECT_NE(l.problem, "");
}

// Two copies of a ring at one place.
TEST(Surface, ThatIsThereTwiceTouchesItself) {
  Soup soup = ring();
  const std::uint32_t n = static_cast<std::uint32_t>(soup.points.size());
  const Soup copy = soup;
  soup.points.insert(soup.points.end(), copy.points.begin(), copy.points.end());
  for(const auto& t : copy.triangles)
    soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  const Mesh mesh = mesh_of(soup);
  const Pairs pairs = find_loops(mesh);
  const Certificate c = certify_handle_tunnel_loops(mesh, pairs);
  EXPECT_TRUE(bool(c)) << c.failure;
  EXPECT_EQ(pairs.size(), 2u);
  for(const Loop_linking& l : c.linking)
    EXPECT_NE(l.problem, "");
}

// ---- many loops, of which those that cross others are not all counted with each other

struct Counted
{
  std::map<std::pair<std::size_t, std::size_t>, std::int64_t> numbers; // not zero
  std::set<std::size_t> problems;
};

// Loops of a closed surface with one component, by their numbers.
Counted count(const Mesh& mesh, const Pairs& pairs, const std::vector<std::size_t>& loops) {
  namespace internal = CGAL::Handle_tunnel_loops::internal;
  const auto point = get(CGAL::vertex_point, mesh);
  const auto number = get(boost::vertex_index, mesh);
  internal::Loop_linker<Mesh, Loop, std::decay_t<decltype(point)>, std::decay_t<decltype(number)>>
      linker(mesh, point, number);
  std::vector<const Loop*> pointers;
  for(std::size_t i : loops)
    pointers.push_back(i % 2 == 0 ? &pairs[i / 2].handle() : &pairs[i / 2].tunnel());
  linker.set_loops(
      internal::Execution(), pointers, [](const auto&) { return std::size_t(0); }, 1);
  linker.link(internal::Execution());
  const auto relations = linker.take_relations();
  Counted counted;
  for(const auto& e : relations.linking)
    counted.numbers[{loops[e.row], loops[e.column]}] = e.value;
  for(const auto& problem : relations.problems)
    counted.problems.insert(loops[problem.first]);
  return counted;
}

// Numbers and problems from all pairs of groups, each so small that all in it are counted at once.
// Numbers of two loops with problems are not in `count()`.
Counted count_in_groups(const Mesh& mesh, const Pairs& pairs, std::size_t group) {
  Counted all;
  const std::size_t n = 2 * pairs.size();
  for(std::size_t a = 0; a < n; a += group)
    for(std::size_t b = a; b < n; b += group) {
      std::vector<std::size_t> loops;
      for(std::size_t begin : std::set<std::size_t>{a, b})
        for(std::size_t i = begin; i < (std::min)(begin + group, n); ++i)
          loops.push_back(i);
      const Counted part = count(mesh, pairs, loops);
      all.numbers.insert(part.numbers.begin(), part.numbers.end());
      all.problems.insert(part.problems.begin(), part.problems.end());
    }
  for(auto it = all.numbers.begin(); it != all.numbers.end();)
    it = all.problems.count(it->first.first) != 0 && all.problems.count(it->first.second) != 0
             ? all.numbers.erase(it)
             : std::next(it);
  return all;
}

// Vertices at a place below `part` of the width are put anywhere.
Mesh scattered(Mesh mesh, double part) {
  const auto [low, high] =
      std::minmax_element(mesh.points().begin(), mesh.points().end(),
                          [](const auto& p, const auto& q) { return p.x() < q.x(); });
  const double begin = low->x(), width = high->x() - begin;
  generators::Random random(5);
  for(const auto v : mesh.vertices())
    if(mesh.point(v).x() < begin + part * width) {
      const auto x = [&] { return random.uniform(0., width); };
      mesh.point(v) = Mesh::Point(begin - x(), x(), x());
    }
  return mesh;
}

TEST(Surface, ThatCrossesItselfIsToldByAFewLoops) {
  const Mesh mesh = mesh_of({"multi-torus", {16000, 70, 0}});
  const Pairs pairs = find_loops(mesh);
  std::vector<std::size_t> loops(2 * pairs.size());
  std::iota(loops.begin(), loops.end(), 0);
  for(const double part : {0., 0.1, 0.4, 1.}) {
    const Mesh changed = scattered(mesh, part);
    const Counted at_once = count(changed, pairs, loops);
    const Counted expected = count_in_groups(changed, pairs, 14);
    EXPECT_EQ(at_once.problems, expected.problems) << part;
    EXPECT_EQ(at_once.numbers, expected.numbers) << part;
    EXPECT_EQ(at_once.problems.empty(), part == 0.);
    EXPECT_EQ(at_once.numbers.empty(), part == 1.);
  }
}

// Random coordinates: whatever comes out, it comes out.
TEST(Surface, MayCrossItselfEverywhere) {
  generators::Random random(9);
  for(int round = 0; round < 10; ++round) {
    Mesh mesh = mesh_of({"random", {200, 3, static_cast<unsigned>(round)}});
    for(const auto v : mesh.vertices()) {
      const auto x = [&] { return static_cast<double>(random.below(4)); };
      mesh.point(v) = Mesh::Point(x(), x(), x());
    }
    const Pairs pairs = find_loops(mesh);
    const Certificate c = certify_handle_tunnel_loops(mesh, pairs);
    EXPECT_TRUE(bool(c)) << c.failure;
    EXPECT_EQ(c.linking.size(), 6u);
  }
}

} // namespace test_linking
