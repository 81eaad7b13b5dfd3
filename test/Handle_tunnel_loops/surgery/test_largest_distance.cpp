// Distances of triangles from others are those of their points, up to the tolerance; from the axis
// of a bore, too, whose wall is equally near everywhere.

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/surgery/Largest_distance.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace test_largest_distance {

namespace generators = CGAL::Handle_tunnel_loops::generators;

using CGAL::Handle_tunnel_loops::internal::Largest_distance;
using Point = Largest_distance::Point;
using Triangle = Largest_distance::Triangle;
using Triangles = Largest_distance::Triangles;

constexpr double infinity = std::numeric_limits<double>::infinity();

Point random_point(generators::Random& random) {
  return {random.uniform(0., 1.), random.uniform(0., 1.), random.uniform(0., 1.)};
}

// Small ones, large ones and needles.
Triangles random_triangles(generators::Random& random, std::size_t n) {
  Triangles all;
  while(all.size() < n) {
    const Point p = random_point(random), q = random_point(random), r = random_point(random);
    const double size = std::pow(random.uniform(0.1, 1.), 3.), width = random.uniform(0.01, 1.);
    all.push_back({p, p + size * (q - p), p + size * width * (r - p)});
  }
  return all;
}

// Of points of a grid on each triangle; those that are not above the nearest do not count, if
// only those above are asked for.
double largest_of_grid(const Triangles& from, const Triangles& to, bool has_to_be_above) {
  constexpr int n = 16;
  double most = 0.;
  for(const Triangle& t : from)
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j) {
        const Point p = t[0] + double(i) / n * (t[1] - t[0]) + double(j) / n * (t[2] - t[0]);
        double nearest = infinity;
        bool is_above = false;
        for(const Triangle& other : to) {
          const double distance = std::sqrt(CGAL::squared_distance(p, other));
          if(distance < nearest)
            is_above = (p - other[0]) * Largest_distance::normal(other) > 0.;
          nearest = (std::min)(nearest, distance);
        }
        if(is_above || !has_to_be_above)
          most = (std::max)(most, nearest);
      }
  return most;
}

double size_of_grid(const Triangles& from) {
  double most = 0.;
  for(const Triangle& t : from)
    for(int i = 0; i < 3; ++i)
      most = (std::max)(most, std::sqrt(CGAL::squared_distance(t[i], t[i + 1])) / 16.);
  return most;
}

TEST(Largest_distance, IsThatOfPoints) {
  generators::Random random(1);
  for(int run = 0; run < 30; ++run) {
    const Triangles from = random_triangles(random, 4), to = random_triangles(random, 40);
    const double of_grid = largest_of_grid(from, to, false);
    for(const double tolerance : {0.1, 0.01}) {
      const double most = Largest_distance(to, {tolerance, infinity}).from(from);
      EXPECT_GE(most, of_grid - tolerance) << run;
      EXPECT_LE(most, of_grid + size_of_grid(from)) << run;
    }
  }
}

TEST(Largest_distance, EndsAboveTheLimit) {
  generators::Random random(2);
  int number_that_end = 0;
  for(int run = 0; run < 30; ++run) {
    const Triangles from = random_triangles(random, 4), to = random_triangles(random, 10);
    const double of_grid = largest_of_grid(from, to, false);
    const double most = Largest_distance(to, {0.001, 0.5 * of_grid}).from(from);
    EXPECT_GT(most, 0.5 * of_grid) << run;
    number_that_end += most < of_grid - 0.001;
  }
  EXPECT_GT(number_that_end, 15);
}

