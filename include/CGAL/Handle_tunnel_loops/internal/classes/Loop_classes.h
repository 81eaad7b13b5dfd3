// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_LOOP_CLASSES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_LOOP_CLASSES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Unimodular_system.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_index.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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
  Loop_classes(const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops)
      : index_(mesh, loops) {
    for(const Crossing_loop& loop : loops)
      rows_.push_back(numbers(loop));
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
  const Crossing_index& index() const { return index_; }

  /// the intersection numbers of a curve with the basis.
  Class_vector numbers(const Crossing_loop& loop) const {
    const Sparse_numbers numbers = index_.intersections(loop);
    return Class_vector(numbers.begin(), numbers.end());
  }

  /// the intersection numbers of loop `i` of the basis with the basis.
  const Class_vector& row(Index i) const { return rows_[i]; }

  /// those of the class with these coordinates.
  Class_vector numbers_of_class(const Class_vector& a) const {
    Class_vector numbers;
    for(const auto& [i, factor] : a)
      for(const auto& [j, value] : rows_[i])
        numbers.emplace_back(j, factor * value);
    normalize(numbers);
    return numbers;
  }

  /// the coordinates of the class with these intersection numbers, unless they are too large.
  std::optional<Class_vector> class_with(const Class_vector& numbers) const {
    return system_->solve(numbers);
  }

private:
  Crossing_index index_;
  std::vector<Class_vector> rows_;
  std::unique_ptr<Unimodular_system> system_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_LOOP_CLASSES_H
