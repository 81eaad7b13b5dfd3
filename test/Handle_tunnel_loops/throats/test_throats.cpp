#include "Flat_mesh_of_soup.h"
#include "Loop_definitions.h"
#include "Meshes_of_soups.h"
#include "Random_rotations.h"
#include "generators/Field.h"
#include "generators/mesh_of_field.h"

#include <CGAL/Handle_tunnel_loops/internal/reeb/find_necks.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/throats.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_throats {

namespace impl = CGAL::Handle_tunnel_loops::internal;
using Throat = CGAL::Handle_tunnel_loops::Throat<Mesh>;
using Throats = std::vector<Throat>;
using Radius = std::function<double(double)>; // by a number in [0, 1]

// ---- surfaces

// A tube around a circle of radius 2, closed, of a radius that varies along it.
Soup ring(const Radius& radius, std::uint32_t along, std::uint32_t around) {
  Soup soup;
  for(std::uint32_t i = 0; i < along; ++i)
    for(std::uint32_t j = 0; j < around; ++j) {
      const double u = 2. * CGAL_PI * i / along, v = 2. * CGAL_PI * j / around;
      const double r = radius(double(i) / along), out = 2. + r * std::cos(v);
      soup.points.push_back({out * std::cos(u), out * std::sin(u), r * std::sin(v)});
      const auto at = [&](std::uint32_t k, std::uint32_t l) {
        return (k % along) * around + l % around;
      };
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return soup;
}

// A closed surface of revolution.
Soup turned(const Radius& radius, double height, std::uint32_t along, std::uint32_t around) {
  Soup soup;
  for(std::uint32_t i = 1; i < along; ++i)
    for(std::uint32_t j = 0; j < around; ++j) {
      const double s = double(i) / along, v = 2. * CGAL_PI * (j + 0.5 * (i % 2)) / around;
      soup.points.push_back({radius(s) * std::cos(v), radius(s) * std::sin(v), height * s});
    }
  const auto low = static_cast<std::uint32_t>(soup.points.size()), high = low + 1;
  soup.points.push_back({0., 0., 0.});
  soup.points.push_back({0., 0., height});
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return (i - 1) * around + j % around; };
  for(std::uint32_t j = 0; j < around; ++j) {
    soup.triangles.push_back({low, at(1, j + 1), at(1, j)});
    soup.triangles.push_back({high, at(along - 1, j), at(along - 1, j + 1)});
    for(std::uint32_t i = 1; i + 1 < along; ++i) {
      const std::uint32_t shift = i % 2;
      soup.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + shift)});
      soup.triangles.push_back({at(i, j + 1), at(i + 1, j + shift + 1), at(i + 1, j + shift)});
    }
  }
  return soup;
}

double round_end(double s) { return std::sqrt(s * (1. - s)); }

// ---- what a throat is

Throats throats_of(const Mesh& mesh) {
  Throats throats;
  CGAL::throats(mesh, find_loops(mesh), std::back_inserter(throats));
  return throats;
}

// As a loop on the arrays.
impl::Crossing_loop flat_loop(const impl::Flat_mesh& mesh, const Mesh& tm, const Throat& throat) {
  std::vector<impl::Index> place(mesh.number_of_vertices());
  for(impl::Index v = 0; v < place.size(); ++v)
    place[mesh.original[v]] = v;
  std::vector<impl::Index> walk;
  for(const auto& step : throat.loop.steps())
    walk.push_back(
        place[(step.ratio < 0.5 ? source(step.halfedge, tm) : target(step.halfedge, tm)).idx()]);
  impl::remove_spurs(walk);
  return impl::pushed_left(mesh, walk);
}

// Each is a closed curve on the surface, of which none beside it is shorter.
void expect_throats(const Soup& soup, const Mesh& mesh, const Throats& throats) {
  const impl::Flat_mesh flat = flat_mesh_of(soup);
  impl::Loop_tightening tightening(flat);
  for(std::size_t i = 0; i < throats.size(); ++i) {
    const Throat& throat = throats[i];
    EXPECT_EQ(throat.loop.pair_index(), i);
    EXPECT_GT(throat.prominence, 0.);
    EXPECT_NEAR(throat.diameter() * CGAL_PI, throat.loop.length(), 1e-12 * throat.loop.length());
    EXPECT_EQ(throat.is_separating, throat.bounds_inside && throat.bounds_outside);
    expect_loop(mesh, get(CGAL::vertex_point, mesh), throat.loop);
    impl::Crossing_loop beside = flat_loop(flat, mesh, throat);
    tightening.tighten(beside);
    EXPECT_GT(2. * flat.half_scale * length(flat, beside), 0.998 * throat.loop.length());
  }
  for(std::size_t i = 1; i < throats.size(); ++i)
    EXPECT_GE(throats[i - 1].prominence, throats[i].prominence);
}

