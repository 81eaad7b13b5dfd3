#include "Bored_parts.h"
#include "Meshes_of_soups.h"
#include "Number_of_cases.h"

#include <CGAL/Handle_tunnel_loops/internal/surgery/Fitted_circle.h>
#include <CGAL/Handle_tunnel_loops/round_bores.h>
#include <CGAL/handle_tunnel_loops.h>
#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace test_round_bores {

namespace htl = CGAL::Handle_tunnel_loops;
using Bore = htl::Round_bore<Mesh::Point>;

// In ascending order of their diameters.
std::vector<Bore> bores_of(const Mesh& mesh) {
  std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
  std::vector<std::optional<Bore>> all;
  CGAL::round_bores(mesh, pairs, std::back_inserter(all));
  EXPECT_EQ(all.size(), pairs.size());
  std::vector<Bore> bores;
  for(const std::optional<Bore>& bore : all)
    if(bore)
      bores.push_back(*bore);
  std::sort(bores.begin(), bores.end(),
            [](const Bore& a, const Bore& b) { return a.diameter < b.diameter; });
  return bores;
}

std::vector<double> diameters_of(const std::vector<Bore>& bores) {
  std::vector<double> diameters;
  for(const Bore& bore : bores)
    diameters.push_back(bore.diameter);
  return diameters;
}

class Bores_of_parts : public testing::TestWithParam<unsigned>
{};

TEST_P(Bores_of_parts, HaveTheirDiameters) {
  const Bored_part part = Bored_part_maker(GetParam())();
  SCOPED_TRACE(part.kind);
  for(const char* other : {"meet", "oblique", "keyways"})
    if(part.kind.find(other) != std::string::npos)
      return; // they are narrower where they meet, not as wide as they were made, or not round
  std::vector<double> made = part.diameters;
  std::sort(made.begin(), made.end());
  const std::vector<Bore> bores = bores_of(part.mesh);
  ASSERT_EQ(bores.size(), made.size());
  for(std::size_t i = 0; i < bores.size(); ++i) {
    const Bore& bore = bores[i];
    EXPECT_NEAR(bore.diameter, made[i], 1e-6 * made[i]);
    EXPECT_NEAR(bore.axis.squared_length(), 1., 1e-12);
    if(part.kind.find("askew") == std::string::npos) {
      EXPECT_NEAR((std::max)({bore.axis.x(), bore.axis.y(), bore.axis.z()}), 1., 1e-9);
    }
    const auto points = part.mesh.points();
    EXPECT_GE(std::count_if(points.begin(), points.end(),
                            [&](const Mesh::Point& p) {
                              const double distance = std::sqrt(
                                  CGAL::cross_product(p - bore.center, bore.axis).squared_length());
                              return std::abs(2. * distance - made[i]) < 1e-6 * made[i];
                            }),
              12);
  }
}

double extent_along(const Mesh& mesh, const decltype(Bore::axis)& axis) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for(const Mesh::Point& p : mesh.points()) {
    const double height = axis * (p - CGAL::ORIGIN);
    least = (std::min)(least, height);
    most = (std::max)(most, height);
  }
  return most - least;
}

// Also where other bores cut them into parts, which are of one drilling, then.
TEST_P(Bores_of_parts, ReachFromEndToEnd) {
  const Bored_part part = Bored_part_maker(GetParam())();
  SCOPED_TRACE(part.kind);
  for(const char* other : {"counterbores", "oblique", "keyways"})
    if(part.kind.find(other) != std::string::npos)
      return; // they are as long as their narrowest parts, or end askew, or are not round
  // Where hardly an edge is between the walls of two, these are not told apart, and the axis is off
  // by a little.
  const bool is_cut = part.kind.find("meet") != std::string::npos;
  const double tolerance = is_cut ? 1e-3 : 1e-6;
  for(const Bore& bore : bores_of(part.mesh)) {
    const double depth = extent_along(part.mesh, bore.axis);
    EXPECT_NEAR(bore.length, depth, tolerance * depth);
    EXPECT_LE(bore.deviation, 20. * tolerance * bore.diameter);
  }
}

