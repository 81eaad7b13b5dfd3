// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SURFACE_CURVES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SURFACE_CURVES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sparse_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

struct Matrix_entry
{
  Index row, column;
  std::int64_t value;

  bool is_beside(const Matrix_entry& e) const { return row == e.row && column == e.column; }
  bool operator<(const Matrix_entry& e) const {
    return row != e.row ? row < e.row : column < e.column;
  }
};

/// An integer matrix: its entries by row and, within a row, by column; no zeros.
using Sparse_matrix = std::vector<Matrix_entry>;

/// sorts entries, adds up those at the same place, and leaves out zeros.
inline void add_up(Execution execution, std::vector<Matrix_entry>& entries) {
  sort(execution, entries.begin(), entries.end(), std::less<>());
  std::size_t kept = 0;
  for(std::size_t i = 0; i < entries.size();) {
    Matrix_entry sum = entries[i];
    for(++i; i < entries.size() && entries[i].is_beside(sum); ++i)
      sum.value += entries[i].value;
    if(sum.value != 0)
      entries[kept++] = sum;
  }
  entries.resize(kept);
}

/// the product of two matrices, without adding up what is nowhere kept: of the first by its
/// entries, with rows together, of the second by `row(i)`. \p is_kept tells of which rows and
/// columns it is asked for. Each entry of the first takes as long as the row that it is multiplied
/// with.
template <typename Row, typename Is_kept>
Sparse_matrix product(const Sparse_matrix& matrix, const Row& row, const Is_kept& is_kept) {
  Sparse_matrix result;
  Sparse_sum<std::int64_t> sum;
  for(std::size_t i = 0; i < matrix.size(); ++i) {
    for(const Matrix_entry& e : row(matrix[i].column))
      sum.add(e.column, matrix[i].value * e.value);
    if(i + 1 == matrix.size() || matrix[i + 1].row != matrix[i].row)
      sum.take([&](Index column, std::int64_t value) {
        if(is_kept(matrix[i].row, column))
          result.push_back({matrix[i].row, column, value});
      });
  }
  return result;
}

/// whether a matrix is its transpose with the other sign. Logarithmic time for each entry.
inline bool is_antisymmetric(const Sparse_matrix& matrix) {
  CGAL_precondition(std::is_sorted(matrix.begin(), matrix.end()));
  return std::all_of(matrix.begin(), matrix.end(), [&](const Matrix_entry& e) {
    const Matrix_entry transposed = {e.column, e.row, -e.value};
    const auto it = std::lower_bound(matrix.begin(), matrix.end(), transposed);
    return it != matrix.end() && it->is_beside(transposed) && it->value == transposed.value;
  });
}

/// A line of a copy and an edge of a walk that meet although they should be apart; or, where the
/// edge is one that the copy crosses, two faces that lie on each other.
struct Contact
{
  static constexpr std::size_t no_corner = static_cast<std::size_t>(-1);
  std::size_t corner, edge;

  bool operator<(const Contact& c) const {
    return edge != c.edge ? edge < c.edge : corner < c.corner;
  }
};

/// What `Linking_numbers` finds.
struct Linking
{
  /// how often loop i crosses loop j from right to left, less the other way.
  Sparse_matrix intersections;

  /// V, see `Linking_numbers`.
  Sparse_matrix linking;

  /// V less its transpose less the intersection matrix (with the sign of the side to which the
  /// faces look). It is empty unless the surface touches itself, or crosses itself near loops; then
  /// the numbers of these loops mean nothing.
  Sparse_matrix defect;

  /// where the surface touches itself. The numbers of the loops that pass there mean nothing.
  std::vector<Contact> contacts;