Throats checked_throats(const Soup& soup) {
  const Mesh mesh = mesh_of(soup);
  Throats throats = throats_of(mesh);
  expect_throats(soup, mesh, throats);
  return throats;
}

std::size_t number_inside(const Throats& throats) {
  return static_cast<std::size_t>(std::count_if(
      throats.begin(), throats.end(), [](const Throat& throat) { return throat.bounds_inside; }));
}

std::vector<double> lengths_of(const Throats& throats) {
  std::vector<double> lengths;
  for(const Throat& throat : throats)
    lengths.push_back(throat.loop.length());
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

// ---- how many there are

TEST(Throats, AreAsManyAsANecklaceHasBeads) {
  for(const int beads : {1, 2, 5, 10}) {
    SCOPED_TRACE(beads);
    const Throats throats = checked_throats(
        ring([&](double s) { return 0.35 - 0.15 * std::cos(2. * CGAL_PI * beads * s + 1.); },
             24 * static_cast<std::uint32_t>(std::max(beads, 4)), 28));
    EXPECT_EQ(number_inside(throats), static_cast<std::size_t>(beads));
    EXPECT_EQ(throats.size(), static_cast<std::size_t>(beads) + 1); // and one around the hole
    for(const Throat& throat : throats) {
      EXPECT_EQ(throat.pair, std::size_t(0));
      EXPECT_FALSE(throat.is_separating);
      if(throat.bounds_inside) {
        EXPECT_NEAR(throat.loop.length(), 2. * CGAL_PI * 0.2, 0.03);
      }
    }
  }
}

TEST(Throats, AreOneWhereAWholeFamilyIsEquallyShort) {
  const Throats throats = checked_throats(ring([](double) { return 0.5; }, 90, 30));
  EXPECT_EQ(throats.size(), 2u);
  EXPECT_EQ(number_inside(throats), 1u);
  for(const Throat& throat : throats)
    EXPECT_TRUE(std::isinf(throat.prominence));
}

TEST(Throats, AreNoneWhereNothingIsNarrower) {
  for(const double height : {1., 2., 6.})
    EXPECT_TRUE(checked_throats(turned(round_end, height, 60, 40)).empty()) << height;
}

// Half-way of them it is as narrow as the formula says.
TEST(Throats, SeparateAndHaveTheDiameterOfTheNeck) {
  for(const double neck : {0.3, 0.6}) {
    const auto radius = [&](double s) {
      return round_end(s) * (1. - (1. - neck) * std::exp(-std::pow((s - 0.5) / 0.1, 2.)));
    };
    const Throats throats = checked_throats(turned(radius, 4., 100, 50));
    ASSERT_EQ(throats.size(), 1u);
    EXPECT_TRUE(throats[0].is_separating);
    EXPECT_FALSE(throats[0].pair);
    EXPECT_NEAR(throats[0].diameter(), 2. * radius(0.5), 0.01);
    // To slip away it has to become as long as the body beyond it is wide.
    double widest = 0.;
    for(int i = 0; i <= 1000; ++i)
      widest = (std::max)(widest, radius(i / 1000.));
    const double expected = 2. * CGAL_PI * (widest - radius(0.5));
    EXPECT_NEAR(throats[0].prominence, expected, 0.03 * throats[0].loop.length());
  }
}

// Of two bodies it is the smaller one that is easier to pass.
TEST(Throats, SlipOffOverTheSmallerBody) {
  const auto radius = [](double s) {
    return s < 0.7 ? std::sqrt((std::max)(0.35 * 0.35 - (s - 0.35) * (s - 0.35), 0.01 * s))
                   : std::sqrt((std::max)(0.15 * 0.15 - (s - 0.85) * (s - 0.85), 0.01 * (1. - s)));
  };
  const Throats throats = checked_throats(turned(radius, 1., 200, 60));
  ASSERT_FALSE(throats.empty());
  const double length = throats[0].loop.length();
  EXPECT_NEAR(throats[0].prominence, 2. * CGAL_PI * 0.15 - length, 0.1 * length);
}

// A tube that is open at both ends, over which nothing slips.
TEST(Throats, DoNotSlipOverBoundaryCurves) {
  Soup soup;
  const std::uint32_t along = 40, around = 30;
  for(std::uint32_t i = 0; i <= along; ++i)
    for(std::uint32_t j = 0; j < around; ++j) {
      const double x = 2. * i / along - 1., r = 0.4 + 0.3 * x * x, v = 2. * CGAL_PI * j / around;
      soup.points.push_back({r * std::cos(v), r * std::sin(v), 2. * x});
      const auto at = [&](std::uint32_t k, std::uint32_t l) { return k * around + l % around; };
      if(i == along)
        continue;
      soup.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  const Mesh mesh = mesh_of(soup);
  Throats throats;
  CGAL::throats(mesh, Pairs(), std::back_inserter(throats));
  ASSERT_EQ(throats.size(), 1u);
  EXPECT_NEAR(throats[0].diameter(), 0.8, 0.01);
  EXPECT_TRUE(std::isinf(throats[0].prominence));
}

// Balls in a row, or in a tree, between them tubes.
class Balls_and_tubes : public generators::Field
{
public:
  using Vec = generators::Vector;

  Balls_and_tubes(std::vector<Vec> balls, std::vector<std::pair<int, int>> tubes)
      : balls_(std::move(balls))
      , tubes_(std::move(tubes)) {}

  generators::Box box() const override {
    generators::Box box = {balls_[0], balls_[0]};
    for(const Vec& p : balls_)
      box = box.with(p);
    return box.grown(0.55);
  }

  double operator()(const Vec& p) const override {
    double least = 1e9;
    for(const Vec& c : balls_)
      least = (std::min)(least, generators::length(p - c) - 0.4);
    for(const auto& [a, b] : tubes_)
      least = (std::min)(least, generators::segment_distance(p, balls_[a], balls_[b]) - 0.15);
    return least;
  }

private:
  std::vector<Vec> balls_;
  std::vector<std::pair<int, int>> tubes_;
};

using Vec = generators::Vector;

Soup tree(std::size_t faces) {
  return generators::mesh_of_field(
      Balls_and_tubes({Vec(0, 0, 0), Vec(1.2, 0.1, 0), Vec(2.3, -0.2, 0.4), Vec(1.1, 1.3, 0.2)},
                      {{0, 1}, {1, 2}, {1, 3}}),
      faces);
}

Soup triangle_of_balls(std::size_t faces) {
  return generators::mesh_of_field(
      Balls_and_tubes({Vec(0, 0, 0), Vec(1.5, 0.1, 0), Vec(0.7, 1.4, 0.2), Vec(-1.3, -0.2, 0.1)},
                      {{0, 1}, {1, 2}, {2, 0}, {0, 3}}),
      faces);
}

TEST(Throats, AreTheNecks) {
  const Soup soup = tree(16000);
  const Throats throats = checked_throats(soup);
  EXPECT_EQ(throats.size(), 3u);
  const impl::Flat_mesh flat = flat_mesh_of(soup);
  std::vector<double> necks;
  for(const impl::Flat_neck& neck : impl::find_flat_necks(impl::Execution(), flat, {1., 0.05}))
    necks.push_back(2. * flat.half_scale * neck.length);
  const std::vector<double> lengths = lengths_of(throats);
  ASSERT_EQ(necks.size(), lengths.size());
  std::sort(necks.begin(), necks.end());
  for(std::size_t i = 0; i < necks.size(); ++i)
    EXPECT_NEAR(lengths[i], necks[i], 0.01 * necks[i]);
}

// Others go around two tubes where these meet a ball.
TEST(Throats, AreOfHandlesAndOfNecksAlike) {
  std::size_t tubes = 0, necks = 0;
  for(const Throat& throat : checked_throats(triangle_of_balls(16000)))
    if(throat.loop.length() < 1.1) {
      ++tubes;
      necks += throat.is_separating ? 1 : 0;
    }
  EXPECT_EQ(tubes, 4u);
  EXPECT_EQ(necks, 1u);
}

// ---- the same, however it lies

// How far they are from slipping away is an estimate, and may differ a little; where a tube is as
// narrow everywhere they may be anywhere along it.
void expect_alike(const Throats& throats, const Throats& others) {
  const std::vector<double> lengths = lengths_of(throats), other_lengths = lengths_of(others);
  ASSERT_EQ(lengths.size(), other_lengths.size());
  for(std::size_t i = 0; i < lengths.size(); ++i)
    EXPECT_NEAR(lengths[i], other_lengths[i], 0.01 * lengths[i]);
  for(std::size_t i = 0; i < throats.size(); ++i)
    if(!std::isinf(throats[i].prominence)) {
      EXPECT_NEAR(throats[i].prominence, others[i].prominence, 0.1 * throats[i].loop.length());
    }
}

TEST(Throats, AreTheSameTurnedAndInAnotherOrder) {
  generators::Random random(7);
  for(const Soup& soup : {tree(9000), triangle_of_balls(9000)}) {
    const Throats throats = checked_throats(soup);
    for(unsigned seed = 1; seed < 4; ++seed) {
      Soup other = generators::permute_vertices(soup, seed);
      random_surfaces::turn(other, random);
      expect_alike(throats, throats_of(mesh_of(other)));
    }
  }
}

Soup scaled(Soup soup, double factor) {
  for(auto& point : soup.points)
    for(double& x : point)
      x *= factor;
  return soup;
}

// On a coarse torus it is chance which of its equally short loops are found, and how far from
// vertices. Scaling by powers of two rounds nothing.
TEST(Throats, DoNotDependOnTheUnit) {
  generators::Random random(3);
  using Size = std::pair<std::uint32_t, std::uint32_t>;
  for(const auto& [along, around] : {Size(10, 5), Size(20, 9), Size(26, 11), Size(27, 11)}) {
    SCOPED_TRACE(testing::Message() << along << " x " << around);
    const Soup soup = ring([](double) { return 0.8; }, along, around);
    const Throats throats = checked_throats(soup);
    EXPECT_EQ(throats.size(), 2u);
    for(const double unit : {1. / 25.4, 25.4, 1e-3, 1e3, 0x1p-40, 0x1p40}) {
      const Throats others = throats_of(mesh_of(scaled(soup, unit)));
      ASSERT_EQ(others.size(), throats.size()) << unit;
      int exponent = 0;
      const double rounding = std::frexp(unit, &exponent) == 0.5 ? 0. : 1e-6;
      for(std::size_t i = 0; i < throats.size(); ++i) {
        const double length = unit * throats[i].loop.length();
        EXPECT_NEAR(others[i].loop.length(), length, rounding * length) << unit;
        EXPECT_TRUE(std::isinf(others[i].prominence)) << unit;
      }
    }
    for(int i = 0; i < 4; ++i) {
      Soup turned = soup;
      random_surfaces::turn(turned, random);
      EXPECT_EQ(throats_of(mesh_of(turned)).size(), 2u);
    }
  }
}

TEST(Throats, AreThoseOfACoarserMesh) {
  const Throats throats = checked_throats(tree(12000)), others = checked_throats(tree(50000));
  const std::vector<double> lengths = lengths_of(throats), other_lengths = lengths_of(others);
  ASSERT_EQ(lengths.size(), other_lengths.size());
  for(std::size_t i = 0; i < lengths.size(); ++i) {
    EXPECT_NEAR(lengths[i], other_lengths[i], 0.02 * lengths[i]);
    EXPECT_NEAR(throats[i].prominence, others[i].prominence, 0.3 * throats[i].loop.length());
  }
}

TEST(Throats, DoNotDependOnTheThreads) {
  const Mesh mesh = mesh_of(triangle_of_balls(9000));
  const Pairs pairs = find_loops(mesh);
  Throats some, others;
  CGAL::throats(mesh, pairs, std::back_inserter(some));
  CGAL::throats<CGAL::Parallel_if_available_tag>(mesh, pairs, std::back_inserter(others));
  ASSERT_EQ(some.size(), others.size());
  for(std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_EQ(some[i].loop.length(), others[i].loop.length());
    EXPECT_EQ(some[i].prominence, others[i].prominence);
  }
}

TEST(Throats, AreOfEachComponent) {
  const Soup one = tree(6000);
  EXPECT_EQ(throats_of(mesh_of(generators::disjoint_union({one, one}))).size(),
            2 * throats_of(mesh_of(one)).size());
}

// ---- through vertices

TEST(Throats, ComeFromLoopsThroughVertices) {
  const Mesh mesh = mesh_of(triangle_of_balls(9000));
  const Pairs pairs = find_loops(mesh);
  for(const std::size_t v : {0, 700, 2500}) {
    const std::vector<Mesh::Vertex_index> through = {Mesh::Vertex_index(v)};
    Throats throats;
    CGAL::throats(mesh, pairs, std::back_inserter(throats),
                  CGAL::parameters::through_vertices(through));
    EXPECT_EQ(std::count_if(throats.begin(), throats.end(),
                            [&](const Throat& throat) { return throat.through == through; }),
              1);
  }
}

TEST(Throats, ComeFromNoLoopThroughAVertexOfABall) {
  const Soup soup = turned(round_end, 1., 40, 40);
  const Mesh mesh = mesh_of(soup);
  Throats throats;
  CGAL::throats(mesh, Pairs(), std::back_inserter(throats),
                CGAL::parameters::through_vertices(
                    std::vector<Mesh::Vertex_index>(1, *mesh.vertices_begin())));
  EXPECT_TRUE(throats.empty());
}

// ---- what is refused

TEST(Throats, NeedAllPairs) {
  const Mesh mesh = mesh_of(Recipe{"torus", {2000, 1, 0}});
  Throats throats;
  EXPECT_THROW(CGAL::throats(mesh, Pairs(), std::back_inserter(throats)), std::invalid_argument);
  EXPECT_THROW(CGAL::throats(mesh, find_loops(mesh), std::back_inserter(throats),
                             CGAL::parameters::least_prominence(0.)),
               std::invalid_argument);
}

} // namespace test_throats
