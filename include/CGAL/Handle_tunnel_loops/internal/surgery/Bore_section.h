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
#include <CGAL/Handle_tunnel_loops/internal/surgery/Fitted_circle.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Plane_axes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Round and straight. The axis is of length 1, and leads through the middle.
struct Cylinder
{
  Simple_cartesian<double>::Point_3 center;
  Simple_cartesian<double>::Vector_3 axis;
  double diameter;
  double length;    ///< along the axis
  double deviation; ///< the largest distance of a corner of the wall
  Index first_face; ///< the lowest number of a face of the wall
};

/// as long as twice the area of a face; none for one that is too narrow to tell.
inline Simple_cartesian<double>::Vector_3 area_of(const Surgery_mesh& mesh, Index f) {
  constexpr double narrow = 1e-9;
  const Surgery_mesh::Face& c = mesh.corners(f);
  const auto side = [&](Index v) {
    const Surgery_mesh::Point &p = mesh.point(c[0]), &q = mesh.point(v);
    return Simple_cartesian<double>::Vector_3(q.x() - p.x(), q.y() - p.y(), q.z() - p.z());
  };
  const auto u = side(c[1]), v = side(c[2]), n = CGAL::cross_product(u, v);
  const double longest = (std::max)(u.squared_length(), v.squared_length());
  return std::sqrt(n.squared_length()) > narrow * longest ? n : decltype(n)(NULL_VECTOR);
}

/// A straight part of the wall of a bore that bends by no more than a hexagon does: a cylinder, if
/// it is round.
class Bore_section
{
  using Kernel = Simple_cartesian<double>;
  using Vector = Kernel::Vector_3;

public:
  /// of the faces that lie along an axis, given in ascending order.
  Bore_section(const Surgery_mesh& mesh, std::vector<Index> faces, const Vector& axis)
      : mesh_(mesh)
      , faces_(std::move(faces))
      , axis_(axis) {}

  /// through the edges along it: those lie on a circle as they are seen along its axis, and go all
  /// the way around. Linear in the number of faces.
  std::optional<Cylinder> cylinder() const {
    const std::vector<Index> corners = corners_of_section();
    if(corners.empty())
      return std::nullopt;
    const Plane_axes plane(axis_);
    std::vector<Fitted_circle::Point> points;
    double least = 0., most = 0.; // along the axis, from the first corner
    for(Index v : corners) {
      const Vector p = shift(corners.front(), v);
      points.push_back(plane.seen(p));
      least = (std::min)(least, axis_ * p);
      most = (std::max)(most, axis_ * p);
    }
    const std::optional<Fitted_circle> circle = Fitted_circle::around(points);
    if(!circle || !circle->is_round())
      return std::nullopt;
    const Vector center = plane.in_space(circle->center) + axis_ * ((least + most) / 2.);
    const Surgery_mesh::Point& origin = mesh_.point(corners.front());
    return Cylinder{{origin.x() + center.x(), origin.y() + center.y(), origin.z() + center.z()},
                    forward(axis_),
                    2. * circle->radius,
                    most - least,
                    circle->deviation(),
                    faces_.front()};
  }

  /// adds itself to a cylinder if it lies on that, but for a hundredth of the diameter, by which a
  /// bore may fail to be round, too. Returns whether it does.
  bool extend(Cylinder& whole) const {
    double least = -whole.length / 2., most = whole.length / 2., deviation = whole.deviation;
    for(Index v : corners_of_section()) {
      const Surgery_mesh::Point& p = mesh_.point(v);
      const Vector shift(p.x() - whole.center.x(), p.y() - whole.center.y(),
                         p.z() - whole.center.z());
      const double height = whole.axis * shift,
                   radius = std::sqrt((shift - height * whole.axis).squared_length());
      deviation = (std::max)(deviation, std::abs(radius - whole.diameter / 2.));
      least = (std::min)(least, height);
      most = (std::max)(most, height);
    }
    if(!(deviation <= 0.01 * whole.diameter))
      return false;
    whole = {whole.center + whole.axis * ((least + most) / 2.),
             whole.axis,
             whole.diameter,
             most - least,
             deviation,
             (std::min)(whole.first_face, faces_.front())};
    return true;
  }

private:
  Vector shift(Index u, Index v) const {
    const Surgery_mesh::Point &p = mesh_.point(u), &q = mesh_.point(v);
    return {q.x() - p.x(), q.y() - p.y(), q.z() - p.z()};
  }

  // Of the coordinates that are largest, but for rounding, the first one is positive.
  static Vector forward(const Vector& v) {
    constexpr double rounding = 1e-9;
    const double x = std::abs(v.x()), y = std::abs(v.y()), z = std::abs(v.z()),
                 most = (std::max)({x, y, z}) - rounding;
    return (x >= most ? v.x() : y >= most ? v.y() : v.z()) < 0. ? -v : v;
  }

  // Where the section bends: other vertices lie between two corners of a polygon. In ascending
  // order.
  std::vector<Index> corners_of_section() const {
    constexpr double flat = 1. - 1e-7; // the cosine of an angle of 0.03 degrees
    std::map<Index, Vector> normals;   // the first one at each vertex
    std::vector<Index> corners;
    for(Index f : faces_)
      if(const Vector area = area_of(mesh_, f); area != Vector(NULL_VECTOR))
        for(Index v : mesh_.corners(f)) {
          const Vector& n = normals.insert({v, area}).first->second;
          if(n * area < flat * std::sqrt(n.squared_length() * area.squared_length()))
            corners.push_back(v);
        }
    make_set(corners);
    return corners;
  }

  const Surgery_mesh& mesh_;
  const std::vector<Index> faces_;
  const Vector axis_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_BORE_SECTION_H
