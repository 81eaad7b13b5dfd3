// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_NORMALS_AROUND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_NORMALS_AROUND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The normals, as long as the areas, of the faces just beyond a border.
class Normals_around
{
  using Vector = Surgery_mesh::Kernel::Vector_3;

public:
  Normals_around(const Surgery_mesh& mesh, const Cut_region& region) {
    for(Index h : region.border(0)) {
      const Surgery_mesh::Face& c = mesh.corners(mesh.face(mesh.twin(h)));
      normals_.push_back(CGAL::normal(mesh.point(c[0]), mesh.point(c[1]), mesh.point(c[2])));
      sum_ = sum_ + normals_.back();
      sum_of_areas_ += std::sqrt(normals_.back().squared_length());
    }
  }

  /// whether each is within 60 degrees of their mean.
  bool are_alike() const {
    return std::all_of(normals_.begin(), normals_.end(), [&](const Vector& n) {
      const double product = n * sum_;
      return product > 0. && 4. * product * product >= n.squared_length() * sum_.squared_length();
    });
  }

  /// whether they do not all but cancel.
  bool have_a_direction() const { return 2. * std::sqrt(sum_.squared_length()) >= sum_of_areas_; }

private:
  std::vector<Vector> normals_;
  Vector sum_ = CGAL::NULL_VECTOR;
  double sum_of_areas_ = 0.;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_NORMALS_AROUND_H
