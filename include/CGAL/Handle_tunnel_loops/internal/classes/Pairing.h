// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PAIRING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PAIRING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A matching between as many rows as columns, by augmenting paths: what is matched stays matched,
/// with others if need be.
class Pairing
{
public:
  explicit Pairing(std::size_t n)
      : column_of_(n, no_index)
      , row_of_(n, no_index) {}

  Index column_of(Index row) const { return column_of_[row]; }
  Index row_of(Index column) const { return row_of_[column]; }

  void match(Index row, Index column) {
    column_of_[row] = column;
    row_of_[column] = row;
  }

  void release(Index row) {
    if(column_of_[row] != no_index)
      row_of_[column_of_[row]] = no_index;
    column_of_[row] = no_index;
  }

  /// matches a row that is not. \p columns gives the columns that a row may be matched with, the
  /// preferred ones first. Returns `false`, and changes nothing, if there is no way.
  template <typename Columns> bool augment(Index row, const Columns& columns) {
    std::vector<char> is_tried(column_of_.size(), 0);
    return augment(row, columns, is_tried);
  }

private:
  template <typename Columns>
  bool augment(Index row, const Columns& columns, std::vector<char>& is_tried) {
    const std::vector<Index> candidates = columns(row);
    for(Index c : candidates)
      if(row_of_[c] == no_index) {
        match(row, c);
        return true;
      }
    for(Index c : candidates)
      if(!is_tried[c]) {
        is_tried[c] = 1;
        if(augment(row_of_[c], columns, is_tried)) {
          match(row, c);
          return true;
        }
      }
    return false;
  }

  std::vector<Index> column_of_, row_of_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_PAIRING_H
