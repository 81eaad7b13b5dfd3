// The field reaches every vertex, whatever the mesh and the constants, and its arrival times have
// one minimum, on which the count of handles rests.

#include "Flat_mesh_of_soup.h"
#include "random_input.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/field/Narrow_band.h>
#include <CGAL/Handle_tunnel_loops/internal/field/handle_candidates.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test_narrow_band {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Handle_tunnel_loops::Field_constants;
using generators::Random;

const auto execution = Execution();

// ---- the formulas

class Formulas : public testing::TestWithParam<double>
{
protected:
  static Step_coefficients coefficients() {
    Field_constants c;
    c.step = GetParam();
    return step_coefficients(c);
  }
};

INSTANTIATE_TEST_SUITE_P(Steps, Formulas, testing::Values(1., 0.5, 0.1));

TEST_P(Formulas, KeepTheFieldInItsRange) {
  for(int i = 0; i <= 100; ++i)
    for(int j = 0; j <= 100; ++j) {
      const float value = stepped_value(i / 100.f, j / 100.f, coefficients());
      EXPECT_GE(value, 0.f);
      EXPECT_LE(value, 1.f);
    }
}

TEST_P(Formulas, HaveTwoPhasesAtRest) {
  EXPECT_EQ(stepped_value(0.f, 0.f, coefficients()), 0.f);
  EXPECT_EQ(stepped_value(1.f, 1.f, coefficients()), 1.f);
}

// An explicit Euler step of the equation that is documented, in double precision.
TEST_P(Formulas, AreAStepOfTheEquation) {
  Random random(6);
  for(int i = 0; i < 1000; ++i) {
    Field_constants c = random_constants(random);
    c.step = GetParam();
    c.penalty = c.gradient_coefficient * random.uniform(0.01, 1.);
    c.driving_force = c.penalty * random.uniform(1., 10.);
    const double phi = random.uniform(0., 1.), mean = random.uniform(0., 1.);
    const double largest_step = 1. / (2. * c.mobility * c.gradient_coefficient);
    const double rate =
        0.5 * c.mobility *
        (c.gradient_coefficient * 4. * (mean - phi) +
         c.driving_force * std::sqrt(phi * (1. - phi)) - c.penalty * (1. - 2. * phi));
    const double value = phi + c.step * largest_step * rate;
    EXPECT_NEAR(
        stepped_value(static_cast<float>(phi), static_cast<float>(mean), step_coefficients(c)),
        (std::min)((std::max)(value, 0.), 1.), 1e-5);
  }
}

// The driving force turns the middle into the phase that grows.
TEST_P(Formulas, LetOnePhaseGrow) { EXPECT_GT(stepped_value(0.5f, 0.5f, coefficients()), 0.5f); }

TEST_P(Formulas, AreMonotoneInTheNeighbors) {
  for(int i = 0; i <= 20; ++i)
    for(int j = 0; j < 20; ++j)
      EXPECT_LE(stepped_value(i / 20.f, j / 20.f, coefficients()),
                stepped_value(i / 20.f, (j + 1) / 20.f, coefficients()));
}

TEST(Crossing_time, IsWithinItsStep) {
  for(const Time step : {1u, 7u, 1000u}) {
    Time latest = step * ticks_per_step;
    for(int i = 0; i < 50; ++i) {
      const float before = i / 100.f;
      for(const float after : {0.5f, 0.6f, 1.f}) {
        const Time time = crossing_time(before, after, step);
        EXPECT_GT(time, (step - 1) * ticks_per_step);
        EXPECT_LE(time, step * ticks_per_step);
      }
      // The nearer the threshold it was, the earlier it is passed.
      const Time time = crossing_time(before, 1.f, step);
      EXPECT_LE(time, latest);
      latest = time;
    }
  }
}

// Up to the last number below the threshold: none of a step's moments is taken for one of the step
// before it.
TEST(Crossing_time, TellsTheStep) {
  Random random(7);
  const auto expect_step = [](float before, float after, Time step) {
    const Time time = crossing_time(before, after, step);
    EXPECT_EQ(step_of(time), step) << before << ' ' << after;
    // The last moment that a step has is after all those of the step before it.
    EXPECT_GT(time, crossing_time(0.f, front_threshold, step - 1));
  };
  std::vector<float> below = {0.f, just_below_threshold, std::nextafter(front_threshold, 0.f)};
  std::vector<float> above = {front_threshold, std::nextafter(front_threshold, 1.f), 1.f};
  for(int i = 0; i < 300; ++i) {
    below.push_back(front_threshold - std::ldexp(1.f, -1 - static_cast<int>(random.below(24))));
    below.push_back(static_cast<float>(random.uniform(0., 0.499)));
    above.push_back(front_threshold + std::ldexp(1.f, -1 - static_cast<int>(random.below(23))));
    above.push_back(static_cast<float>(random.uniform(0.5, 1.)));
  }
  for(const Time step : {1u, 2u, 130u, (never - 1) / ticks_per_step})
    for(const float before : below)
      for(const float after : above)
        expect_step(before, after, step);
  // What was beyond the threshold before, and could not be reached, is reached now.
  for(const Time step : {1u, 2u, 130u})
    for(const float before : above)
      expect_step(before, 1.f, step);
}

