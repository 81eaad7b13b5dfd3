// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_UNIMODULAR_SYSTEM_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_UNIMODULAR_SYSTEM_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Sparse_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A number modulo the Mersenne prime 2^61 - 1.
using Residue = std::uint64_t;

constexpr Residue field_size = (Residue(1) << 61) - 1;

inline Residue difference(Residue a, Residue b) { return a >= b ? a - b : a + field_size - b; }

/// by halves, for not all compilers have integers of 128 bits.
inline Residue product(Residue a, Residue b) {
  // (a1 2^31 + a0) (b1 2^31 + b0), and 2^62 = 2
  constexpr Residue low = (Residue(1) << 31) - 1;
  const Residue a0 = a & low, a1 = a >> 31, b0 = b & low, b1 = b >> 31;
  const Residue middle = a1 * b0 + a0 * b1; // below 2^62
  const Residue middle_low = middle & ((Residue(1) << 30) - 1), middle_high = middle >> 30;
  const Residue result = 2 * a1 * b1 + middle_high + (middle_low << 31) + a0 * b0;
  const Residue folded = (result & field_size) + (result >> 61);
  return folded >= field_size ? folded - field_size : folded;
}

/// by Fermat's little theorem.
inline Residue inverse(Residue a) {
  Residue result = 1;
  for(Residue exponent = field_size - 2; exponent != 0; exponent >>= 1) {
    if((exponent & 1) != 0)
      result = product(result, a);
    a = product(a, a);
  }
  return result;
}

inline Residue residue_of(std::int64_t x) {
  const std::int64_t r = x % static_cast<std::int64_t>(field_size);
  return r < 0 ? field_size - static_cast<Residue>(-r) : static_cast<Residue>(r);
}

/// the integer of smallest size in a class.
inline std::int64_t smallest_integer_of(Residue a) {
  return a <= field_size / 2 ? static_cast<std::int64_t>(a)
                             : -static_cast<std::int64_t>(field_size - a);
}

/// A sparse vector of integers, sorted by index, without zeros: coordinates of a class in a basis,
/// or intersection numbers with one.
using Class_vector = std::vector<std::pair<Index, std::int64_t>>;

/// No factor and no coordinate of a sum of multiples is larger, so that products fit and sums of
/// them do.
constexpr std::int64_t largest_coordinate = std::int64_t(1) << 30;

inline bool is_too_large(std::int64_t x) {
  return x > largest_coordinate || x < -largest_coordinate;
}

/// the coordinate at an index.
inline std::int64_t coordinate(const Class_vector& v, Index i) {
  const auto it =
      std::lower_bound(v.begin(), v.end(), i, [](const auto& c, Index j) { return c.first < j; });
  return it != v.end() && it->first == i ? it->second : 0;
}

/// the sum of the products of coordinates at the same index.
inline std::int64_t product_sum(const Class_vector& v, const Class_vector& w) {
  std::int64_t sum = 0;
  for(const auto& [i, value] : w)
    sum += value * coordinate(v, i);
  return sum;
}

/// sums coordinates at the same index and leaves out zeros.
inline void normalize(Class_vector& v) {
  std::sort(v.begin(), v.end());
  std::size_t kept = 0;
  for(std::size_t i = 0; i < v.size();) {
    auto sum = v[i];
    for(++i; i < v.size() && v[i].first == sum.first; ++i)
      sum.second += v[i].second;
    if(sum.second != 0)
      v[kept++] = sum;
  }
  v.resize(kept);
}

/// a sparse vector, sorted by index, with others in place of the entries at the indices of `w`:
/// `f(index, before, value)`, where `before` is the entry of `v` or zero, `value` that of `w`.
template <typename Number, typename Function>
std::vector<std::pair<Index, Number>> combined(const std::vector<std::pair<Index, Number>>& v,
                                               const std::vector<std::pair<Index, Number>>& w,
                                               const Function& f) {
  std::vector<std::pair<Index, Number>> result;
  result.reserve(v.size() + w.size());
  auto a = v.begin();
  for(const auto& [index, value] : w) {
    for(; a != v.end() && a->first < index; ++a)
      result.push_back(*a);
    const Number before = a != v.end() && a->first == index ? (a++)->second : 0;
    if(const Number x = f(index, before, value); x != 0)
      result.emplace_back(index, x);
  }
  result.insert(result.end(), a, v.end());
  return result;
}

/// adds a multiple of another vector. Returns `false` if a coordinate becomes too large.
inline bool add_multiple(Class_vector& v, std::int64_t factor, const Class_vector& w) {
  if(factor == 0)
    return true;
  if(is_too_large(factor))
    return false;
  bool fits = true;
  Class_vector sum = combined(v, w, [&](Index, std::int64_t before, std::int64_t value) {
    const std::int64_t x = before + factor * value;
    fits = fits && !is_too_large(x);
    return x;
  });
  if(fits)
    v = std::move(sum);
  return fits;
}

