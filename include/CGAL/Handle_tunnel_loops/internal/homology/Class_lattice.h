// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_LATTICE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_LATTICE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Unimodular_system.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

/*!
Makes vectors of a basis of a lattice shorter by multiples of others, each by that which helps most,
as Gauss does with two. A coordinate counts by the weight of its index.

What is added is a multiple of one vector to another, in integers, so that the lattice stays the
same; how much is decided by floating point. Each step takes a thousandth off a square of a length
at least, so that the steps are few: vectors that have nothing in common are not compared.
*/
class Lattice_reduction
{
public:
  /// changes the basis, which must outlive it.
  Lattice_reduction(std::vector<Class_vector>& basis, const std::vector<double>& weights)
      : basis_(basis)
      , weights_(weights)
      , products_(basis.size(), 0.) {
    for(Index k = 0; k < basis.size(); ++k) {
      squares_.push_back(square(basis[k]));
      enter(k);
    }
  }

  void reduce() {
    std::vector<Index> order(basis_.size());
    std::iota(order.begin(), order.end(), Index(0));
    for(bool is_any_shorter = true; is_any_shorter;) {
      std::stable_sort(order.begin(), order.end(),
                       [this](Index a, Index b) { return squares_[a] > squares_[b]; });
      is_any_shorter = false;
      for(Index k : order)
        while(shorten(k))
          is_any_shorter = true;
    }
  }

private:
  // A multiple of a vector, and by how much the square of a length falls if it is subtracted.
  struct Step
  {
    Index vector = no_index;
    double factor = 0., gain = 0.;
  };

  bool shorten(Index k) {
    constexpr double least_gain = 1e-3;
    const Step step = best_step(k);
    Class_vector shorter = basis_[k];
    if(step.gain <= least_gain * squares_[k] || std::abs(step.factor) > largest_coordinate ||
       !add_multiple(shorter, -static_cast<std::int64_t>(step.factor), basis_[step.vector]))
      return false;
    leave(k);
    basis_[k] = std::move(shorter);
    squares_[k] = square(basis_[k]);
    enter(k);
    return true;
  }

  Step best_step(Index k) {
    std::vector<Index> touched;
    for(const auto& [i, value] : basis_[k])
      for(const auto& [j, other] : columns_[i])
        if(j != k) {
          if(products_[j] == 0.)
            touched.push_back(j);
          products_[j] += weights_[i] * double(value) * double(other);
        }
    Step best;
    for(Index j : touched) {
      const double factor = std::rint(products_[j] / squares_[j]);
      const double gain = factor * (2. * products_[j] - factor * squares_[j]);
      if(gain > best.gain)
        best = {j, factor, gain};
      products_[j] = 0.;
    }
    return best;
  }

  double square(const Class_vector& v) const {
    double sum = 0.;
    for(const auto& [i, value] : v)
      sum += weights_[i] * double(value) * double(value);
    return sum;
  }

  void enter(Index k) {
    for(const auto& [i, value] : basis_[k])
      columns_[i].emplace_back(k, value);
  }

  void leave(Index k) {
    for(const auto& coordinate : basis_[k]) {
      auto& column = columns_[coordinate.first];
      column.erase(std::find_if(column.begin(), column.end(),
                                [k](const auto& entry) { return entry.first == k; }));
    }
  }

  std::vector<Class_vector>& basis_;
  const std::vector<double>& weights_; // by index
  // By index: vectors, and their values there.
  std::unordered_map<Index, std::vector<std::pair<Index, std::int64_t>>> columns_;
  std::vector<double> squares_, products_; // by vector
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_LATTICE_H
