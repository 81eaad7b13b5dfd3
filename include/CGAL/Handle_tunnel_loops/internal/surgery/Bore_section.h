// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SECTION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SECTION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rim.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A part of the wall of a bore that bends by no more than a hexagon does: a cylinder, if it is
/// straight and round.
class Bore_section
{
  using Kernel = Simple_cartesian<double>;
  using Vector = Kernel::Vector_3;
  using Point = Kernel::Point_2;

public:
  Bore_section(const Surgery_mesh& mesh, std::vector<Index> faces)
      : mesh_(mesh)
      , faces_(std::move(faces)) {
    for(Index f : faces_)
      areas_.push_back(area_of(f));
  }

  /// that of the circle on which the edges along it lie, as it is seen along its axis, if they do,
  /// and go all the way around. Linear in the number of faces.
  std::optional<double> diameter() const {
    const Vector axis = this->axis();
    if(axis == Vector(NULL_VECTOR) || !is_straight(axis))
      return std::nullopt;
    const std::vector<Point> points = seen_along(axis);
    if(points.size() < 6)
      return std::nullopt;
    const auto [center, radius] = circle_through(points);
    return are_on_circle(points, center, radius) && go_around(points, center)
               ? std::optional<double>(2. * radius)
               : std::nullopt;
  }

private:
  // As long as twice the area; none for faces that are too narrow to tell.
  Vector area_of(Index f) const {
    constexpr double narrow = 1e-9;
    const Surgery_mesh::Face& c = mesh_.corners(f);
    const auto u = shift(c[0], c[1]), v = shift(c[0], c[2]), n = CGAL::cross_product(u, v);
    const double longest = (std::max)(u.squared_length(), v.squared_length());
    return std::sqrt(n.squared_length()) > narrow * longest ? n : Vector(NULL_VECTOR);
  }

  Vector shift(Index u, Index v) const {
    const Surgery_mesh::Point &p = mesh_.point(u), &q = mesh_.point(v);
    return {q.x() - p.x(), q.y() - p.y(), q.z() - p.z()};
  }

  // At right angles to two faces, one of which is the largest.
  Vector axis() const {
    const auto largest =
        std::max_element(areas_.begin(), areas_.end(), [](const Vector& m, const Vector& n) {
          return m.squared_length() < n.squared_length();
        });
    Vector axis(NULL_VECTOR);
    for(const Vector& n : areas_)
      if(const Vector other = CGAL::cross_product(*largest, n);
         other.squared_length() > axis.squared_length())
        axis = other;
    const double length = std::sqrt(axis.squared_length());
    return length > 0. ? axis / length : axis;
  }

  bool is_straight(const Vector& axis) const {
    constexpr double sine = 0.01; // of half a degree
    return std::all_of(areas_.begin(), areas_.end(), [&](const Vector& n) {
      const double along = axis * n;
      return along * along <= sine * sine * n.squared_length();
    });
  }

  // The vertices where the section bends: others lie between two corners of a polygon.
  std::vector<Point> seen_along(const Vector& axis) const {
    constexpr double flat = 1. - 1e-7; // the cosine of an angle of 0.03 degrees
    std::map<Index, Vector> normals;   // the first one at each vertex
    std::vector<Index> corners;
    for(std::size_t i = 0; i < faces_.size(); ++i)
      if(areas_[i] != Vector(NULL_VECTOR))
        for(Index v : mesh_.corners(faces_[i])) {
          const Vector& n = normals.insert({v, areas_[i]}).first->second;
          if(n * areas_[i] < flat * std::sqrt(n.squared_length() * areas_[i].squared_length()))
            corners.push_back(v);
        }
    make_set(corners);
    const Vector some = std::abs(axis.x()) < 0.6 ? Vector(1., 0., 0.) : Vector(0., 1., 0.);
    Vector x = CGAL::cross_product(axis, some);
    x = x / std::sqrt(x.squared_length());
    const Vector y = CGAL::cross_product(axis, x);
    std::vector<Point> points;
    for(Index v : corners) {
      const Vector p = shift(corners.front(), v);
      points.emplace_back(p * x, p * y);
    }
    return points;
  }

  // That of least squares: of x^2 + y^2 - a x - b y - c, about the centroid.
  static std::pair<Point, double> circle_through(const std::vector<Point>& points) {
    const double number = static_cast<double>(points.size());
    Kernel::Vector_2 sum(NULL_VECTOR);
    for(const Point& p : points)
      sum = sum + (p - ORIGIN);
    const Point middle = ORIGIN + sum / number;
    double xx = 0., xy = 0., yy = 0., xr = 0., yr = 0., r = 0.;
    for(const Point& p : points) {
      const double x = p.x() - middle.x(), y = p.y() - middle.y(), square = x * x + y * y;
      xx += x * x, xy += x * y, yy += y * y, xr += x * square, yr += y * square, r += square;
    }
    const double determinant = 2. * (xx * yy - xy * xy);
    const double x = (xr * yy - yr * xy) / determinant, y = (yr * xx - xr * xy) / determinant;
    return {Point(middle.x() + x, middle.y() + y), std::sqrt(r / number + x * x + y * y)};
  }

  static bool are_on_circle(const std::vector<Point>& points, const Point& center, double radius) {
    constexpr double tolerance = 0.01;
    return std::all_of(points.begin(), points.end(), [&](const Point& p) {
      return std::abs(std::sqrt(CGAL::squared_distance(p, center)) - radius) <= tolerance * radius;
    });
  }

  // As the corners of a hexagon do.
  static bool go_around(const std::vector<Point>& points, const Point& center) {
    constexpr double widest = CGAL_PI / 3. + 0.01;
    std::vector<double> angles;
    for(const Point& p : points)
      angles.push_back(std::atan2(p.y() - center.y(), p.x() - center.x()));
    std::sort(angles.begin(), angles.end());
    angles.push_back(angles.front() + 2. * CGAL_PI);
    for(std::size_t i = 1; i < angles.size(); ++i)
      if(angles[i] - angles[i - 1] > widest)
        return false;
    return true;
  }

  const Surgery_mesh& mesh_;
  const std::vector<Index> faces_;
  std::vector<Vector> areas_; // by face
};

/// the parts of a wall, given in ascending order. Linear in its size.
inline std::vector<Bore_section> sections_of(const Surgery_mesh& mesh,
                                             const std::vector<Index>& wall) {
  constexpr double cosine = 0.48; // of a little more than 60 degrees
  std::vector<Bore_section> sections;
  std::unordered_set<Index> is_taken;
  for(Index first : wall) {
    std::vector<Index> faces;
    if(is_taken.insert(first).second)
      faces.push_back(first);
    for(std::size_t i = 0; i < faces.size(); ++i)
      for(Index h : {3 * faces[i], 3 * faces[i] + 1, 3 * faces[i] + 2}) {
        const Index other = mesh.face(mesh.twin(h));
        const auto m = normal_of(mesh, faces[i]), n = normal_of(mesh, other);
        if(m * n >= cosine * std::sqrt(m.squared_length() * n.squared_length()) &&
           is_in(other, wall) && is_taken.insert(other).second)
          faces.push_back(other);
      }
    if(!faces.empty())
      sections.emplace_back(mesh, std::move(faces));
  }
  return sections;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SECTION_H