/// the sum of multiples of vectors, by their indices.
inline Class_vector sum_of_multiples(const Class_vector& factors,
                                     const std::vector<Class_vector>& vectors,
                                     Sparse_sum<std::int64_t>& sum) {
  for(const auto& [i, factor] : factors)
    for(const auto& [k, value] : vectors[i])
      sum.add(k, factor * value);
  Class_vector result;
  sum.take([&](Index k, std::int64_t value) { result.emplace_back(k, value); });
  return result;
}

/*!
A sparse system of linear equations with an integer matrix of determinant 1 or -1, which has an
integer solution for each integer right side. It is factorized modulo a large prime: such a matrix
is regular modulo any, and no number grows. What is found is tried in the equations themselves, in
integers.

The next pivot is in a row with the fewest entries, and there in the column with the fewest
(Markowitz): for loops that cross few others, fill-in is small. To solve it takes time for what is
not zero on the way only, and the logarithm of that.
*/
class Unimodular_system
{
public:
  /// takes the rows of the matrix.
  explicit Unimodular_system(const std::vector<Class_vector>& rows)
      : columns_(rows.size())
      , values_([n = rows.size()] { return std::make_unique<Values>(n); })
      , sums_([] { return std::make_unique<Sparse_sum<std::int64_t>>(); }) {
    for(Index r = 0; r < rows.size(); ++r)
      for(const auto& [column, value] : rows[r])
        columns_[column].emplace_back(r, value);
    Elimination elimination(rows);
    while(steps_.size() < rows.size() && elimination.goes_on())
      steps_.push_back(elimination.next());
    if(is_regular())
      connect(elimination);
  }

  /// whether the matrix is regular modulo the prime. If not, its determinant is not 1 or -1.
  bool is_regular() const { return steps_.size() == columns_.size(); }

  /// the solution x of A x = b; nothing if it has coordinates that are too large.
  std::optional<Class_vector> solve(const Class_vector& b) const {
    Class_vector solution;
    bool fits = true;
    solve_modulo(b, [&](Index column, Residue x) {
      const std::int64_t value = smallest_integer_of(x);
      fits = fits && !is_too_large(value);
      if(value != 0)
        solution.emplace_back(column, value);
    });
    if(!fits)
      return std::nullopt;
    std::sort(solution.begin(), solution.end());
    if(!solves(solution, b))
      return std::nullopt;
    return solution;
  }

  /// calls `f(column, x)` for the solution modulo the prime, but for zeros, in no order.
  template <typename Function> void solve_modulo(const Class_vector& b, const Function& f) const {
    CGAL_precondition(is_regular());
    const auto values = values_.borrow();
    for(const auto& [row, value] : b)
      values->set(step_of_row_[row], residue_of(value));
    // What is subtracted from comes later.
    values->go_through(std::greater<Index>(),
                       [this](Index step, Residue&) -> const Row& { return steps_[step].later; });
    // ... and here earlier: the values become those of the columns.
    values->go_through(std::less<Index>(), [this](Index step, Residue& value) -> const Row& {
      value = product(value, steps_[step].inverse);
      return steps_[step].earlier;
    });
    values->take([&](Index step, Residue x) { f(steps_[step].column, x); });
  }

private:
  using Entry = std::pair<Index, Residue>; // column, row or step, and value
  using Row = std::vector<Entry>;

  struct Step
  {
    Index row, column;
    Residue inverse; // of the pivot
    Row later;       // the rows from which multiples of this one were subtracted, by their steps
    Row earlier;     // the entries of this column in the rows of other steps
  };

  // The rows, of which one after the other is taken out with its pivot.
  class Elimination
  {
  public:
    explicit Elimination(const std::vector<Class_vector>& all)
        : rows_(all.size())
        , columns_(all.size())
        , rests_(all.size()) {
      for(Index r = 0; r < all.size(); ++r) {
        for(const auto& [column, value] : all[r]) {
          rows_[r].emplace_back(column, residue_of(value));
          columns_[column].insert(r);
        }
        by_size_.emplace(rows_[r].size(), r);
      }
    }

    // Of a row that has been taken out, the columns whose pivots come later.
    const Row& rest(Index r) const { return rests_[r]; }

    bool goes_on() const { return !by_size_.empty() && by_size_.begin()->first != 0; }

