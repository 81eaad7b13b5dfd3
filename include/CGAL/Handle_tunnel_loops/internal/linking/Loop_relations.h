// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_RELATIONS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_RELATIONS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Sparse_matrix.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// How the loops of a family lie with respect to each other and to the solid.
struct Loop_relations
{
  /// how often loop i crosses loop j from right to left, less the other way.
  Sparse_matrix intersections;

  /// the linking number of loop i with loop j pushed out of the solid; empty unless `is_linked`.
  Sparse_matrix linking;

  /// in words, by loop, why its linking numbers mean nothing.
  std::map<std::size_t, std::string> problems;

  /// by loop, the component on which it lies.
  std::vector<std::size_t> components;

  /// by loop, 1 if the faces along it look out of the solid, -1 if they look into it, 0 if there is
  /// none.
  std::vector<int> outward;

  bool is_linked = false;

  /// by loop, whether it bounds on the inner or on the outer side of its component, the other
  /// components taken away.
  std::vector<char> bounds_alone(bool inside) const {
    std::vector<char> bounds(components.size(), 1);
    for(const Matrix_entry& e : linking)
      if(components[e.row] == components[e.column])
        bounds[inside ? e.row : e.column] = 0;
    for(const auto& problem : problems)
      bounds[problem.first] = 0;
    return bounds;
  }

  /// changes the numbers of the loops: number i is what had number `before[i]`.
  void renumber(const std::vector<Index>& before) {
    std::vector<Index> now(before.size());
    for(Index i = 0; i < before.size(); ++i)
      now[before[i]] = i;
    for(Sparse_matrix* matrix : {&intersections, &linking}) {
      for(Matrix_entry& e : *matrix)
        e = {now[e.row], now[e.column], e.value};
      std::sort(matrix->begin(), matrix->end());
    }
    std::map<std::size_t, std::string> renumbered;
    for(auto& problem : problems)
      renumbered.emplace(now[problem.first], std::move(problem.second));
    problems = std::move(renumbered);
    const std::vector<std::size_t> components_before = components;
    const std::vector<int> outward_before = outward;
    for(std::size_t i = 0; i < before.size(); ++i) {
      components[i] = components_before[before[i]];
      outward[i] = outward_before[before[i]];
    }
  }
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_LOOP_RELATIONS_H