INSTANTIATE_TEST_SUITE_P(Generated,
                         Bores_of_parts,
                         testing::Range(0u, are_few_cases_tried() ? 60u : 300u));

using Profile = std::vector<std::array<double, 2>>; // radius and height, anticlockwise

// What a profile sweeps around an axis in as many steps; rows of quadrangles, divided.
Mesh turned_part(const Profile& profile, std::size_t steps, double scale = 1.) {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for(std::size_t i = 0; i < steps; ++i)
    for(const auto& [radius, height] : profile) {
      const double angle = 2. * CGAL_PI * static_cast<double>(i) / static_cast<double>(steps);
      v.push_back(mesh.add_vertex(
          {scale * radius * std::cos(angle), scale * radius * std::sin(angle), scale * height}));
    }
  const std::size_t n = profile.size();
  for(std::size_t i = 0; i < steps; ++i)
    for(std::size_t k = 0; k < n; ++k) {
      const auto at = [&](std::size_t step, std::size_t place) {
        return v[(i + step) % steps * n + (k + place) % n];
      };
      mesh.add_face(at(0, 0), at(1, 0), at(1, 1));
      mesh.add_face(at(0, 0), at(1, 1), at(0, 1));
    }
  return mesh;
}

// However few sides they have; where a cone begins, be it steep or flat, the drill ends.
TEST(Round_bores, MayBeCountersunk) {
  for(const double height : {0.2, 0.5, 0.7}) {
    const Profile washer = {{1., 0.}, {3., 0.}, {3., 1.}, {1.5, 1.}, {1., height}};
    for(const std::size_t sides : {6, 7, 16, 64}) {
      SCOPED_TRACE(testing::Message() << height << ' ' << sides);
      for(const double scale : {1., 1e-100, 1e90}) {
        const std::vector<Bore> bores = bores_of(turned_part(washer, sides, scale));
        ASSERT_EQ(bores.size(), 1u);
        EXPECT_NEAR(bores[0].diameter / scale, 2., 1e-9);
        EXPECT_NEAR(bores[0].axis.z(), 1., 1e-9);
        EXPECT_NEAR(bores[0].center.z() / scale, height / 2., 1e-9);
      }
    }
    EXPECT_TRUE(bores_of(turned_part(washer, 5)).empty());
  }
}

// The narrowest of several.
TEST(Round_bores, MayHaveSteps) {
  const Profile stepped = {{1.2, 0.},  {3., 0.},   {3., 2.},   {1.4, 2.},
                           {1.4, 1.5}, {1.1, 1.2}, {1.1, 0.8}, {1.2, 0.7}};
  const std::vector<double> diameters = diameters_of(bores_of(turned_part(stepped, 24)));
  ASSERT_EQ(diameters.size(), 1u);
  EXPECT_NEAR(diameters[0], 2.2, 1e-9);
}

// Curved along its axis, with a belt of faces at the throat that lies along it.
// What least squares divide by is rounding there, or zero.
TEST(Fitted_circle, GoesThroughNoLine) {
  using Circle = htl::internal::Fitted_circle;
  EXPECT_FALSE(Circle::around(std::vector<Circle::Point>(10, {1., 2.})));
  std::mt19937 random(1);
  const auto draw = [&random] { return double(random()) / 4294967296. - 0.5; };
  for(int line = 0; line < 20000; ++line) {
    const double x = draw(), y = draw(), u = line % 5 == 0 ? 0. : draw(), v = draw();
    std::vector<Circle::Point> points;
    for(int i = 0; i < 6 + line % 9; ++i) {
      const double t = line % 2 == 0 ? draw() : i % 3;
      points.emplace_back(x + t * u, y + t * v);
    }
    EXPECT_FALSE(Circle::around(points)) << line;
  }
}

TEST(Round_bores, AreNoHourglasses) {
  Profile hourglass = {{4., 1.}, {4., -1.}};
  std::reverse(hourglass.begin(), hourglass.end());
  constexpr int rows = 9;
  for(int i = 0; i <= rows; ++i) {
    const double z = 1. - 2. * i / rows;
    hourglass.push_back({1. + 0.5 * z * z, z});
  }
  EXPECT_TRUE(bores_of(turned_part(hourglass, 24)).empty());
}

} // namespace test_round_bores
