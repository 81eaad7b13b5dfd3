#ifndef HTL_TEST_TORUS_LOOPS_H
#define HTL_TEST_TORUS_LOOPS_H

#include "Crossing_loops.h"

#include <cmath>
#include <utility>
#include <vector>

// The torus of revolution that the generator makes: radii 1 and 0.4.
constexpr double pi = 3.14159265358979;
constexpr double tube_radius = 0.4;
constexpr double inner_radius = 1. - tube_radius;

// An angle around the axis, and one around the tube; 0 is outside.
using Torus_angles = std::pair<double, double>;

inline Index vertex_near(const Flat_mesh& torus, const Torus_angles& angles) {
  const auto [u, v] = angles;
  const double r = 1. + tube_radius * std::cos(v);
  const std::array<double, 3> p = {r * std::cos(u), r * std::sin(u), tube_radius * std::sin(v)};
  const auto distance = [&](const std::array<double, 3>& q) {
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  const auto nearest =
      std::min_element(torus.points.begin(), torus.points.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return static_cast<Index>(nearest - torus.points.begin());
}

// From place to place along few edges, and back to the first one.
inline Crossing_loop loop_through(const Flat_mesh& torus, const std::vector<Torus_angles>& places) {
  Vertex_walk walk;
  for(std::size_t i = 0; i < places.size(); ++i) {
    const Vertex_walk part = path(torus, vertex_near(torus, places[i]),
                                  vertex_near(torus, places[(i + 1) % places.size()]));
    walk.insert(walk.end(), part.begin(), part.end());
  }
  CGAL::Handle_tunnel_loops::internal::remove_spurs(walk);
  return CGAL::Handle_tunnel_loops::internal::pushed_left(torus, walk);
}

// Once around the tube, swinging to both sides.
inline Crossing_loop loop_around_tube(const Flat_mesh& torus, double swing) {
  std::vector<Torus_angles> places;
  for(int i = 0; i < 8; ++i)
    places.emplace_back(1. + (i % 2 == 0 ? swing : -swing), i * pi / 4.);
  return loop_through(torus, places);
}

// Once along the inner side of the tube, swinging up and down.
inline Crossing_loop loop_around_hole(const Flat_mesh& torus, double swing) {
  std::vector<Torus_angles> places;
  for(int i = 0; i < 12; ++i)
    places.emplace_back(i * pi / 6., pi + (i % 2 == 0 ? swing : -swing));
  return loop_through(torus, places);
}

#endif // HTL_TEST_TORUS_LOOPS_H
