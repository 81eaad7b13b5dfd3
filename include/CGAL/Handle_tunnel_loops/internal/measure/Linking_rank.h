// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LINKING_RANK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LINKING_RANK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The linking numbers of a closed curve with loops that are not 0, by loop.
using Linking_row = std::vector<std::pair<Index, int>>;

/// adds up entries of the same loop.
inline void add_up(Linking_row& row) {
  std::sort(row.begin(), row.end());
  std::size_t size = 0;
  for(const auto& [loop, number] : row)
    if(size > 0 && row[size - 1].first == loop)
      row[size - 1].second += number;
    else
      row[size++] = {loop, number};
  row.resize(size);
  row.erase(std::remove_if(row.begin(), row.end(), [](const auto& e) { return e.second == 0; }),
            row.end());
}

/// Rows that are independent over the rationals, as they are so modulo a prime. (That others are
/// not is as likely to be wrong as a determinant is to be divisible by it.)
class Linking_rank
{
public:
  std::size_t size() const { return rows_.size(); }

  /// adds a row if it is independent of the others.
  bool add(const Linking_row& row) {
    Row rest;
    for(const auto& [loop, number] : row)
      rest.emplace_back(loop, modulo(static_cast<Number>(std::int64_t(number))));
    while(!rest.empty()) {
      const auto known = rows_.find(rest.front().first);
      if(known == rows_.end()) {
        divide(rest);
        const Index first = rest.front().first;
        rows_.emplace(first, std::move(rest));
        return true;
      }
      rest = difference(rest, known->second);
    }
    return false;
  }

  using Number = std::uint64_t;
  static constexpr Number prime = 2147483647;

  /// a number of a class, or a sum of such, as the remainder of a division by the prime.
  static Number modulo(Number x) {
    const auto p = static_cast<std::int64_t>(prime);
    const std::int64_t rest = static_cast<std::int64_t>(x) % p;
    return static_cast<Number>(rest < 0 ? rest + p : rest);
  }

  /// random numbers for the loops, which add up to 0, each times the entry of a row, for the rows
  /// that were added, and so for all that depend on them.
  std::vector<Number> numbers_without_sum(std::size_t number_of_loops) const {
    std::mt19937_64 random;
    std::vector<Number> numbers(number_of_loops);
    for(Number& x : numbers)
      x = random() % prime;
    for(auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
      Number sum = 0;
      for(auto entry = row->second.begin() + 1; entry != row->second.end(); ++entry)
        sum = (sum + entry->second * numbers[entry->first]) % prime;
      numbers[row->first] = (prime - sum) % prime;
    }
    return numbers;
  }

private:
  using Row = std::vector<std::pair<Index, Number>>; // without zeros, by loop

  static Number inverse(Number x) {
    Number power = 1;
    for(Number exponent = prime - 2; exponent > 0; exponent >>= 1, x = x * x % prime)
      if((exponent & 1) != 0)
        power = power * x % prime;
    return power;
  }

  // So that the first entry is 1.
  static void divide(Row& row) {
    const Number factor = inverse(row.front().second);
    for(auto& entry : row)
      entry.second = entry.second * factor % prime;
  }

  // Of a row and the multiple of another that has the same first entry.
  static Row difference(const Row& row, const Row& other) {
    const Number factor = prime - row.front().second;
    Row sum;
    auto a = row.begin() + 1;
    for(auto b = other.begin() + 1; b != other.end(); ++b) {
      for(; a != row.end() && a->first < b->first; ++a)
        sum.push_back(*a);
      Number x = factor * b->second % prime;
      if(a != row.end() && a->first == b->first)
        x = (x + (a++)->second) % prime;
      if(x != 0)
        sum.emplace_back(b->first, x);
    }
    sum.insert(sum.end(), a, row.end());
    return sum;
  }

  std::map<Index, Row> rows_; // by their first loop
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LINKING_RANK_H
