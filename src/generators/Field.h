// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_FIELD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_FIELD_H

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

using Vector = CGAL::Simple_cartesian<double>::Vector_3;

inline double length(const Vector& v) { return std::sqrt(v.squared_length()); }
inline Vector unit(const Vector& v) { return v / length(v); }

/// An axis-parallel box.
struct Box
{
  Vector low, high;

  /// the smallest box that also holds a point.
  Box with(const Vector& p) const {
    return {
        Vector((std::min)(low.x(), p.x()), (std::min)(low.y(), p.y()), (std::min)(low.z(), p.z())),
        Vector((std::max)(high.x(), p.x()), (std::max)(high.y(), p.y()),
               (std::max)(high.z(), p.z()))};
  }

  /// the box whose faces are further out.
  Box grown(double distance) const {
    const Vector d(distance, distance, distance);
    return {low - d, high + d};
  }
};

/// A solid given by a function that is negative inside, positive outside, and nowhere larger, in
/// absolute value, than the distance to the solid's surface.
class Field
{
public:
  virtual ~Field() = default;
  virtual double operator()(const Vector& p) const = 0;
  virtual Box box() const = 0; ///< a box around the solid
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_FIELD_H
