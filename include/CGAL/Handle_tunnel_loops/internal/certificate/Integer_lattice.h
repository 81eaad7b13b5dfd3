// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_INTEGER_LATTICE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_INTEGER_LATTICE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/assertions.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The lattice spanned by integer vectors, kept as sparse rows in echelon form. Integers have any
/// size. Short rows added first keep the form sparse.
class Integer_lattice
{
public:
  using Integer = boost::multiprecision::cpp_int;
  using Row = std::map<std::size_t, Integer>; // no zeros

  explicit Integer_lattice(std::size_t dimension)
      : rows_(dimension) {}

  void add(Row row) {
    CGAL_precondition(row.empty() || row.rbegin()->first < rows_.size());
    while(!row.empty()) {
      const std::size_t column = row.begin()->first;
      Row& pivot = rows_[column];
      number_of_units_ -= is_unit(pivot);
      if(pivot.empty())
        std::swap(row, pivot);
      // Euclid's algorithm on the leading entries.
      while(!row.empty() && row.begin()->first == column) {
        subtract_multiple(row, Integer(row.begin()->second / pivot.begin()->second), pivot);
        if(!row.empty() && row.begin()->first == column)
          std::swap(row, pivot);
      }
      CGAL_assertion(!pivot.empty() && pivot.begin()->first == column);
      number_of_units_ += is_unit(pivot);
    }
  }

  /// whether the lattice is that of all integer vectors.
  bool is_full() const { return number_of_units_ == rows_.size(); }

  /// the index of the lattice in the lattice of all integer vectors, 0 if that is infinite.
  Integer index() const {
    Integer product = 1;
    for(const Row& row : rows_)
      product *=
          row.empty() ? Integer(0) : Integer(boost::multiprecision::abs(row.begin()->second));
    return product;
  }

  /// the first column in which the rows do not reach 1; the dimension if there is none.
  std::size_t first_defect() const {
    std::size_t column = 0;
    while(column < rows_.size() && is_unit(rows_[column]))
      ++column;
    return column;
  }

private:
  static bool is_unit(const Row& row) {
    return !row.empty() && (row.begin()->second == 1 || row.begin()->second == -1);
  }

  static void subtract_multiple(Row& row, const Integer& factor, const Row& other) {
    if(factor == 0)
      return;
    for(const auto& [column, value] : other) {
      const auto it = row.emplace(column, 0).first;
      it->second -= factor * value;
      if(it->second == 0)
        row.erase(it);
    }
  }

  std::vector<Row> rows_; // by leading column
  std::size_t number_of_units_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_INTEGER_LATTICE_H
