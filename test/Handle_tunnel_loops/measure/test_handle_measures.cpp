// How thick handles are and how wide their holes, by definition: as many balls as there are handles
// on either side, which fit all along their curves; and these are linked with the loops in as many
// ways.

#include "Gauss_linking.h"
#include "Generated_soups.h"
#include "Meshes_of_soups.h"
#include "Random_rotations.h"
#include "Solids.h"

#include "generators/Random.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/handle_measures.h>
#include <CGAL/handle_tunnel_loops.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_handle_measures {

using Measures = std::vector<CGAL::Handle_tunnel_loops::Handle_measures<Mesh::Point>>;
using Ball = CGAL::Handle_tunnel_loops::Threaded_ball<Mesh::Point>;

Pairs pairs_of(const Mesh& mesh) {
  Pairs pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
  return pairs;
}

template <typename Tag = CGAL::Sequential_tag>
Measures measures_of(const Mesh& mesh, const Pairs& pairs) {
  Measures measures;
  CGAL::handle_measures<Tag>(mesh, pairs, std::back_inserter(measures));
  return measures;
}

Measures measures_of(const Mesh& mesh) { return measures_of(mesh, pairs_of(mesh)); }

/// the balls on one side, the narrowest first.
std::vector<Ball> balls(const Measures& measures, bool inside) {
  std::vector<Ball> found;
  for(const auto& m : measures)
    if(const auto& ball = inside ? m.thickness : m.clear_width)
      found.push_back(*ball);
  std::sort(found.begin(), found.end(),
            [](const Ball& a, const Ball& b) { return a.diameter < b.diameter; });
  return found;
}

Polygon polygon_of(const std::vector<Mesh::Point>& points) {
  Polygon polygon;
  for(const Mesh::Point& p : points)
    polygon.push_back({p.x(), p.y(), p.z()});
  return polygon;
}

/// How far the surface is from a closed curve, looked at in small steps.
class Surface_distance
{
public:
  explicit Surface_distance(const Mesh& mesh)
      : tree_(faces(mesh).begin(), faces(mesh).end(), mesh) {}

  double operator()(const std::vector<Mesh::Point>& curve, double step) const {
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < curve.size(); ++i) {
      const Mesh::Point &a = curve[i], &b = curve[(i + 1) % curve.size()];
      const int n = 1 + static_cast<int>(std::sqrt(CGAL::squared_distance(a, b)) / step);
      for(int k = 0; k < n; ++k)
        least = (std::min)(least, tree_.squared_distance(a + (double(k) / n) * (b - a)));
    }
    return std::sqrt(least);
  }

private:
  using Kernel = CGAL::Kernel_traits<Mesh::Point>::Kernel;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

/// the rank of the matrix of linking numbers of curves with all loops.
std::size_t rank_of_linking(const std::vector<Ball>& curves, const Pairs& pairs) {
  std::vector<std::vector<double>> rows;
  for(const Ball& ball : curves) {
    rows.emplace_back();
    for(const auto& pair : pairs)
      for(const auto* loop : {&pair.handle(), &pair.tunnel()})
        rows.back().push_back(
            std::round(linking_number(polygon_of(ball.curve), polygon_of(loop->points()))));
  }
  std::size_t rank = 0;
  for(std::size_t column = 0; !rows.empty() && column < rows.front().size(); ++column) {
    const auto pivot =
        std::max_element(rows.begin() + rank, rows.end(), [&](const auto& a, const auto& b) {
          return std::abs(a[column]) < std::abs(b[column]);
        });
    if(pivot == rows.end() || std::abs((*pivot)[column]) < 1e-9)
      continue;
    std::iter_swap(rows.begin() + rank, pivot);
    for(std::size_t r = rank + 1; r < rows.size(); ++r) {
      const double factor = rows[r][column] / rows[rank][column];
      for(std::size_t c = column; c < rows[r].size(); ++c)
        rows[r][c] -= factor * rows[rank][c];
    }
    ++rank;
  }
  return rank;
}