  /// whether there are so many contacts that the search for them was given up, as on a surface that
  /// is a point. Then no number means anything.
  bool has_too_many_contacts = false;
};

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

  /// takes in loops in the place of others: number i is what had number `before[i]`, or is new if
  /// that is `no_index`. \p other has the relations of some loops, which are called `numbers` here:
  /// of those that are new, and of all that these have anything to do with.
  void take_in(const std::vector<Index>& before,
               const Loop_relations& other,
               const std::vector<Index>& numbers) {
    const std::vector<std::size_t> components_before = std::move(components);
    const std::vector<int> outward_before = std::move(outward);
    std::vector<Index> now(components_before.size(), no_index);
    components.assign(before.size(), 0);
    outward.assign(before.size(), 0);
    for(Index i = 0; i < before.size(); ++i)
      if(before[i] != no_index) {
        now[before[i]] = i;
        components[i] = components_before[before[i]];
        outward[i] = outward_before[before[i]];
      }
    for(std::size_t i = 0; i < numbers.size(); ++i) {
      components[numbers[i]] = other.components[i];
      outward[numbers[i]] = other.outward[i];
    }
    const auto merge = [&](Sparse_matrix& matrix, const Sparse_matrix& of_others) {
      Sparse_matrix all;
      for(const Matrix_entry& e : matrix)
        if(now[e.row] != no_index && now[e.column] != no_index)
          all.push_back({now[e.row], now[e.column], e.value});
      for(const Matrix_entry& e : of_others)
        if(before[numbers[e.row]] == no_index || before[numbers[e.column]] == no_index)
          all.push_back({numbers[e.row], numbers[e.column], e.value});
      std::sort(all.begin(), all.end());
      matrix = std::move(all);
    };
    merge(intersections, other.intersections);
    merge(linking, other.linking);
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

/// Relations of loops of which some have been replaced since.
struct Known_relations
{
  Loop_relations& relations;
  const std::vector<Index>& before; ///< by loop, the number that it had then, or `no_index`
};

/// Integer multiples of numbered elements, one chain for each of a family of loops, kept by
/// element.
class Chains
{
public:
  void add(Index element, Index loop, std::int64_t value) {
    terms_.push_back({element, loop, value});
  }

  /// adds up what was added to one element for one loop. To be called once, after the last `add()`.
  void finish(Execution execution, std::size_t number_of_elements) {
    add_up(execution, terms_);
    begin_.assign(number_of_elements + 1, 0);
    for(const Matrix_entry& term : terms_)
      ++begin_[term.row + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  }

  /// the terms of an element, in the order of the loops, which are their columns.
  Span<const Matrix_entry> of(std::size_t element) const {
    CGAL_precondition_msg(element + 1 < begin_.size(), "after `finish()`");
    return {terms_.data() + begin_[element], begin_[element + 1] - begin_[element]};
  }

private:
  Sparse_matrix terms_;
  std::vector<std::size_t> begin_; // by element
};

/*!
A family of loops on a surface, each as two homologous curves in general position to those of the
others: a walk along the edges, and a copy beside it that runs from midpoint to midpoint of the
edges, across the corners of the faces. A walk and a copy meet at midpoints only, where the copy
crosses the walk.
*/
struct Surface_curves
{
  /// An edge of the walks, with the third vertices of the faces to its left and right.
  struct Edge
  {
    Index source, target, left, right;
  };

  /// A line across a face, from the midpoint of the edge `apex` - `from` to that of `apex` - `to`,
  /// along which the copy of a loop runs.
  struct Corner
  {
    Index apex, from, to, loop;
  };

  std::vector<Vector> vertices;
  std::array<double, 2> tilts = {1., 1.}; ///< how far along x and y a view along z may be inclined
  std::vector<Index> originals;           ///< by vertex, its index in the mesh
  std::vector<Edge> edges;
  std::vector<Corner> corners;
  Chains walks;             ///< by edge: how often each loop's walk runs along it
  Chains crossings;         ///< by edge: how often each loop's copy crosses it from right to left
  std::vector<int> outward; ///< by loop: 1 if the faces beside it look out of the solid, or -1

  /// by loop, whether its linking numbers with all others are asked for; empty if those of all are.
  std::vector<char> is_asked_for;

  /// calls `f(loop)` for each loop whose walk or copy is at a contact.
  template <typename Function>
  void for_each_loop_at(const Contact& contact, const Function& f) const {
    for(const Matrix_entry& walk : walks.of(contact.edge))
      f(walk.column);
    if(contact.corner != Contact::no_corner)
      f(corners[contact.corner].loop);
    else
      for(const Matrix_entry& copy : crossings.of(contact.edge))
        f(copy.column);
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SURFACE_CURVES_H
