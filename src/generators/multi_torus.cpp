// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Field.h"
#include "Hole_rows.h"
#include "kinds.h"
#include "mesh_of_field.h"
#include "request_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

/// A flat slab with round holes at distance one, its rims rounded.
class Slab : public Field
{
public:
  explicit Slab(std::size_t holes)
      : rows_(holes)
      , full_rows_(static_cast<double>(rows_.full_rows()))
      , short_rows_(static_cast<double>(rows_.rows()) - full_rows_) {}

  // The points within the rim's radius of a flat region, which is the outline without the holes,
  // made smaller by that radius.
  double operator()(const Vector& p) const override {
    const double from_region = (std::max)(outline(p.x(), p.y()), hole(p.x(), p.y())) + rim_radius;
    return std::hypot((std::max)(from_region, 0.), p.z()) - rim_radius;
  }

  Box box() const override {
    const double x = rows_.columns() / 2. + margin;
    return {Vector(-x, -0.5 - margin, -rim_radius),
            Vector(x, rows_.rows() - 0.5 + margin, rim_radius)};
  }

private:
  static constexpr double rim_radius = 0.2, hole_radius = 0.25, corner_radius = 0.45, margin = 0.05;

  /// the distance to a rectangle with round corners, negative inside.
  static double rectangle(double x, double y, double half_width, double half_height) {
    const double dx = std::abs(x) - (half_width - corner_radius);
    const double dy = std::abs(y) - (half_height - corner_radius);
    return std::hypot((std::max)(dx, 0.), (std::max)(dy, 0.)) + (std::min)((std::max)(dx, dy), 0.) -
           corner_radius;
  }

  /// the distance to one rectangle around the full rows and one around all rows as wide as the
  /// short ones.
  double outline(double x, double y) const {
    const double columns = static_cast<double>(rows_.columns());
    const double full =
        rectangle(x, y - (full_rows_ - 1.) / 2., columns / 2. + margin, full_rows_ / 2. + margin);
    if(short_rows_ == 0.)
      return full;
    const double all = full_rows_ + short_rows_;
    return (std::min)(
        full, rectangle(x, y - (all - 1.) / 2., (columns - 1.) / 2. + margin, all / 2. + margin));
  }

  /// the distance into the nearest hole, negative outside of it.
  double hole(double x, double y) const {
    double nearest = std::numeric_limits<double>::infinity();
    const double last_row = static_cast<double>(rows_.rows()) - 1.;
    for(const double beside : {std::floor(y), std::floor(y) + 1.}) {
      const double row = std::clamp(beside, 0., last_row);
      const double count = static_cast<double>(rows_.holes_in_row(static_cast<std::size_t>(row)));
      if(count == 0.)
        continue;
      const double half = (count - 1.) / 2.;
      const double centre = std::clamp(std::round(x + half), 0., count - 1.) - half;
      nearest = (std::min)(nearest, std::hypot(x - centre, y - row));
    }
    return hole_radius - nearest;
  }

  Hole_rows rows_;
  double full_rows_, short_rows_;
};

Soup make_multi_torus(const Request& request) {
  require_faces(request, "multi-torus", 200 + 200 * request.genus);
  return mesh_of_field(Slab(request.genus), request, "multi-torus");
}

} // namespace

const Kind multi_torus_kind = {
    "multi-torus",
    "a flat rounded slab with a hole for each handle; any genus g, from 200 + 200 g faces",
    make_multi_torus};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
