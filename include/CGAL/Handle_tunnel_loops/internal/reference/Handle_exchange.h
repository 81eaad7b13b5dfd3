// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_HANDLE_EXCHANGE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_HANDLE_EXCHANGE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/assertions.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/*!
Which handles may be replaced by other loops, so that the loops remain a basis.

The first handles h_j do not cross each other, and tunnel t_i crosses handle i once and none with a
larger number: the matrix A of the numbers t_i . h_j is triangular, with units on its diagonal. So
h_1 .. h_g, t_1 .. t_g is a basis of the first homology group, and a loop x has coordinates in it:
x = sum a_i h_i + sum b_i t_i, where x . h_j gives the b_i, and x . t_j then the a_i, by
substitution. The tunnels stay; loops in the place of the handles complete them to a basis if and
only if the matrix of their a_i has the determinant one or minus one.

All numbers are integers of any size.
*/
class Handle_exchange
{
public:
  using Integer = boost::multiprecision::cpp_int;
  using Row = std::vector<Integer>;
  using Numbers = std::vector<int>;

  /// `with_handles[i][j]` is t_i . h_j, `with_tunnels[i][j]` is t_i . t_j.
  Handle_exchange(std::vector<Numbers> with_handles, std::vector<Numbers> with_tunnels)
      : a_(std::move(with_handles))
      , t_(std::move(with_tunnels))
      , inverse_(a_.size(), Row(a_.size(), 0)) {
    for(std::size_t i = 0; i < a_.size(); ++i) {
      CGAL_precondition_msg(std::abs(a_[i][i]) == 1, "a tunnel crosses its handle once");
      inverse_[i][i] = 1;
    }
  }

  /// replaces handle `k` by the loop x with the given intersection numbers x . h_j and x . t_j if
  /// the loops remain a basis, and says so.
  bool replace(std::size_t k, const Numbers& with_handles, const Numbers& with_tunnels) {
    const Row x = times_inverse(handle_part(with_handles, with_tunnels));
    if(x[k] != 1 && x[k] != -1)
      return false;
    // x is the row in terms of the present rows; row k is what it is exchanged for.
    for(Row& row : inverse_) {
      row[k] *= x[k];
      for(std::size_t i = 0; i < row.size(); ++i)
        if(i != k && x[i] != 0)
          row[i] -= row[k] * x[i];
    }
    return true;
  }

private:
  Row handle_part(const Numbers& with_handles, const Numbers& with_tunnels) const {
    const std::size_t g = a_.size();
    // x . h_j = sum over i >= j of b_i A_ij: the last one first.
    Row b(g, 0);
    for(std::size_t j = g; j-- > 0;) {
      Integer rest = with_handles[j];
      for(std::size_t i = j + 1; i < g; ++i)
        if(a_[i][j] != 0)
          rest -= b[i] * a_[i][j];
      b[j] = rest * a_[j][j];
    }
    // x . t_j - sum b_i (t_i . t_j) = sum over i <= j of a_i (h_i . t_j) = - sum a_i A_ji.
    Row a(g, 0);
    for(std::size_t j = 0; j < g; ++j) {
      Integer rest = with_tunnels[j];
      for(std::size_t i = 0; i < g; ++i)
        if(t_[i][j] != 0)
          rest -= b[i] * t_[i][j];
      for(std::size_t i = 0; i < j; ++i)
        if(a_[j][i] != 0)
          rest += a[i] * a_[j][i];
      a[j] = -rest * a_[j][j];
    }
    return a;
  }

  Row times_inverse(const Row& row) const {
    Row product(row.size(), 0);
    for(std::size_t i = 0; i < row.size(); ++i)
      if(row[i] != 0)
        for(std::size_t j = 0; j < row.size(); ++j)
          product[j] += row[i] * inverse_[i][j];
    return product;
  }

  std::vector<Numbers> a_, t_;
  std::vector<Row> inverse_; // of the matrix of the handle parts
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_HANDLE_EXCHANGE_H
