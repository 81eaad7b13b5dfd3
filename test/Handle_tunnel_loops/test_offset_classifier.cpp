// Moved outwards, a circle around a tube grows by 2 pi times the way, one around a hole shrinks.

#include "Torus_loops.h"

#include <CGAL/Handle_tunnel_loops/internal/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/Offset_classifier.h>

#include <gtest/gtest.h>

#include <vector>

namespace {

using CGAL::Handle_tunnel_loops::internal::Loop_tightening;
using CGAL::Handle_tunnel_loops::internal::Offset_classifier;
using CGAL::Handle_tunnel_loops::internal::Sequential_execution;

// The circles, tightened on the torus as it is; then the torus may be changed.
class Circles : public testing::Test
{
protected:
  Circles() {
    const Flat_mesh torus = flat_mesh_of(soup);
    around_tube = loop_around_tube(torus, 0.);
    around_hole = loop_around_hole(torus, 0.);
    Loop_tightening tightening(torus);
    tightening.tighten(around_tube);
    tightening.tighten(around_hole);
  }

  void expect_growth() const {
    const Flat_mesh torus = flat_mesh_of(soup);
    const Offset_classifier classifier(Sequential_execution(), torus);
    for(const auto& change : {+[](const Crossing_loop& loop) { return loop; }, reversed}) {
      EXPECT_NEAR(classifier.growth(change(around_tube)), 2. * pi, 0.05 * 2. * pi);
      EXPECT_NEAR(classifier.growth(change(around_hole)), -2. * pi, 0.05 * 2. * pi);
    }
  }

  Soup soup = soup_of({"torus", {8000, 1, 0}});
  Crossing_loop around_tube, around_hole;
};

TEST_F(Circles, GrowAndShrink) { expect_growth(); }

TEST_F(Circles, GrowAtAnyScaleAndPlace) {
  for(const double scale : {1e-3, 1e3})
    for(const double shift : {0., -500.}) {
      soup = transformed(soup_of({"torus", {8000, 1, 0}}), scale, shift * scale);
      expect_growth();
    }
}

// Faces that look inwards, with the loops turned over as well, which keeps their left side.
TEST_F(Circles, DoNotDependOnTheOrientation) {
  reverse_orientation(soup);
  around_tube = reversed(around_tube);
  around_hole = reversed(around_hole);
  expect_growth();
}

TEST(Empty_loop, DoesNotGrow) {
  const Flat_mesh torus = flat_mesh_of({"torus", {100, 1, 0}});
  EXPECT_EQ(Offset_classifier(Sequential_execution(), torus).growth({}), 0.);
}

} // namespace
