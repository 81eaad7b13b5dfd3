// Moved outwards, a circle around a tube grows by 2 pi times the way, one around a hole shrinks;
// and which of two loops grows more is decided exactly, as sums of square roots are.

#include "Changed_loops.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/linking/Offset_classifier.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace test_offset_classifier {

using Vertex_point_map = boost::property_map<Mesh, CGAL::vertex_point_t>::const_type;
using Classifier = CGAL::Handle_tunnel_loops::internal::Offset_classifier<Mesh, Vertex_point_map>;

Classifier classifier_of(const Mesh& mesh) {
  return Classifier(mesh, get(CGAL::vertex_point, mesh));
}

Loop reversed(const Loop& loop) {
  Steps steps = loop.steps();
  std::reverse(steps.begin(), steps.end());
  return loop_of(std::move(steps));
}

// ---- the growth

class Circles : public testing::Test
{
protected:
  void expect_growth(const Soup& soup, int outward) const {
    const Mesh mesh = mesh_of(soup);
    const Pairs pairs = find_loops(mesh);
    const Classifier classifier = classifier_of(mesh);
    for(const auto& change : {+[](const Loop& loop) { return loop; }, reversed}) {
      const Loop handle = change(pairs[0].handle()), tunnel = change(pairs[0].tunnel());
      EXPECT_NEAR(outward * classifier.growth(handle), 2. * CGAL_PI, 0.05 * 2. * CGAL_PI);
      EXPECT_NEAR(outward * classifier.growth(tunnel), -2. * CGAL_PI, 0.05 * 2. * CGAL_PI);
      EXPECT_EQ(classifier.compare_growth(handle, tunnel), outward);
      EXPECT_EQ(classifier.compare_growth(tunnel, handle), -outward);
    }
  }

  Soup torus = soup_of({"torus", {8000, 1, 0}});
};

TEST_F(Circles, GrowAndShrink) { expect_growth(torus, 1); }

TEST_F(Circles, GrowAtAnyScaleAndPlace) {
  for(const double scale : {1e-3, 1e3, 1e-100, 1e50})
    expect_growth(transformed(torus, scale, 0.), 1);
  expect_growth(transformed(torus, 1., -500.), 1);
}

TEST_F(Circles, ShrinkAndGrowWhereFacesLookInwards) {
  reverse_orientation(torus);
  expect_growth(torus, -1);
}

// An offset tells the same as the derivative.
TEST_F(Circles, GrowAndShrinkAtAnOffset) {
  const Mesh mesh = mesh_of(torus);
  const Pairs pairs = find_loops(mesh);
  const Loop &handle = pairs[0].handle(), &tunnel = pairs[0].tunnel();
  const auto point = get(CGAL::vertex_point, mesh);
  const double radius = tunnel.length() / (2. * CGAL_PI);
  for(const double offset : {1e-6 * radius, 0.1 * radius, 0.5 * radius}) {
    EXPECT_EQ(Classifier(mesh, point, offset).compare_growth(handle, tunnel), 1);
    EXPECT_EQ(Classifier(mesh, point, -offset).compare_growth(handle, tunnel), -1);
  }
  // Beyond the axis of the hole its circle has turned around and grows as well, though later.
  EXPECT_EQ(Classifier(mesh, point, 10. * radius).compare_growth(handle, tunnel), 1);
}

// A loop grows as much as itself in another direction, from another place, or on a copy that is
// rotated by a right angle: by intervals this cannot be seen, nor by any number of digits.
TEST_F(Circles, AreEqualExactly) {
  const Mesh mesh = mesh_of({"torus", {400, 1, 0}});
  const Loop loop = find_loops(mesh)[0].tunnel();
  const Classifier classifier = classifier_of(mesh);
  Steps steps = loop.steps();
  std::rotate(steps.begin(), steps.begin() + 3, steps.end());
  EXPECT_EQ(classifier.compare_growth(loop, loop_of(steps)), 0);
  EXPECT_EQ(classifier.compare_growth(loop, reversed(loop)), 0);
  Steps moved = loop.steps();
  double& ratio = moved[2].ratio;
  ratio = std::nextafter(ratio, 0.5);
  EXPECT_EQ(classifier.compare_growth(loop, loop_of(moved)),
            -classifier.compare_growth(loop_of(moved), loop));
  EXPECT_NE(classifier.compare_growth(loop, loop_of(moved)), 0);
}

TEST(Loop_without_extent, DoesNotGrow) {
  const Mesh mesh = mesh_of({"torus", {100, 1, 0}});
  const Classifier classifier = classifier_of(mesh);
  const Mesh::Halfedge_index h(0);
  const Loop nothing = loop_of(Steps()), point = loop_of(Steps(3, {h, 0.5}));
  EXPECT_EQ(classifier.growth(nothing), 0.);
  EXPECT_EQ(classifier.compare_growth(nothing, point), 0);
}

// ---- the loops that are found

TEST(Offset_classification, AgreesOnRoundHandles) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 4}, 1)) {
    if(recipe.kind == "random")
      continue;
    SCOPED_TRACE(recipe);
    const Mesh mesh = mesh_of(recipe);
    const Classifier classifier = classifier_of(mesh);
    for(const auto& pair : find_loops(mesh)) // named by linking numbers; the faces look outwards
      EXPECT_GT(classifier.compare_growth(pair.handle(), pair.tunnel()), 0);
  }
}

} // namespace test_offset_classifier