    // A step with rows in the place of later steps, and without earlier ones.
    Step next() {
      const Index r = by_size_.begin()->second;
      by_size_.erase(by_size_.begin());
      Row rest = std::move(rows_[r]);
      const auto pivot =
          std::min_element(rest.begin(), rest.end(), [&](const Entry& a, const Entry& b) {
            return columns_[a.first].size() < columns_[b.first].size();
          });
      Step step = {r, pivot->first, inverse(pivot->second), {}, {}};
      rest.erase(pivot);
      for(const Entry& e : rest)
        columns_[e.first].erase(r);
      columns_[step.column].erase(r);
      for(Index other : columns_[step.column])
        step.later.emplace_back(other, subtract_from(other, step, rest));
      columns_[step.column].clear();
      rests_[r] = std::move(rest);
      return step;
    }

  private:
    // Returns the factor.
    Residue subtract_from(Index other, const Step& step, const Row& rest) {
      Row& row = rows_[other];
      by_size_.erase({row.size(), other});
      const auto entry = std::lower_bound(row.begin(), row.end(), Entry(step.column, 0));
      const Residue factor = product(entry->second, step.inverse);
      row.erase(entry);
      row = combined(row, rest, [&](Index column, Residue before, Residue value) {
        const Residue x = difference(before, product(factor, value));
        if(x != 0 && before == 0)
          columns_[column].insert(other);
        if(x == 0 && before != 0)
          columns_[column].erase(other);
        return x;
      });
      by_size_.emplace(row.size(), other);
      return factor;
    }

    std::vector<Row> rows_;
    std::vector<std::set<Index>> columns_; // the rows that have an entry there
    std::set<std::pair<std::size_t, Index>> by_size_;
    std::vector<Row> rests_; // by row
  };

  // Has steps know each other by their positions.
  void connect(const Elimination& elimination) {
    std::vector<Index> step_of_column(steps_.size());
    step_of_row_.resize(steps_.size());
    for(Index i = 0; i < steps_.size(); ++i) {
      step_of_row_[steps_[i].row] = i;
      step_of_column[steps_[i].column] = i;
    }
    for(Index i = 0; i < steps_.size(); ++i) {
      for(Entry& e : steps_[i].later)
        e.first = step_of_row_[e.first];
      for(const auto& [column, value] : elimination.rest(steps_[i].row))
        steps_[step_of_column[column]].earlier.emplace_back(i, value);
    }
  }

  // By step, most of them zero.
  class Values
  {
  public:
    explicit Values(std::size_t number_of_steps)
        : values_(number_of_steps, 0)
        , is_known_(number_of_steps, 0) {}

    void set(Index step, Residue value) {
      values_[step] = value;
      is_known_[step] = 1;
      to_do_.push_back(step);
    }

    // Goes through what is not zero, and what is no longer meanwhile, and subtracts multiples of
    // each, which `multiples_of(step, value)` tells, from what comes after it.
    template <typename Order, typename Function>
    void go_through(const Order& comes_after, const Function& multiples_of) {
      std::make_heap(to_do_.begin(), to_do_.end(), comes_after);
      while(!to_do_.empty()) {
        std::pop_heap(to_do_.begin(), to_do_.end(), comes_after);
        const Index step = to_do_.back();
        to_do_.pop_back();
        done_.push_back(step);
        const Row& multiples = multiples_of(step, values_[step]);
        if(const Residue factor = values_[step]; factor != 0)
          for(const auto& [other, value] : multiples) {
            if(is_known_[other] == 0) {
              set(other, 0);
              std::push_heap(to_do_.begin(), to_do_.end(), comes_after);
            }
            values_[other] = difference(values_[other], product(value, factor));
          }
      }
      to_do_.swap(done_);
    }

    // Calls `f(step, value)`, and sets all to zero.
    template <typename Function> void take(const Function& f) {
      for(const Index step : to_do_) {
        if(values_[step] != 0)
          f(step, values_[step]);
        values_[step] = 0;
        is_known_[step] = 0;
      }
      to_do_.clear();
    }

  private:
    std::vector<Residue> values_;
    std::vector<char> is_known_;
    std::vector<Index> to_do_, done_;
  };

  bool solves(const Class_vector& x, const Class_vector& b) const {
    const auto rest = sums_.borrow();
    for(const auto& [row, value] : b)
      rest->add(row, -value);
    for(const auto& [column, factor] : x)
      for(const auto& [row, value] : columns_[column])
        rest->add(row, factor * value);
    bool is_zero = true;
    rest->take([&](Index, std::int64_t) { is_zero = false; });
    return is_zero;
  }

  std::vector<Class_vector> columns_; // of the matrix: rows and values
  std::vector<Step> steps_;
  std::vector<Index> step_of_row_;
  mutable Workspace_pool<Values> values_;
  mutable Workspace_pool<Sparse_sum<std::int64_t>> sums_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_UNIMODULAR_SYSTEM_H
