// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_HOLE_ROWS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_HOLE_ROWS_H

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// A number of holes in rows, as close to a square as it goes: the first rows have one hole more
/// than the others if the number does not divide.
class Hole_rows
{
public:
  explicit Hole_rows(std::size_t holes)
      : rows_(static_cast<std::size_t>(std::lround(std::sqrt(double(holes)))))
      , holes_(holes) {
    rows_ = (std::max<std::size_t>)(rows_, 1);
  }

  std::size_t rows() const { return rows_; }

  /// of the longest rows; at least one, as if for a hole that is not there.
  std::size_t columns() const { return (std::max<std::size_t>)((holes_ + rows_ - 1) / rows_, 1); }

  /// the number of rows that have `columns()` holes.
  std::size_t full_rows() const { return holes_ % rows_ == 0 ? rows_ : holes_ % rows_; }

  std::size_t holes_in_row(std::size_t row) const {
    return holes_ / rows_ + (row < holes_ % rows_ ? 1 : 0);
  }

private:
  std::size_t rows_, holes_;
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_HOLE_ROWS_H