TEST(Crossing_time, OfSourcesIsBeforeTheFirstStep) {
  EXPECT_EQ(step_of(0), 0u);
  EXPECT_EQ(step_of(1), 0u);
  EXPECT_GT(crossing_time(std::nextafter(front_threshold, 0.f), 1.f, 1), 1u);
}

// ---- the field from one vertex

class Band_on_mesh
{
public:
  Band_on_mesh(const Flat_mesh& mesh, const Field_constants& constants)
      : mesh_(mesh)
      , stencils_(execution, mesh)
      , band_(mesh, stencils_, step_coefficients(constants)) {}

  std::vector<Time> sweep(Index seed) {
    band_.reset();
    band_.add_source(seed, 0);
    for(const Index u : mesh_.ring(seed))
      band_.add_source(u, 1);
    band_.start(No_walls());
    const std::size_t n = mesh_.number_of_vertices();
    std::vector<int> calls(n, 0);
    while(band_.number_of_reached() < n && band_.step(No_walls(), [&](Index v) { ++calls[v]; }))
      ;
    EXPECT_EQ(band_.number_of_reached(), n);
    EXPECT_LE(*std::max_element(calls.begin(), calls.end()), 1) << "a vertex is reached twice";
    std::vector<Time> times(n);
    for(Index v = 0; v < n; ++v)
      times[v] = band_.time(v);
    return times;
  }

private:
  const Flat_mesh& mesh_;
  Stencils stencils_;
  Narrow_band band_;
};

void expect_one_minimum(const Flat_mesh& mesh, const std::vector<Time>& times, Index seed) {
  const Arrival_order order(times);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    ASSERT_NE(times[v], never) << "vertex " << v << " is not reached";
    EXPECT_EQ(order.is_earlier(order.earliest_neighbor(mesh, v), v), v != seed) << "vertex " << v;
  }
  EXPECT_EQ(find_handle_candidates(execution, mesh, times).size(), mesh.genus);
}

TEST(Narrow_band, HasOneMinimumOnSmoothSurfaces) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3}, 1)) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Band_on_mesh band(mesh, Field_constants());
    for(const Index seed : {Index(0), static_cast<Index>(mesh.number_of_vertices() / 2)}) {
      SCOPED_TRACE(testing::Message() << recipe << ", seed vertex " << seed);
      expect_one_minimum(mesh, band.sweep(seed), seed);
    }
  }
}

TEST(Narrow_band, HasOneMinimumOnRandomSurfaces) {
  Random random(1);
  for(int i = 0; i < 300; ++i) {
    const Recipe recipe = random_recipe(random, 9);
    const Field_constants c = i % 2 == 0 ? Field_constants() : random_constants(random);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Index seed = static_cast<Index>(random.below(mesh.number_of_vertices()));
    SCOPED_TRACE(testing::Message() << recipe << ", seed vertex " << seed << ", constants " << c);
    expect_one_minimum(mesh, Band_on_mesh(mesh, c).sweep(seed), seed);
  }
}

// A vertex with so many neighbours that the field can hardly enter it.
TEST(Narrow_band, ReachesVerticesOfHighDegree) {
  for(const Index n : {3u, 8u, 9u, 100u, 5000u}) {
    Soup soup;
    soup.points = {{0., 0., 1.}, {0., 0., -1.}};
    for(Index i = 0; i < n; ++i) {
      soup.points.push_back({std::cos(6.28 * i / n), std::sin(6.28 * i / n), 0.});
      soup.triangles.push_back({0, 2 + i, 2 + (i + 1) % n});
      soup.triangles.push_back({1, 2 + (i + 1) % n, 2 + i});
    }
    const Flat_mesh mesh = flat_mesh_of(soup);
    Band_on_mesh band(mesh, Field_constants());
    for(const Index seed : {0u, 2u}) {
      SCOPED_TRACE(testing::Message() << "degree " << n << ", seed vertex " << seed);
      expect_one_minimum(mesh, band.sweep(seed), seed);
    }
  }
}

