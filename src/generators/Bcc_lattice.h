// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_BCC_LATTICE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_BCC_LATTICE_H

#include "Field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// A step from a point of the lattice to another.
struct Lattice_step
{
  int column, row, slice;
};

/*!
The part of a body-centred cubic lattice that lies in a box, with integer coordinates in which the
lattice's tetrahedra are those of Kuhn's subdivision of a cube: with the basis a1 = (-1, 1, 1) / 2,
a2 = (1, -1, 1) / 2, a3 = (1, 1, -1) / 2, the tetrahedra at a point are the six paths to the
opposite corner a1 + a2 + a3 of its cell. Corner `c` of a cell is the sum of the basis vectors whose
bits are set in `c`.

A point has a slice and a row, its coordinates along a3 and a2, and a column, which counts along a1
from where the row enters the box: so columns run over a range that is the same for all rows.
*/
class Bcc_lattice
{
public:
  Bcc_lattice(const Box& box, double spacing)
      : origin_(box.low - Vector(1, 1, 1) * spacing)
      , spacing_(spacing) {
    for(int c = 0; c < 3; ++c)
      size_[c] = static_cast<int>(std::ceil((box.high[c] - origin_[c]) / spacing)) + 1;
  }

  int columns() const { return 2 * size_[2] + 1; }
  int rows() const { return size_[0] + size_[2] + 1; }
  int slices() const { return size_[0] + size_[1] + 1; }

  /// the length of a step along a row.
  double column_length() const { return spacing_ * std::sqrt(3.) / 2.; }

  Vector point(int column, int row, int slice) const {
    return origin_ + displacement({column, row, slice}) * spacing_;
  }

  /// where a step leads, in units of the spacing.
  static Vector displacement(const Lattice_step& step) {
    const double z = step.column / 2.;
    return Vector(step.row - z, step.slice - step.row + z, z);
  }

  /// the columns of a row that lie in the box: from the first to, and without, the second.
  std::pair<int, int> columns_inside(int row, int slice) const {
    const int first = (std::max)({0, 2 * (row - size_[0]), 2 * (row - slice)});
    const int last = (std::min)({2 * size_[2], 2 * row, 2 * (size_[1] + row - slice)});
    return {first, last + 1};
  }

  /// the step from a corner 0 to corner `c`.
  static constexpr Lattice_step step_to_corner(int c) {
    const int a1 = c & 1, a2 = (c >> 1) & 1, a3 = (c >> 2) & 1;
    return {a1 + a2 - a3, a2, a3};
  }

private:
  Vector origin_;
  double spacing_;
  std::array<int, 3> size_; ///< of the box, in cubes
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_BCC_LATTICE_H
