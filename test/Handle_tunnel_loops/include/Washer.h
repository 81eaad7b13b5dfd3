#ifndef HTL_TEST_WASHER_H
#define HTL_TEST_WASHER_H

#include "generators/generators.h"

#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstdint>

// A washer with eight sides, outside and inside.
inline CGAL::Handle_tunnel_loops::generators::Soup washer() {
  CGAL::Handle_tunnel_loops::generators::Soup soup;
  constexpr std::uint32_t sides = 8;
  constexpr std::array<std::array<double, 2>, 4> profile = {
      {{1., 0.}, {3., 0.}, {3., 1.}, {1., 1.}}};
  for(std::uint32_t i = 0; i < sides; ++i)
    for(std::uint32_t k = 0; k < 4; ++k) {
      const double angle = 2. * CGAL_PI * i / sides;
      soup.points.push_back(
          {profile[k][0] * std::cos(angle), profile[k][0] * std::sin(angle), profile[k][1]});
      const std::uint32_t a = 4 * i + k, b = 4 * ((i + 1) % sides) + k,
                          c = 4 * ((i + 1) % sides) + (k + 1) % 4, d = 4 * i + (k + 1) % 4;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return soup;
}

#endif // HTL_TEST_WASHER_H
