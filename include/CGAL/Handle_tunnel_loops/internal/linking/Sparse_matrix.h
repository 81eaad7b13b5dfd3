// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SPARSE_MATRIX_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SPARSE_MATRIX_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

struct Matrix_entry
{
  Index row, column;
  std::int64_t value;

  bool is_beside(const Matrix_entry& e) const { return row == e.row && column == e.column; }
  bool operator<(const Matrix_entry& e) const {
    return row != e.row ? row < e.row : column < e.column;
  }
};

/// An integer matrix: its entries by row and, within a row, by column; no zeros.
using Sparse_matrix = std::vector<Matrix_entry>;

/// sorts entries, adds up those at the same place, and leaves out zeros.
inline void add_up(std::vector<Matrix_entry>& entries) {
  std::sort(entries.begin(), entries.end());
  std::size_t kept = 0;
  for(std::size_t i = 0; i < entries.size();) {
    Matrix_entry sum = entries[i];
    for(++i; i < entries.size() && entries[i].is_beside(sum); ++i)
      sum.value += entries[i].value;
    if(sum.value != 0)
      entries[kept++] = sum;
  }
  entries.resize(kept);
}

/// whether a matrix is its transpose with the other sign. Logarithmic time for each entry.
inline bool is_antisymmetric(const Sparse_matrix& matrix) {
  CGAL_precondition(std::is_sorted(matrix.begin(), matrix.end()));
  return std::all_of(matrix.begin(), matrix.end(), [&](const Matrix_entry& e) {
    const Matrix_entry transposed = {e.column, e.row, -e.value};
    const auto it = std::lower_bound(matrix.begin(), matrix.end(), transposed);
    return it != matrix.end() && it->is_beside(transposed) && it->value == transposed.value;
  });
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SPARSE_MATRIX_H
