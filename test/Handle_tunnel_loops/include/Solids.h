#ifndef HTL_TEST_SOLIDS_H
#define HTL_TEST_SOLIDS_H

#include "Generated_soups.h"

#include "generators/Field.h"
#include "generators/mesh_of_field.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Solids of which it is known how the loops on their surface bound. Their meshes are coarse and as
// regular as can be: the vertices have small multiples of one number as coordinates.

using generators::Vector;

// Negative in the solid.
using Solid_function = std::function<double(const Vector&)>;

class Solid : public generators::Field
{
public:
  Solid(Solid_function function, double reach)
      : function_(std::move(function))
      , reach_(reach) {}

  double operator()(const Vector& p) const override { return function_(p); }
  generators::Box box() const override {
    const Vector corner(reach_, reach_, reach_);
    return {-corner, corner};
  }

private:
  Solid_function function_;
  double reach_;
};

inline double distance_to_segment(const Vector& p, const Vector& a, const Vector& b) {
  const Vector along = b - a;
  const double t = std::clamp(((p - a) * along) / along.squared_length(), 0., 1.);
  return generators::length(p - a - t * along);
}

inline Solid_function tube(std::vector<Vector> line, double radius) {
  return [line = std::move(line), radius](const Vector& p) {
    double nearest = 1e9;
    for(std::size_t i = 0; i + 1 < line.size(); ++i)
      nearest = (std::min)(nearest, distance_to_segment(p, line[i], line[i + 1]));
    return nearest - radius;
  };
}

// A closed line, from 0 to 2 pi.
inline std::vector<Vector> closed_line(const std::function<Vector(double)>& curve) {
  constexpr int number_of_segments = 60;
  std::vector<Vector> line;
  for(int i = 0; i < number_of_segments; ++i)
    line.push_back(curve(2. * 3.14159265358979 * i / number_of_segments));
  line.push_back(line.front());
  return line;
}

inline std::vector<Vector> circle(const Vector& centre, const Vector& u, const Vector& v) {
  return closed_line([=](double t) { return centre + std::cos(t) * u + std::sin(t) * v; });
}

inline std::vector<Vector> trefoil() {
  return closed_line([](double t) {
    return Vector(std::sin(t) + 2. * std::sin(2. * t), std::cos(t) - 2. * std::cos(2. * t),
                  -std::sin(3. * t));
  });
}

inline Solid_function ball(double radius) {
  return [radius](const Vector& p) { return generators::length(p) - radius; };
}

inline Solid_function united(Solid_function f, Solid_function g) {
  return [f = std::move(f), g = std::move(g)](const Vector& p) { return (std::min)(f(p), g(p)); };
}

inline Solid_function without(Solid_function f, Solid_function g) {
  return [f = std::move(f), g = std::move(g)](const Vector& p) { return (std::max)(f(p), -g(p)); };
}

inline Soup surface_of(const Solid_function& function, double reach, double spacing) {
  return generators::isosurface(Solid(function, reach), spacing);
}

// ---- the solids

inline Soup ring() {
  return surface_of(tube(circle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0.4), 1.5, 0.25);
}

inline Soup hollow_ring() {
  const auto centre = circle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  return surface_of(without(tube(centre, 0.6), tube(centre, 0.3)), 1.7, 0.2);
}

inline Soup linked_rings() {
  return surface_of(united(tube(circle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0.3),
                           tube(circle({1, 0, 0}, {1, 0, 0}, {0, 0, 1}), 0.3)),
                    2.5, 0.2);
}

inline Soup ball_with_ring_cavity() {
  return surface_of(without(ball(2.), tube(circle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0.4)), 2.2,
                    0.25);
}

// A ball within the cavity of a shell, and in it a cavity like a ring.
inline Soup ring_within_shells() {
  const Solid_function shell = without(ball(3.), ball(2.5));
  const Solid_function inner =
      without(ball(2.), tube(circle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0.4));
  return surface_of(united(shell, inner), 3.3, 0.25);
}

inline Soup trefoil_tube() { return surface_of(tube(trefoil(), 0.5), 4., 0.25); }

// A ball and a tunnel through it, which is a trefoil but for its ends.
inline Soup ball_with_knotted_tunnel() {
  std::vector<Vector> line = trefoil();
  // Opened where the line is farthest out, and led outside.
  const auto farthest = std::max_element(line.begin(), line.end() - 1, [](auto& a, auto& b) {
    return a.squared_length() < b.squared_length();
  });
  line.pop_back();
  std::rotate(line.begin(), farthest, line.end());
  line.insert(line.begin(), 2.5 * line.front());
  line.push_back(2.5 * line[line.size() - 2]);
  return surface_of(without(ball(4.3), tube(line, 0.4)), 4.6, 0.25);
}

#endif // HTL_TEST_SOLIDS_H
