// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_CLASS_EXCHANGE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_CLASS_EXCHANGE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Loop_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/classes/Pairing.h>

#include <CGAL/assertions.h>

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
A basis of loops in which one after the other is replaced.

Replacing a loop by a curve gives a basis again exactly if the coordinate of the curve on that loop
is 1 or -1. The coordinates in the first basis are known from intersection numbers; each exchange
changes those in the present basis by a multiple of one column.
*/
class Class_exchange
{
public:
  explicit Class_exchange(const Loop_classes& classes)
      : classes_(classes)
      , is_replaced_(classes.size(), 0) {
    for(Index i = 0; i < classes.size(); ++i)
      members_.push_back({{i, 1}});
  }

  /// the coordinates in the present basis of a class that is given in the first one, unless a
  /// number is too large.
  std::optional<Class_vector> coordinates(Class_vector a) const {
    for(const Exchange& e : exchanges_) {
      const std::int64_t x = coordinate(a, e.index);
      if(x == 0)
        continue;
      // z_k = e (z_k' - sum of the other x_j z_j)
      if(!add_multiple(a, -x * e.unit, e.coordinates) ||
         !add_multiple(a, 1, {{e.index, x * e.unit}}))
        return std::nullopt;
    }
    return a;
  }

  /// replaces member `k` by the class with these coordinates in the first basis and in the present
  /// one.
  void replace(Index k, const Class_vector& first, const Class_vector& present) {
    const std::int64_t unit = coordinate(present, k);
    CGAL_precondition(std::abs(unit) == 1);
    members_[k] = first;
    if(is_replaced_[k] == 0)
      replaced_.push_back(k);
    is_replaced_[k] = 1;
    if(present.size() > 1 || unit != 1)
      exchanges_.push_back({k, unit, present});
  }

  /// the intersection number of a class, given by its numbers with the first basis, with a member.
  std::int64_t crossing(const Class_vector& numbers, Index member) const {
    return product_sum(numbers, members_[member]);
  }

  /// the pairs whose tunnel a class crosses once, given by its numbers with the first basis.
  std::vector<Index> tunnels_crossed_once(const Class_vector& numbers) const {
    std::vector<Index> found;
    for(const auto& [i, value] : numbers)
      if(i % 2 == 1 && is_replaced_[i] == 0 && std::abs(value) == 1)
        found.push_back(i / 2);
    for(Index i : replaced_)
      if(i % 2 == 1 && std::abs(crossing(numbers, i)) == 1)
        found.push_back(i / 2);
    std::sort(found.begin(), found.end());
    return found;
  }

  /// the intersection numbers of a member with the first basis.
  Class_vector numbers(Index member) const { return classes_.numbers_of_class(members_[member]); }

private:
  struct Exchange
  {
    Index index;
    std::int64_t unit;
    Class_vector coordinates;
  };

  const Loop_classes& classes_;
  std::vector<Class_vector> members_; // in the first basis
  std::vector<Index> replaced_;
  std::vector<char> is_replaced_; // by member
  std::vector<Exchange> exchanges_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_CLASS_EXCHANGE_H
