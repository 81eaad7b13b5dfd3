#ifndef HTL_TEST_RANDOM_ROTATIONS_H
#define HTL_TEST_RANDOM_ROTATIONS_H

#include "generators/Random.h"
#include "generators/generators.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace random_surfaces {

/// A rotation, as the rows of its matrix.
using Rotation = std::array<std::array<double, 3>, 3>;

/// that of a random quaternion.
inline Rotation random_rotation(CGAL::Handle_tunnel_loops::generators::Random& random) {
  std::array<double, 4> q;
  double norm = 0.;
  do {
    for(double& x : q)
      x = random.uniform(-1., 1.);
    norm = std::sqrt(std::inner_product(q.begin(), q.end(), q.begin(), 0.));
  } while(norm > 1. || norm < 0.1);
  for(double& x : q)
    x /= norm;
  const auto [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

/// turns all points at random.
inline void turn(CGAL::Handle_tunnel_loops::generators::Soup& soup,
                 CGAL::Handle_tunnel_loops::generators::Random& random) {
  const Rotation rotation = random_rotation(random);
  for(auto& p : soup.points) {
    const auto from = p;
    for(std::size_t i = 0; i < 3; ++i)
      p[i] = rotation[i][0] * from[0] + rotation[i][1] * from[1] + rotation[i][2] * from[2];
  }
}

} // namespace random_surfaces

#endif // HTL_TEST_RANDOM_ROTATIONS_H
