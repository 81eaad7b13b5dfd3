// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LOOP_CLASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LOOP_CLASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Unimodular_system.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Edge_crossings.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sparse_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The classes of closed curves, as coordinates in a basis of loops.

The intersection numbers of a curve with the basis are a J, where a are its coordinates and J the
matrix of the intersection numbers of the basis, which is unimodular (Poincare duality). So
coordinates follow from numbers by one solution of a system of equations. All in integers.
*/
class Loop_classes
{
public:
  /// \p loops are a basis.
  Loop_classes(Execution execution, const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops)
      : crossings_(
            std::make_shared<const Edge_crossings>(execution, mesh, Crossing_index(mesh, loops)))
      , sums_([] { return std::make_unique<Sparse_sum<std::int64_t>>(); })
      , rows_(loops.size()) {
    for_each_index(
        execution, loops.size(), [&](std::size_t i) { rows_[i] = numbers(loops[i]); }, 16);
    // The rows of the transpose of J, which is -J.
    std::vector<Class_vector> transposed = rows_;
    for(Class_vector& row : transposed)
      for(auto& entry : row)
        entry.second = -entry.second;
    system_ = std::make_unique<Unimodular_system>(std::move(transposed));
    CGAL_postcondition_msg(system_->is_regular(), "the loops are a basis");
  }

  std::size_t size() const { return rows_.size(); }

  /// which loops of the basis cross which edges.
  const std::shared_ptr<const Edge_crossings>& edge_crossings() const { return crossings_; }

  /// the intersection numbers of a curve with the basis.
  Class_vector numbers(const Crossing_loop& loop) const {
    return crossings_->numbers(loop, *sums_.borrow());
  }

  /// the intersection numbers of loop `i` of the basis with the basis.
  const Class_vector& row(Index i) const { return rows_[i]; }

  /// those of the class with these coordinates.
  Class_vector numbers_of_class(const Class_vector& a) const {
    return sum_of_multiples(a, rows_, *sums_.borrow());
  }

  /// the coordinates of the class with these intersection numbers, unless they are too large.
  std::optional<Class_vector> class_with(const Class_vector& numbers) const {
    return system_->solve(numbers);
  }

  /// calls `f(i, coordinate)` for the coordinates modulo a large prime, if they may be large.
  template <typename Function>
  void for_each_coordinate(const Class_vector& numbers, const Function& f) const {
    system_->solve_modulo(numbers, [&](Index i, Residue x) { f(i, smallest_integer_of(x)); });
  }

private:
  std::shared_ptr<const Edge_crossings> crossings_;
  mutable Workspace_pool<Sparse_sum<std::int64_t>> sums_;
  std::vector<Class_vector> rows_;
  std::unique_ptr<Unimodular_system> system_;
};

/// A matching between as many rows as columns, by augmenting paths: what is matched stays matched,
/// with others if need be.
class Pairing
{
public:
  explicit Pairing(std::size_t n)
      : column_of_(n, no_index)
      , row_of_(n, no_index) {}

  Index column_of(Index row) const { return column_of_[row]; }
  Index row_of(Index column) const { return row_of_[column]; }

  void match(Index row, Index column) {
    column_of_[row] = column;
    row_of_[column] = row;
  }

  void release(Index row) {
    if(column_of_[row] != no_index)
      row_of_[column_of_[row]] = no_index;
    column_of_[row] = no_index;
  }

  /// matches a row that is not. \p columns gives the columns that a row may be matched with, the
  /// preferred ones first. Returns `false`, and changes nothing, if there is no way.
  template <typename Columns> bool augment(Index row, const Columns& columns) {
    std::vector<char> is_tried(column_of_.size(), 0);
    return augment(row, columns, is_tried);
  }

private:
  template <typename Columns>
  bool augment(Index row, const Columns& columns, std::vector<char>& is_tried) {
    const std::vector<Index> candidates = columns(row);
    for(Index c : candidates)
      if(row_of_[c] == no_index) {
        match(row, c);
        return true;
      }
    for(Index c : candidates)
      if(!is_tried[c]) {
        is_tried[c] = 1;
        if(augment(row_of_[c], columns, is_tried)) {
          match(row, c);
          return true;
        }
      }
    return false;
  }

  std::vector<Index> column_of_, row_of_;
};

/// pairs the loops of a basis so that each pair crosses once, if that can be, or else an odd number
/// of times, which always can: a skew-symmetric matrix of determinant 1 has an odd Pfaffian, and
/// that is a sum over matchings.
inline void match_loops(Execution execution, const Flat_mesh& mesh, std::vector<Flat_pair>& pairs) {
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
  std::vector<Crossing_loop> loops;
  for(Flat_pair& pair : pairs) {
    loops.push_back(std::move(pair.handle));
    loops.push_back(std::move(pair.tunnel));
  }
  const Loop_classes classes(execution, mesh, loops);
  for(const bool once : {true, false}) {
    Graph graph(loops.size());
    for(Index i = 0; i < loops.size(); ++i)
      for(const auto& [j, number] : classes.row(i))
        if(i < j && (once ? number == 1 || number == -1 : number % 2 != 0))
          add_edge(i, j, graph);
    std::vector<Graph::vertex_descriptor> mates(loops.size());
    boost::edmonds_maximum_cardinality_matching(graph, mates.data());
    if(2 * boost::matching_size(graph, mates.data()) < loops.size())
      continue;
    pairs.clear();
    for(std::size_t i = 0; i < mates.size(); ++i)
      if(i < mates[i])
        pairs.push_back({std::move(loops[i]), std::move(loops[mates[i]])});
    return;
  }
  CGAL_assertion_msg(false, "the loops are a basis");
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LOOP_CLASSES_H
