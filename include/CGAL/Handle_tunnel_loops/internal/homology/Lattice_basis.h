// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LATTICE_BASIS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LATTICE_BASIS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Unimodular_system.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

// Without those that are zero.
inline void remove_zeros(std::vector<Class_vector>& rows) {
  rows.erase(std::remove_if(rows.begin(), rows.end(), [](const auto& v) { return v.empty(); }),
             rows.end());
}

// Has only the first of rows, none of them zero, begin in the first column, by Euclid's algorithm.
// Returns `false` if a number became too large.
inline bool make_echelon_row(std::vector<Class_vector>& rows) {
  const auto is_smaller = [](const Class_vector& a, const Class_vector& b) {
    return std::make_pair(a.front().first, std::abs(a.front().second)) <
           std::make_pair(b.front().first, std::abs(b.front().second));
  };
  for(bool changed = true; changed;) {
    std::iter_swap(rows.begin(), std::min_element(rows.begin(), rows.end(), is_smaller));
    changed = false;
    const auto [column, least] = rows[0].front();
    for(std::size_t i = 1; i < rows.size(); ++i)
      if(rows[i].front().first == column) {
        if(!add_multiple(rows[i], -(rows[i].front().second / least), rows[0]))
          return false;
        changed = changed || (!rows[i].empty() && rows[i].front().first == column);
      }
    remove_zeros(rows);
  }
  return true;
}

/// a basis of the lattice that vectors span; nothing if a number became too large. Vectors are
/// taken as they are, the smallest first, as long as elimination by those taken before leaves a 1
/// or -1 in them, which is to say nearly always; what is left is brought to echelon form.
inline std::optional<std::vector<Class_vector>>
lattice_basis(std::vector<Class_vector> generators) {
  const auto size = [](const Class_vector& v) {
    return std::accumulate(
        v.begin(), v.end(), std::int64_t(0),
        [](std::int64_t sum, const auto& c) { return sum + std::abs(c.second); });
  };
  std::stable_sort(generators.begin(), generators.end(),
                   [&](const auto& a, const auto& b) { return size(a) < size(b); });
  std::vector<Class_vector> basis, rest;
  std::vector<std::pair<Index, Class_vector>> pivots; // columns, and rows
  const auto reduce = [&](Class_vector& v) {
    return std::all_of(pivots.begin(), pivots.end(), [&](const auto& pivot) {
      const auto& [column, row] = pivot;
      return add_multiple(v, -coordinate(v, column) * coordinate(row, column), row);
    });
  };
  for(Class_vector& v : generators) {
    Class_vector reduced = v;
    if(!reduce(reduced))
      return std::nullopt;
    const auto unit = std::find_if(reduced.begin(), reduced.end(),
                                   [](const auto& c) { return std::abs(c.second) == 1; });
    if(unit != reduced.end()) {
      pivots.emplace_back(unit->first, reduced);
      basis.push_back(std::move(v));
    } else
      rest.push_back(std::move(reduced));
  }
  for(Class_vector& v : rest)
    if(!reduce(v))
      return std::nullopt;
  remove_zeros(rest);
  while(!rest.empty()) {
    if(!make_echelon_row(rest))
      return std::nullopt;
    basis.push_back(std::move(rest.front()));
    rest.erase(rest.begin());
  }
  return basis;
}

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

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LATTICE_BASIS_H