TEST(Largest_distance, CountsWhatIsAbove) {
  generators::Random random(3);
  // Flat, so that a point is above all, or none.
  Triangles to;
  for(const Triangle& t : random_triangles(random, 40)) {
    const Point p(t[0].x(), t[0].y(), 0.5), q(t[1].x(), t[1].y(), 0.5), r(t[2].x(), t[2].y(), 0.5);
    to.push_back(CGAL::cross_product(q - p, r - p).z() > 0. ? Triangle(p, q, r)
                                                            : Triangle(p, r, q));
  }
  for(int run = 0; run < 30; ++run) {
    const Triangles from = random_triangles(random, 4);
    const double of_grid = largest_of_grid(from, to, true), tolerance = 0.01;
    const double most = Largest_distance(to, {tolerance, infinity}).above(1., from);
    EXPECT_GE(most, of_grid - tolerance) << run;
    EXPECT_LE(most, of_grid + size_of_grid(from)) << run;
  }
}

TEST(Largest_distance, CountsWhatIsOutsideOfASharpSolid) {
  generators::Random random(4);
  for(int run = 0; run < 30; ++run) {
    const Point p = random_point(random), q = random_point(random), r = random_point(random),
                s = CGAL::centroid(p, q, r) + 0.02 * CGAL::cross_product(q - p, r - p);
    const Triangles solid = {{p, r, q}, {p, q, s}, {q, r, s}, {r, p, s}},
                    from = random_triangles(random, 4);
    const double of_grid = largest_of_grid(from, solid, false); // none is far inside
    const double most = Largest_distance(solid, {0.01, infinity}).above(1., from);
    EXPECT_GE(most, of_grid - 0.02) << run;
    EXPECT_LE(most, of_grid + size_of_grid(from)) << run;
  }
}

// From above a ridge one of its faces may be seen from behind, which is as near as the other.
TEST(Largest_distance, CountsWhatIsAboveARidge) {
  const Point begin(0., -1., 0.), end(0., 1., 0.), left(-0.2, 0., -1.), right(0.2, 0., -1.);
  for(const double side : {-1., 1.}) {
    const Triangles above = {
        {{side * 0.31, -0.1, 0.01}, {side * 0.31, 0.1, 0.01}, {side * 0.3, 0., 0.02}}};
    for(const Triangles& ridge : {Triangles{{begin, left, end}, {end, right, begin}},
                                  Triangles{{end, right, begin}, {begin, left, end}}})
    {
      EXPECT_GT(Largest_distance(ridge, {0.001, infinity}).above(-1., above), 0.29) << side;
      EXPECT_EQ(Largest_distance(ridge, {0.001, infinity}).above(1., above), 0.) << side;
    }
  }
}

// The wall of a bore around the z axis, of needles.
Triangles wall(int n) {
  Triangles all;
  const auto at = [n](int i, double z) {
    const double angle = 2. * CGAL_PI * (i % n) / n;
    return Point(std::cos(angle), std::sin(angle), z);
  };
  for(int i = 0; i < n; ++i) {
    all.push_back({at(i, 0.), at(i + 1, 0.), at(i + 1, 4.)});
    all.push_back({at(i, 0.), at(i + 1, 4.), at(i, 4.)});
  }
  return all;
}

TEST(Largest_distance, FromTheAxisOfABore) {
  const Triangles around = wall(1000);
  Triangles mouth;
  for(const Triangle& t : around)
    if(t[1].z() == 0.)
      mouth.push_back({t[0], t[1], {0., 0., 0.}});
  const double most = Largest_distance(around, {0.02, infinity}).from(mouth);
  EXPECT_GT(most, 0.98 - 1e-5);
  EXPECT_LE(most, 1.);
}

TEST(Largest_distance, FromNothingAndToNothing) {
  const Triangles some = wall(3);
  EXPECT_EQ(Largest_distance({}, {0.1, infinity}).from(some), 0.);
  EXPECT_EQ(Largest_distance({}, {0.1, infinity}).above(1., some), 0.);
  EXPECT_EQ(Largest_distance(some, {0.1, infinity}).from({}), 0.);
  EXPECT_NEAR(Largest_distance(some, {0.1, infinity}).from(some), 0., 1e-12);
}

} // namespace test_largest_distance
