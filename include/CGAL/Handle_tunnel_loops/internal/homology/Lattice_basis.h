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
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Chooses a basis of the lattice that vectors span. Vectors are taken as they are, the smallest first,
as long as elimination by those taken before leaves a 1 or -1 in them, which is to say nearly
always; what is left is brought to echelon form by Euclid's algorithm.
*/
class Lattice_basis
{
public:
  explicit Lattice_basis(std::vector<Class_vector> generators) {
    std::stable_sort(
        generators.begin(), generators.end(),
        [](const Class_vector& a, const Class_vector& b) { return size(a) < size(b); });
    std::vector<Class_vector> rest;
    for(Class_vector& v : generators) {
      Class_vector reduced = v;
      is_exact_ = is_exact_ && reduce(reduced);
      if(!take(v, reduced) && !reduced.empty())
        rest.push_back(std::move(reduced));
    }
    for(Class_vector& v : rest)
      is_exact_ = is_exact_ && reduce(v);
    while(is_exact_ && !rest.empty())
      take_echelon_row(rest);
  }

  /// the basis; nothing if a number became too large.
  std::optional<std::vector<Class_vector>> take_basis() {
    if(!is_exact_)
      return std::nullopt;
    return std::move(basis_);
  }

private:
  struct Pivot
  {
    Index column;
    Class_vector row;
  };

  static std::int64_t size(const Class_vector& v) {
    std::int64_t sum = 0;
    for(const auto& entry : v)
      sum += std::abs(entry.second);
    return sum;
  }

  bool reduce(Class_vector& v) const {
    for(const Pivot& p : pivots_)
      if(!add_multiple(v, -coordinate(v, p.column) * coordinate(p.row, p.column), p.row))
        return false;
    return true;
  }

  bool take(const Class_vector& v, const Class_vector& reduced) {
    const auto unit = std::find_if(reduced.begin(), reduced.end(),
                                   [](const auto& entry) { return std::abs(entry.second) == 1; });
    if(unit == reduced.end())
      return false;
    pivots_.push_back({unit->first, reduced});
    basis_.push_back(v);
    return true;
  }

  // The lattice of all rows that begin in the first column gives one row, and others without it.
  void take_echelon_row(std::vector<Class_vector>& rows) {
    const auto leading = [](const Class_vector& v) { return v.front().first; };
    rows.erase(std::remove_if(rows.begin(), rows.end(), [](const auto& v) { return v.empty(); }),
               rows.end());
    if(rows.empty())
      return;
    const auto smallest = [&] {
      return std::min_element(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
        return std::make_pair(leading(a), std::abs(a.front().second)) <
               std::make_pair(leading(b), std::abs(b.front().second));
      });
    };
    for(bool changed = true; changed && is_exact_;) {
      std::iter_swap(rows.begin(), smallest());
      changed = false;
      for(std::size_t i = 1; i < rows.size() && is_exact_; ++i)
        if(!rows[i].empty() && leading(rows[i]) == leading(rows[0])) {
          is_exact_ =
              add_multiple(rows[i], -(rows[i].front().second / rows[0].front().second), rows[0]);
          changed = changed || (!rows[i].empty() && leading(rows[i]) == leading(rows[0]));
        }
      rows.erase(
          std::remove_if(rows.begin() + 1, rows.end(), [](const auto& v) { return v.empty(); }),
          rows.end());
    }
    basis_.push_back(std::move(rows.front()));
    rows.erase(rows.begin());
  }

  std::vector<Pivot> pivots_;
  std::vector<Class_vector> basis_;
  bool is_exact_ = true; // no number has become too large
};

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