void expect_definitions(const Mesh& mesh, const Pairs& pairs, const Measures& measures) {
  ASSERT_EQ(measures.size(), pairs.size());
  const Surface_distance distance(mesh);
  for(const bool inside : {true, false}) {
    const std::vector<Ball> found = balls(measures, inside);
    EXPECT_EQ(found.size(), pairs.size());
    for(const Ball& ball : found) {
      EXPECT_LE(ball.error, 0.0101 * ball.diameter);
      EXPECT_EQ(ball.throat, ball.curve.front());
      const double least = 0.5 * (ball.diameter - ball.error);
      EXPECT_GE(distance(ball.curve, 0.1 * least), (1. - 1e-9) * least);
    }
    EXPECT_EQ(rank_of_linking(found, pairs), found.size());
  }
}

// ---- by definition

class Measured_surfaces : public testing::TestWithParam<Recipe>
{};

TEST_P(Measured_surfaces, HaveAsManyBallsAsHandles) {
  const Mesh mesh = mesh_of(GetParam());
  const Pairs pairs = pairs_of(mesh);
  expect_definitions(mesh, pairs, measures_of(mesh, pairs));
}

INSTANTIATE_TEST_SUITE_P(Generated,
                         Measured_surfaces,
                         testing::ValuesIn(std::vector<Recipe>{{"torus", {600, 1, 0}},
                                                               {"knot", {1500, 1, 0}},
                                                               {"multi-torus", {1500, 3, 0}},
                                                               {"sponge", {400, 3, 0}},
                                                               {"plates", {300, 3, 1}},
                                                               {"chain", {600, 3, 0}},
                                                               {"lattice", {1500, 3, 0}},
                                                               {"foam", {2600, 3, 1}}}));

TEST(Handle_measures, OfComponentsThatAreLinkedAndNested) {
  for(const Soup& soup : {hollow_ring(), linked_rings(), ball_with_ring_cavity(),
                          ring_within_shells(), ball_with_knotted_tunnel()})
  {
    const Mesh mesh = mesh_of(soup);
    const Pairs pairs = pairs_of(mesh);
    expect_definitions(mesh, pairs, measures_of(mesh, pairs));
  }
}

// ---- known numbers

// A frame of square profile around a square hole.
Soup frame(double hole, double width, double height) {
  Soup soup;
  const double outer = hole + 2. * width;
  for(const double z : {0., height})
    for(const double half : {0.5 * hole, 0.5 * outer})
      for(const auto& [x, y] :
          std::array<std::array<double, 2>, 4>{{{-1., -1.}, {1., -1.}, {1., 1.}, {-1., 1.}}})
        soup.points.push_back({half * x, half * y, z});
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  };
  for(std::uint32_t i = 0; i < 4; ++i) { // the inner and the outer square, below and above
    const std::uint32_t j = (i + 1) % 4;
    add(i, j, j + 4, i + 4);
    add(i + 8, i + 12, j + 12, j + 8);
    add(i + 8, j + 8, j, i);
    add(i + 4, j + 4, j + 12, i + 12);
  }
  return soup;
}

TEST(Handle_measures, AreThoseOfASquareFrame) {
  for(const double height : {0.003, 0.05, 0.5, 2., 30.}) { // however thin
    const Measures measures = measures_of(mesh_of(frame(10., 4., height)));
    ASSERT_EQ(measures.size(), 1u);
    ASSERT_TRUE(measures[0].thickness && measures[0].clear_width);
    EXPECT_NEAR(measures[0].clear_width->diameter, 10., measures[0].clear_width->error + 1e-9);
    const double thickness = (std::min)(4., height);
    EXPECT_NEAR(measures[0].thickness->diameter, thickness, measures[0].thickness->error + 1e-9);
    EXPECT_LE(measures[0].thickness->error, 0.01 * thickness);
  }
}

