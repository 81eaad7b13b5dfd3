#ifndef HTL_TEST_DEFORMATIONS_H
#define HTL_TEST_DEFORMATIONS_H

#include "Generated_soups.h"

#include "generators/Random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

// What makes the geometry of a mesh ugly and leaves its topology: nobody's mesh is all that, but
// each of it is somebody's.

using Deformed_points = std::vector<std::array<double, 3>>;

// Differences of coordinates stay finite.
inline double within_doubles(double x) { return std::clamp(x, -1e300, 1e300); }

inline double power_of_ten(generators::Random& random, int low, int high) {
  return std::pow(10., low + static_cast<int>(random.below(std::size_t(high - low + 1))));
}

inline double largest_coordinate(const Deformed_points& points) {
  double largest = 0.;
  for(const auto& p : points)
    for(double x : p)
      largest = (std::max)(largest, std::abs(x));
  return largest;
}

inline void jitter(Deformed_points& points, generators::Random& random) {
  const double size = largest_coordinate(points) * power_of_ten(random, -16, 0);
  for(auto& p : points)
    for(double& x : p)
      x = within_doubles(x + random.uniform(-1., 1.) * size);
}

inline void press_to_plane(Deformed_points& points, generators::Random& random) {
  const std::size_t axis = random.below(3);
  for(auto& p : points)
    p[axis] = 0.;
}

inline void press_to_line(Deformed_points& points, generators::Random& random) {
  const std::size_t axis = random.below(3);
  for(auto& p : points)
    p = {p[axis], p[axis], 1.};
}

inline void round_to_grid(Deformed_points& points, generators::Random& random) {
  const double step = largest_coordinate(points) / static_cast<double>(1 << random.below(6));
  for(auto& p : points)
    for(double& x : p)
      x = step > 0. ? std::round(x / step) * step : x;
}

inline void scale(Deformed_points& points, generators::Random& random) {
  const double factor = power_of_ten(random, -300, 300);
  for(auto& p : points)
    for(double& x : p)
      x = within_doubles(x * factor);
}

inline void scale_axis(Deformed_points& points, generators::Random& random) {
  const std::size_t axis = random.below(3);
  const double factor = power_of_ten(random, -200, 200);
  for(auto& p : points)
    p[axis] = within_doubles(p[axis] * factor);
}

inline void move_some_far_away(Deformed_points& points, generators::Random& random) {
  for(std::size_t i = 1 + random.below(3); i > 0; --i)
    for(double& x : points[random.below(points.size())])
      x = random.uniform(-1., 1.) * power_of_ten(random, -200, 300);
}

inline void move_some_onto_others(Deformed_points& points, generators::Random& random) {
  for(std::size_t i = 1 + random.below(points.size() / 3 + 1); i > 0; --i)
    points[random.below(points.size())] = points[random.below(points.size())];
}

inline void turn_inside_out(Deformed_points& points, generators::Random& random) {
  const std::size_t axis = random.below(3);
  for(auto& p : points)
    p[axis] = -p[axis];
}

// One to three of these.
inline void deform(Soup& soup, generators::Random& random) {
  constexpr void (*ways[])(Deformed_points&, generators::Random&) = {
      jitter,     press_to_plane,     press_to_line,         round_to_grid,  scale,
      scale_axis, move_some_far_away, move_some_onto_others, turn_inside_out};
  for(std::size_t i = 1 + random.below(3); i > 0; --i)
    ways[random.below(std::size(ways))](soup.points, random);
}

#endif // HTL_TEST_DEFORMATIONS_H
