// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_UNIT_BOX_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_UNIT_BOX_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Moves and scales points into the unit box, by the same factor along all axes.
class Unit_box
{
public:
  Unit_box(Execution execution, const Uninitialized_vector<Vector>& points) {
    constexpr std::size_t grain = 65536;
    std::vector<Bounds> parts((points.size() + grain - 1) / grain);
    execution.for_ranges(points.size(), grain, [&](std::size_t begin, std::size_t end) {
      Bounds bounds;
      for(std::size_t i = begin; i < end; ++i)
        bounds.extend(points[i], points[i]);
      parts[begin / grain] = bounds;
    });
    Bounds all;
    for(const Bounds& part : parts)
      all.extend(part.low, part.high);
    low_ = all.low;
    for(int d = 0; d < 3; ++d)
      half_ = (std::max)(half_, half_difference(all.high[d], all.low[d]));
    if(half_ == 0.)
      half_ = 0.5;
  }

  /// half of the caller's unit of length / that of the box: the whole may be beyond all doubles.
  double half_scale() const { return half_; }

  Vector operator()(const Vector& p) const {
    Vector q;
    for(int d = 0; d < 3; ++d)
      q[d] = half_difference(p[d], low_[d]) / half_;
    return q;
  }

private:
  struct Bounds
  {
    static constexpr double most = (std::numeric_limits<double>::max)();
    Vector low = {most, most, most}, high = {-most, -most, -most};

    void extend(const Vector& l, const Vector& h) {
      for(int d = 0; d < 3; ++d) {
        low[d] = (std::min)(low[d], l[d]);
        high[d] = (std::max)(high[d], h[d]);
      }
    }
  };

  Vector low_;
  double half_ = 0.;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_UNIT_BOX_H