TEST(Handle_measures, AreOfTheSizeOfTheMesh) {
  const Soup soup = frame(10., 4., 3.);
  const Measures unit = measures_of(mesh_of(soup));
  for(const double scale : {1e-300, 1e-150, 1e-20, 1e20, 1e150, 1e300}) {
    const Measures measures = measures_of(mesh_of(transformed(soup, scale, 0.)));
    ASSERT_EQ(measures.size(), 1u);
    ASSERT_TRUE(measures[0].thickness && measures[0].clear_width);
    EXPECT_NEAR(measures[0].thickness->diameter / scale, unit[0].thickness->diameter, 0.05);
    EXPECT_NEAR(measures[0].clear_width->diameter / scale, unit[0].clear_width->diameter, 0.1);
  }
}

// ---- of the shape alone

TEST(Handle_measures, AreTheSameTurnedAndRenumberedAndInAnyNumberOfThreads) {
  for(const Recipe& recipe :
      std::vector<Recipe>{{"multi-torus", {2000, 4, 0}}, {"plates", {300, 3, 1}}})
  {
    Soup soup = soup_of(recipe);
    const Mesh mesh = mesh_of(soup);
    generators::Random random(3);
    random_surfaces::turn(soup, random);
    const Mesh turned = mesh_of(generators::permute_vertices(soup, 5));
    const Pairs pairs = pairs_of(mesh);
    const Measures measures = measures_of(mesh, pairs), others = measures_of(turned),
                   in_threads = measures_of<CGAL::Parallel_if_available_tag>(mesh, pairs);
    for(const bool inside : {true, false}) {
      const auto found = balls(measures, inside), other = balls(others, inside),
                 same = balls(in_threads, inside);
      ASSERT_EQ(found.size(), other.size());
      ASSERT_EQ(found.size(), same.size());
      for(std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].diameter, other[i].diameter, 0.01 * found[i].diameter);
        EXPECT_EQ(found[i].diameter, same[i].diameter);
        EXPECT_EQ(found[i].curve, same[i].curve);
      }
    }
  }
}

// ---- what cannot be measured, and what is not to be

TEST(Handle_measures, OfASurfaceThatCrossesItselfSayWhyThereAreNone) {
  const Soup torus = soup_of({"torus", {400, 1, 0}});
  const Mesh mesh =
      mesh_of(generators::joined({torus, generators::translated(torus, {0.05, 0., 0.})}));
  const Measures measures = measures_of(mesh);
  ASSERT_EQ(measures.size(), 2u);
  for(const auto& m : measures) {
    EXPECT_FALSE(m.thickness || m.clear_width);
    EXPECT_NE(m.why.find("crosses itself"), std::string::npos);
  }
}

TEST(Handle_measures, OfASurfaceWithBoundaryAreThoseWithCaps) {
  Soup soup = frame(10., 4., 4.);
  soup.triangles.pop_back(); // a hole in a flat side: its cap is flat
  const Measures measures = measures_of(mesh_of(soup));
  ASSERT_EQ(measures.size(), 1u);
  ASSERT_TRUE(measures[0].thickness && measures[0].clear_width);
  EXPECT_NEAR(measures[0].clear_width->diameter, 10., measures[0].clear_width->error + 1e-9);
  EXPECT_NEAR(measures[0].thickness->diameter, 4., measures[0].thickness->error + 1e-9);
}

TEST(Handle_measures, OfASphereAreNone) {
  EXPECT_TRUE(measures_of(mesh_of(Recipe{"sphere", {100, 0, 0}})).empty());
}

TEST(Handle_measures, AreStoppedByTheCallback) {
  const Mesh mesh = mesh_of(Recipe{"torus", {400, 1, 0}});
  const Pairs pairs = pairs_of(mesh);
  Measures measures;
  EXPECT_THROW(CGAL::handle_measures(mesh, pairs, std::back_inserter(measures),
                                     CGAL::parameters::callback(std::function<bool(double)>(
                                         [](double) { return false; }))),
               CGAL::Handle_tunnel_loops::Interrupted_exception);
  EXPECT_TRUE(measures.empty());
}

} // namespace test_handle_measures
