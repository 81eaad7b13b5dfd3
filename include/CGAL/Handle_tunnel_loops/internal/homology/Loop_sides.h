// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LOOP_SIDES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LOOP_SIDES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Unimodular_system.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sparse_sum.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
On which sides the loops of a basis bound, each component for itself, and the projections to the
classes that do.

On a component that does not cross itself, L_in and L_out are the classes that bound inside and
outside; H1 is their direct sum, and each is its own annihilator under the intersection form J. A
class x of L_in has V(x, .) = 0 and one of L_out V(., x) = 0. Hence V(x, y) is, up to one sign, the
intersection number of the part of x in L_out with y, and also of x with the part of y in L_in:
the linking numbers *are* the intersection numbers of the projections with the basis.
*/
class Loop_sides
{
public:
  /// \p relations are those of the basis.
  Loop_sides(std::shared_ptr<const Loop_classes> classes, const Loop_relations& relations)
      : Loop_sides(std::move(classes)) {
    for(const Matrix_entry& e : relations.linking)
      if(relations.components[e.row] == relations.components[e.column]) {
        rows_[e.row].emplace_back(e.column, e.value);
        columns_[e.column].emplace_back(e.row, e.value);
      }
    for(auto* matrix : {&rows_, &columns_})
      for(Class_vector& v : *matrix)
        normalize(v);
    find_signs(relations);
  }

  /// those of the loops of another basis, with \p coordinates in this one, for linking numbers are
  /// bilinear; nothing if a number became too large.
  std::optional<Loop_sides> of_basis(const std::vector<Class_vector>& coordinates,
                                     std::shared_ptr<const Loop_classes> classes) const {
    Loop_sides sides(std::move(classes));
    sides.signs_ = signs_;
    std::vector<Class_vector> loops_with(coordinates.size()); // by loop of this basis
    for(Index i = 0; i < coordinates.size(); ++i)
      for(const auto& [k, factor] : coordinates[i])
        loops_with[k].emplace_back(i, factor);
    Sparse_sum<std::int64_t> sum;
    for(Index i = 0; i < coordinates.size(); ++i) {
      const Class_vector row = sum_of_multiples(coordinates[i], rows_, sum);
      const Class_vector skew = scaled(sides.classes_->row(i), signs_[i]);
      if(!row.empty())
        sides.rows_[i] = sum_of_multiples(coordinates[i], columns_, sum).empty()
                             ? skew
                             : sum_of_multiples(row, loops_with, sum);
      sides.columns_[i] = sides.rows_[i];
      const bool fits =
          std::none_of(sides.rows_[i].begin(), sides.rows_[i].end(),
                       [](const auto& number) { return is_too_large(number.second); });
      if(!fits || !add_multiple(sides.columns_[i], -1, skew))
        return std::nullopt;
    }
    return sides;
  }

  const Loop_classes& classes() const { return *classes_; }

  /// whether it is known for the component of a loop which classes bound inside and outside.
  bool is_decided(Index i) const { return signs_[i] != 0; }

  bool is_any_decided() const {
    return std::any_of(signs_.begin(), signs_.end(), [](int sign) { return sign != 0; });
  }

  bool bounds_inside(Index i) const { return is_decided(i) && rows_[i].empty(); }
  bool bounds_outside(Index i) const { return is_decided(i) && columns_[i].empty(); }

  /// the intersection numbers with the basis of the part of a loop in L_in (`true`) or L_out.
  Class_vector numbers_of_part(Index i, bool inside) const {
    return scaled(inside ? columns_[i] : rows_[i], inside ? -signs_[i] : signs_[i]);
  }

private:
  explicit Loop_sides(std::shared_ptr<const Loop_classes> classes)
      : classes_(std::move(classes))
      , rows_(classes_->size())
      , columns_(classes_->size())
      , signs_(classes_->size(), 0) {}

  // V less its transpose is J or -J on a component. If it is neither, the surface crosses itself.
  void find_signs(const Loop_relations& relations) {
    std::map<std::size_t, int> sign_of_component;
    std::set<std::size_t> bad_components;
    for(const auto& problem : relations.problems)
      bad_components.insert(relations.components[problem.first]);
    for(Index i = 0; i < classes_->size(); ++i) {
      Class_vector skew = rows_[i];
      const bool fits = add_multiple(skew, -1, columns_[i]);
      const std::size_t component = relations.components[i];
      const int sign =
          sign_of_component.emplace(component, skew == classes_->row(i) ? 1 : -1).first->second;
      if(!fits || skew != scaled(classes_->row(i), sign))
        bad_components.insert(component);
    }
    for(Index i = 0; i < classes_->size(); ++i) {
      const std::size_t component = relations.components[i];
      signs_[i] = bad_components.count(component) != 0 ? 0 : sign_of_component.at(component);
    }
  }

  static Class_vector scaled(Class_vector v, int factor) {
    for(auto& entry : v)
      entry.second *= factor;
    return v;
  }

  std::shared_ptr<const Loop_classes> classes_;
  std::vector<Class_vector> rows_, columns_; // of V, within the components
  std::vector<int> signs_;                   // by loop; 0 if nothing is known
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_LOOP_SIDES_H
