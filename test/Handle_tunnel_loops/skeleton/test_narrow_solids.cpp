// Curve skeletons where hardly anything has room: by definition, and without many balls.

#include "Generated_soups.h"
#include "Meshes_of_soups.h"
#include "Needles.h"
#include "Random_rotations.h"
#include "Skeleton_definitions.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/curve_skeleton.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace test_narrow_solids {

std::size_t expect_skeleton(const Soup& soup) {
  const Mesh mesh = mesh_of(soup);
  CGAL::Curve_skeleton<Mesh> graph;
  const auto statistics = CGAL::curve_skeleton(mesh, graph);
  EXPECT_TRUE(statistics.certificate) << statistics.certificate.failure;
  const auto skeleton = skeleton_definitions::skeleton_of(graph);
  const auto truth = skeleton_definitions::truth(mesh, skeleton, find_loops(mesh));
  EXPECT_TRUE(truth.is_connected);
  EXPECT_TRUE(truth.is_inside);
  EXPECT_TRUE(truth.is_embedded);
  EXPECT_TRUE(truth.is_basis);
  std::size_t inlets = 0;
  for(const bool is_inlet : skeleton.is_inlet)
    inlets += is_inlet ? 1 : 0;
  EXPECT_EQ(inlets, statistics.number_of_boundaries);
  return statistics.number_of_balls;
}

// Rounded, needles leave no room at some places of a way around a tube along the wall.
TEST(Narrow_solids, HaveAllCyclesThroughFlatLinkedTubesWithNeedles) {
  constexpr unsigned seed = 3;
  Request request;
  request.genus = 8;
  request.faces = 930 * request.genus;
  request.p = 1;
  request.q = 4;
  request.seed = seed;
  Soup soup = soup_of({"torus-link", request});
  generators::Random random(seed);
  const double height = std::pow(10., -random.uniform(1.5, 3.));
  for(auto& p : soup.points)
    p[2] *= height;
  soup = with_needles(soup, random);
  random_surfaces::turn(soup, random);
  expect_skeleton(soup);
}

// A bowl: around its middle is a ridge, nearly as high as its rim, and behind that a trough.
Soup bowl_with_ridge(std::uint32_t sides, double depth_of_ridge) {
  Soup soup;
  constexpr double full_turn = 6.283185307179586;
  for(const auto& [radius, depth] :
      std::array<std::array<double, 2>, 3>{{{1., 0.}, {0.75, 1.}, {0.5, depth_of_ridge}}})
    for(std::uint32_t i = 0; i < sides; ++i) {
      const double angle = full_turn * i / sides;
      soup.points.push_back({radius * std::cos(angle), radius * std::sin(angle), -depth});
    }
  soup.points.push_back({0., 0., -1.});
  for(std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t j = (i + 1) % sides;
    for(const std::uint32_t first : {0u, sides}) {
      soup.triangles.push_back({first + j, first + i, first + sides + j});
      soup.triangles.push_back({first + sides + j, first + i, first + sides + i});
    }
    soup.triangles.push_back({2 * sides + j, 2 * sides + i, 3 * sides});
  }
  return soup;
}

// Its triangles have corners of their own, which are so far off, at most.
Soup cube_of_triangles(double apart, generators::Random& random) {
  Soup soup;
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(const double side : {0., 1.})
      for(const bool is_second : {false, true}) {
        std::vector<std::array<double, 2>> corners = {{0., 0.}, {1., 0.}, {1., 1.}};
        if(is_second)
          corners[1] = {0., 1.};
        if(is_second != (side == 0.))
          std::swap(corners[0], corners[1]);
        const auto first = static_cast<std::uint32_t>(soup.points.size());
        soup.triangles.push_back({first, first + 1, first + 2});
        for(const auto& [u, v] : corners) {
          std::array<double, 3> p;
          p[axis] = side;
          p[(axis + 1) % 3] = u;
          p[(axis + 2) % 3] = v;
          for(double& x : p)
            x += random.uniform(0., apart);
          soup.points.push_back(p);
        }
      }
  return soup;
}

// From the middle of the rim no ball is seen that touches the surface at the rim.
TEST(Narrow_solids, HaveInletsBehindRidges) {
  generators::Random random(1);
  for(const std::uint32_t sides : {6u, 12u}) {
    SCOPED_TRACE(sides);
    Soup soup = bowl_with_ridge(sides, 1e-3);
    random_surfaces::turn(soup, random);
    expect_skeleton(soup);
  }
}

// Blades that are thinner than places on the surface are apart.
TEST(Narrow_solids, DoNotTakeManyBallsInManyBlades) {
  for(const std::size_t faces : {1000u, 2000u}) {
    SCOPED_TRACE(faces);
    EXPECT_LT(expect_skeleton(soup_of({"fan", {faces, 0, 1}})), 10000u);
  }
}

// Each is a solid of its own, between the triangle and its cap, and cuts others.
TEST(Narrow_solids, AreUncertifiedTrianglesOfAnUnweldedCube) {
  for(const double apart : {1e-4, 1e-7, 1e-12}) {
    SCOPED_TRACE(apart);
    generators::Random random(1);
    const Soup cube = cube_of_triangles(apart, random);
    const Mesh mesh = mesh_of(cube);
    CGAL::Curve_skeleton<Mesh> graph;
    const auto statistics = CGAL::curve_skeleton(mesh, graph);
    EXPECT_EQ(statistics.number_of_components, 12u);
    EXPECT_FALSE(statistics.certificate);
    EXPECT_NE(statistics.certificate.failure.find("the cap of the boundary curve"),
              std::string::npos);
    EXPECT_LT(num_vertices(graph), statistics.number_of_balls);
  }
}

TEST(Narrow_solids, CanBeInterruptedWhenLoopsAreFound) {
  const Mesh mesh = mesh_of(soup_of({"torus", {800, 1, 0}}));
  CGAL::Curve_skeleton<Mesh> graph;
  const auto draw_until = [&](int most) {
    int times = 0; // that all loops are found
    CGAL::curve_skeleton(mesh, graph, CGAL::parameters::callback([&](double done) {
                           return done < 1. || ++times <= most;
                         }));
    return times;
  };
  const int all = draw_until(1000);
  EXPECT_GT(all, 3);
  for(int most = 0; most < all; ++most) {
    graph.clear();
    EXPECT_THROW(draw_until(most), CGAL::Handle_tunnel_loops::Interrupted_exception) << most;
    EXPECT_EQ(num_vertices(graph), 0u);
  }
}

} // namespace test_narrow_solids
