#ifndef HTL_TEST_GAUSS_LINKING_H
#define HTL_TEST_GAUSS_LINKING_H

#include "Loop_definitions.h"

#include <array>
#include <cmath>
#include <vector>

// Linking numbers by Gauss' integral, and copies of loops moved along the normals: in floating
// point, and otherwise by definition.

using Polygon = std::vector<Coordinates>;

inline Coordinates difference(const Coordinates& a, const Coordinates& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double inner_product(const Coordinates& a, const Coordinates& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Coordinates outer_product(const Coordinates& a, const Coordinates& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm_of(const Coordinates& a) { return std::sqrt(inner_product(a, a)); }

// The solid angle of a triangle seen from the origin (van Oosterom and Strackee).
inline double solid_angle(const Coordinates& a, const Coordinates& b, const Coordinates& c) {
  const double x = norm_of(a), y = norm_of(b), z = norm_of(c);
  return 2. * std::atan2(inner_product(a, outer_product(b, c)),
                         x * y * z + inner_product(a, b) * z + inner_product(b, c) * x +
                             inner_product(c, a) * y);
}

// The vectors from one segment to another fill a parallelogram.
inline double gauss_integral(const Coordinates& a,
                             const Coordinates& b,
                             const Coordinates& c,
                             const Coordinates& d) {
  const Coordinates ac = difference(c, a), ad = difference(d, a), bc = difference(c, b),
                    bd = difference(d, b);
  return solid_angle(ac, bc, bd) + solid_angle(ac, bd, ad);
}

inline double linking_number(const Polygon& p, const Polygon& q) {
  double sum = 0.;
  for(std::size_t i = 0; i < p.size(); ++i)
    for(std::size_t j = 0; j < q.size(); ++j)
      sum += gauss_integral(p[i], p[(i + 1) % p.size()], q[j], q[(j + 1) % q.size()]);
  return sum / (4. * 3.14159265358979);
}

template <typename Mesh> Coordinates face_normal(const Mesh& mesh, typename Mesh::Face_index f) {
  const auto h = mesh.halfedge(f);
  const Coordinates a = coordinates(mesh.point(mesh.source(h))),
                    b = coordinates(mesh.point(mesh.target(h))),
                    c = coordinates(mesh.point(mesh.target(mesh.next(h))));
  const Coordinates n = outer_product(difference(b, a), difference(c, a));
  const double length = norm_of(n);
  return {n[0] / length, n[1] / length, n[2] / length};
}

// The loop, moved by `distance` along the normals.
template <typename Mesh, typename Loop>
Polygon moved(const Mesh& mesh, const Loop& loop, double distance) {
  Polygon polygon;
  for(std::size_t i = 0; i < loop.size(); ++i) {
    Coordinates p = coordinates(loop.points()[i]), n = {0., 0., 0.};
    for(const auto f : faces_at<Mesh, Loop>(mesh, loop.steps()[i])) {
      const Coordinates m = face_normal(mesh, f);
      for(int d = 0; d < 3; ++d)
        n[d] += m[d];
    }
    const double length = norm_of(n);
    for(int d = 0; d < 3; ++d)
      p[d] += distance / length * n[d];
    polygon.push_back(p);
  }
  return polygon;
}

#endif // HTL_TEST_GAUSS_LINKING_H
