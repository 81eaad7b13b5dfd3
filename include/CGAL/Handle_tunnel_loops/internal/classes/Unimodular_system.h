// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_UNIMODULAR_SYSTEM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_UNIMODULAR_SYSTEM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Class_vector.h>
#include <CGAL/Handle_tunnel_loops/internal/classes/prime_field.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
A sparse system of linear equations with an integer matrix of determinant 1 or -1, which has an
integer solution for each integer right side. It is factorized modulo a large prime: such a matrix
is regular modulo any, and no number grows. What is found is tried in the equations themselves, in
integers.

The next pivot is in a row with the fewest entries, and there in the column with the fewest
(Markowitz): for loops that cross few others, fill-in is small.
*/
class Unimodular_system
{
public:
  /// takes the rows of the matrix.
  explicit Unimodular_system(std::vector<Class_vector> rows)
      : rows_(std::move(rows)) {
    factorize();
  }

  /// whether the matrix is regular modulo the prime. If not, its determinant is not 1 or -1.
  bool is_regular() const { return steps_.size() == rows_.size(); }

  /// the solution x of A x = b; nothing if it has coordinates that are too large.
  std::optional<Class_vector> solve(const Class_vector& b) const {
    CGAL_precondition(is_regular());
    std::vector<Residue> values(rows_.size(), 0);
    for(const auto& [row, value] : b)
      values[row] = residue_of(value);
    eliminate(values);
    const std::vector<Residue> x = substitute(values);
    Class_vector solution;
    for(Index i = 0; i < x.size(); ++i)
      if(x[i] != 0) {
        const std::int64_t value = smallest_integer_of(x[i]);
        if(is_too_large(value))
          return std::nullopt;
        solution.emplace_back(i, value);
      }
    if(!solves(x, b))
      return std::nullopt;
    return solution;
  }

private:
  using Entry = std::pair<Index, Residue>; // column or row, and value
  using Row = std::vector<Entry>;          // by column

  struct Step
  {
    Index row, column;
    Residue inverse;  // of the pivot
    Row rest;         // of the row, columns whose pivots come later
    Row subtractions; // the rows from which multiples of this one were subtracted
  };

  void factorize() {
    std::vector<Row> rows(rows_.size());
    std::vector<std::set<Index>> columns(rows_.size());
    std::set<std::pair<std::size_t, Index>> by_size;
    for(Index r = 0; r < rows_.size(); ++r) {
      for(const auto& [column, value] : rows_[r]) {
        rows[r].emplace_back(column, residue_of(value));
        columns[column].insert(r);
      }
      by_size.emplace(rows[r].size(), r);
    }
    while(!by_size.empty()) {
      const Index r = by_size.begin()->second;
      by_size.erase(by_size.begin());
      if(rows[r].empty())
        return;
      eliminate_with(r, rows, columns, by_size);
    }
  }

  void eliminate_with(Index r,
                      std::vector<Row>& rows,
                      std::vector<std::set<Index>>& columns,
                      std::set<std::pair<std::size_t, Index>>& by_size) {
    Step step;
    step.rest = std::move(rows[r]);
    const auto pivot =
        std::min_element(step.rest.begin(), step.rest.end(), [&](const Entry& a, const Entry& b) {
          return columns[a.first].size() < columns[b.first].size();
        });
    step.row = r;
    step.column = pivot->first;
    step.inverse = inverse(pivot->second);
    step.rest.erase(pivot);
    for(const Entry& e : step.rest)
      columns[e.first].erase(r);
    columns[step.column].erase(r);
    for(Index other : columns[step.column]) {
      by_size.erase({rows[other].size(), other});
      const auto entry =
          std::lower_bound(rows[other].begin(), rows[other].end(), Entry(step.column, 0));
      const Residue factor = product(entry->second, step.inverse);
      rows[other].erase(entry);
      step.subtractions.emplace_back(other, factor);
      subtract(rows[other], other, factor, step.rest, columns);
      by_size.emplace(rows[other].size(), other);
    }
    columns[step.column].clear();
    steps_.push_back(std::move(step));
  }

  static void subtract(Row& row,
                       Index number,
                       Residue factor,
                       const Row& other,
                       std::vector<std::set<Index>>& columns) {
    Row result;
    auto a = row.begin();
    for(const Entry& e : other) {
      for(; a != row.end() && a->first < e.first; ++a)
        result.push_back(*a);
      const bool is_there = a != row.end() && a->first == e.first;
      const Residue value = difference(is_there ? (a++)->second : 0, product(factor, e.second));
      if(value != 0)
        result.emplace_back(e.first, value);
      if(value != 0 && !is_there)
        columns[e.first].insert(number);
      if(value == 0 && is_there)
        columns[e.first].erase(number);
    }
    result.insert(result.end(), a, row.end());
    row = std::move(result);
  }

  void eliminate(std::vector<Residue>& values) const {
    for(const Step& step : steps_)
      if(values[step.row] != 0)
        for(const auto& [row, factor] : step.subtractions)
          values[row] = difference(values[row], product(factor, values[step.row]));
  }

  std::vector<Residue> substitute(const std::vector<Residue>& values) const {
    std::vector<Residue> x(rows_.size(), 0);
    for(auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
      Residue sum = values[step->row];
      for(const auto& [column, value] : step->rest)
        if(x[column] != 0)
          sum = difference(sum, product(value, x[column]));
      x[step->column] = product(sum, step->inverse);
    }
    return x;
  }

  bool solves(const std::vector<Residue>& x, const Class_vector& b) const {
    for(Index r = 0; r < rows_.size(); ++r) {
      std::int64_t sum = -coordinate(b, r);
      for(const auto& [column, value] : rows_[r])
        sum += value * smallest_integer_of(x[column]);
      if(sum != 0)
        return false;
    }
    return true;
  }

  std::vector<Class_vector> rows_;
  std::vector<Step> steps_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_UNIMODULAR_SYSTEM_H
