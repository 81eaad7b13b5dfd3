// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFINEMENT_CHOICE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFINEMENT_CHOICE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/Crossing_index.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Chooses which handle loops can be replaced by their refinements so that the loops remain a basis.

Let h_i and t_i be the loops before. The handles are disjoint, and t_i crosses h_i once and no h_j with
j > i; so (h, t) is a basis, and the class of any curve x = sum of a_i h_i + b_i t_i follows from its
intersection numbers with the basis by two triangular substitutions. Replacing h_k for all k in a set S
gives a basis if and only if the matrix (a_i of the refinement of h_k), i and k in S, has determinant 1
or -1. The set is grown by elimination with pivots 1 and -1. All numbers are integers of any size.
*/
class Refinement_choice
{
public:
  using Integer = boost::multiprecision::cpp_int;
  using Row = std::map<Index, Integer>;

  Refinement_choice(const std::vector<Crossing_loop>& tunnels, const Crossing_index& handle_index,
                    const Crossing_index& tunnel_index)
    : tunnels_(tunnels)
    , handle_index_(handle_index)
    , tunnel_index_(tunnel_index)
    , crossed_handles_(tunnels.size())
    , crossing_tunnels_(tunnels.size())
    , place_(tunnels.size(), tunnels.size())
  {
    for(Index i = 0; i < tunnels.size(); ++i) {
      crossed_handles_[i] = handle_index.intersections(tunnels[i]);
      for(const auto& [j, number] : crossed_handles_[i])
        crossing_tunnels_[j][i] = number;
    }
  }

  /// whether handle `k` can be replaced by `refined`, besides those accepted before.
  bool accept(Index k, const Crossing_loop& refined)
  {
    Row row = handle_part(refined);
    for(std::size_t i = first_pivot(row); i < accepted_.size(); i = first_pivot(row))
      subtract_multiple(row, accepted_[i].first, accepted_[i].second);
    const auto it = row.find(k);
    if(it == row.end() || (it->second != 1 && it->second != -1))
      return false;
    place_[k] = accepted_.size();
    accepted_.emplace_back(k, std::move(row));
    return true;
  }

private:
  /// the coefficients a_i of the class of `loop`.
  Row handle_part(const Crossing_loop& loop) const
  {
    Row with_handles, with_tunnels;
    for(const auto& [j, number] : handle_index_.intersections(loop))
      with_handles[j] = number;
    for(const auto& [j, number] : tunnel_index_.intersections(loop))
      with_tunnels[j] = number;

    // b from the intersections with the handles, the last one first.
    while(!with_handles.empty()) {
      const auto [j, number] = *with_handles.rbegin();
      if(number == 0) {
        with_handles.erase(j);
        continue;
      }
      const Integer b = number * crossed_handles_[j].at(j);
      for(const auto& [i, crossing] : crossed_handles_[j])
        with_handles[i] -= b * crossing;
      for(const auto& [i, crossing] : tunnel_index_.intersections(tunnels_[j]))
        with_tunnels[i] -= b * crossing;
    }

    // a from what is left of the intersections with the tunnels, the first one first.
    Row a;
    while(!with_tunnels.empty()) {
      const auto [j, number] = *with_tunnels.begin();
      if(number == 0) {
        with_tunnels.erase(j);
        continue;
      }
      const Integer coefficient = -number * crossed_handles_[j].at(j);
      a[j] = coefficient;
      for(const auto& [i, crossing] : crossing_tunnels_[j])
        with_tunnels[i] += coefficient * crossing;
    }
    return a;
  }

  /// the first of the accepted rows whose pivot column is occupied; their number if none is.
  std::size_t first_pivot(const Row& row) const
  {
    std::size_t first = accepted_.size();
    for(const auto& [i, value] : row)
      if(value != 0)
        first = (std::min)(first, place_[i]);
    return first;
  }

  static void subtract_multiple(Row& row, Index pivot, const Row& pivot_row)
  {
    const Integer factor = row.at(pivot) * pivot_row.at(pivot);
    for(const auto& [i, value] : pivot_row)
      row[i] -= factor * value;
  }

  const std::vector<Crossing_loop>& tunnels_;
  const Crossing_index& handle_index_;
  const Crossing_index& tunnel_index_;
  std::vector<Sparse_numbers> crossed_handles_;  // t_i . h_j by i
  std::vector<Sparse_numbers> crossing_tunnels_; // t_i . h_j by j
  std::vector<std::pair<Index, Row>> accepted_;
  std::vector<std::size_t> place_; // in `accepted_`, by handle; their number if not accepted
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFINEMENT_CHOICE_H
