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

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SPARSE_MATRIX_H