TEST(Narrow_band, IsAsGoodAsNewAfterReset) {
  const Flat_mesh mesh = flat_mesh_of({"random", {500, 5, 3}});
  Band_on_mesh band(mesh, Field_constants());
  for(const Index seed : {0u, 100u, 0u, 37u})
    EXPECT_EQ(band.sweep(seed), Band_on_mesh(mesh, Field_constants()).sweep(seed));
}

// The front moves a constant number of edges per step: a thousand of them take ten times as long as
// a hundred.
TEST(Narrow_band, MovesAtConstantSpeed) {
  const Flat_mesh mesh = flat_mesh_of({"torus", {60000, 1, 0}});
  const std::vector<Time> times = Band_on_mesh(mesh, Field_constants()).sweep(0);
  // Along the grid, straight on from the seed.
  std::vector<Index> line = {0, mesh.ring(0)[0]};
  while(line.size() <= 60) {
    const Ring ring = mesh.ring(line.back());
    line.push_back(ring[(ring.position(line[line.size() - 2]) + 3) % 6]);
  }
  const double first = double(times[line[40]]) - times[line[20]];
  const double second = double(times[line[60]]) - times[line[40]];
  EXPECT_NEAR(second / first, 1., 0.05);
}

// Small steps are more of them: the front needs as much time, and does not count as being at rest.
TEST(Narrow_band, MovesAsFastWithSmallSteps) {
  const Flat_mesh mesh = flat_mesh_of({"torus", {20000, 1, 0}});
  const std::vector<Time> times = Band_on_mesh(mesh, Field_constants()).sweep(0);
  const Time last = *std::max_element(times.begin(), times.end());
  for(const double step : {0.25, 1. / 32., 1. / 1024.}) {
    Field_constants c;
    c.step = step;
    const std::vector<Time> slow = Band_on_mesh(mesh, c).sweep(0);
    SCOPED_TRACE(testing::Message() << "step " << step);
    expect_one_minimum(mesh, slow, 0);
    EXPECT_NEAR(step * *std::max_element(slow.begin(), slow.end()) / last, 1., 0.15);
  }
}

// ---- walls and sides

// Between the vertices with z > 0 and the others.
struct Equator
{
  const Flat_mesh& mesh;

  bool is_above(Index v) const { return mesh.points[v][2] > 0.; }
  bool is_wall(Index u, Index v) const { return is_above(u) != is_above(v); }
};

TEST(Narrow_band, StaysWithinWalls) {
  const Flat_mesh mesh = flat_mesh_of({"sphere", {2000, 0, 0}});
  const Equator walls = {mesh};
  const Stencils stencils(execution, mesh);
  Narrow_band band(mesh, stencils, step_coefficients(Field_constants()));
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    for(const Index u : mesh.ring(v))
      if(walls.is_wall(u, v))
        band.expect_walls(v);
  const auto highest = std::max_element(mesh.points.begin(), mesh.points.end(),
                                        [](const auto& p, const auto& q) { return p[2] < q[2]; });
  band.add_source(static_cast<Index>(highest - mesh.points.begin()), 0);
  band.start(walls);
  while(band.step(walls, [](Index) {}))
    ;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    EXPECT_EQ(band.is_reached(v), walls.is_above(v)) << "vertex " << v;
}

TEST(Narrow_band, KnowsWhereItsFrontsComeFrom) {
  const Flat_mesh mesh = flat_mesh_of({"lattice", {4000, 6, 0}});
  const Stencils stencils(execution, mesh);
  Narrow_band band(mesh, stencils, step_coefficients(Field_constants()));
  const Index left = 0, right = static_cast<Index>(mesh.number_of_vertices() - 1);
  band.add_source(left, 0, Side::LEFT);
  band.add_source(right, 0, Side::RIGHT);
  band.start(No_walls());
  while(band.step(No_walls(), [](Index) {}))
    ;
  EXPECT_EQ(band.side(left), Side::LEFT);
  EXPECT_EQ(band.side(right), Side::RIGHT);
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    ASSERT_TRUE(band.is_reached(v));
    if(v == left || v == right)
      continue;
    const Ring ring = mesh.ring(v);
    EXPECT_TRUE(std::any_of(ring.begin(), ring.end(), [&](Index u) {
      return band.time(u) < band.time(v) && band.side(u) == band.side(v);
    }));
  }
}

} // namespace test_narrow_band
